using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Store
{
    /// <summary>The nodes of one file with the locations of their planes, as they lie in its table. Owns its memory.</summary>
    public sealed class NodeTable : IDisposable
    {
        NativeArray<NodeRecord> m_nodes;
        NativeArray<PlaneRange> m_planes;

        public NodeTable(NativeArray<NodeRecord> nodes, NativeArray<PlaneRange> planes, int planeCount) =>
            (m_nodes, m_planes, PlaneCount) = (nodes, planes, planeCount);

        public int PlaneCount { get; }
        public NativeArray<NodeRecord> Nodes => m_nodes;

        /// <summary>By node times PlaneCount, plus plane. Those of an inlined leaf are empty: its parent's apply.</summary>
        public NativeArray<PlaneRange> Planes => m_planes;

        internal unsafe TableCheck View => new TableCheck
        {
            Nodes = (NodeRecord*)m_nodes.GetUnsafeReadOnlyPtr(),
            Planes = (PlaneRange*)m_planes.GetUnsafeReadOnlyPtr(),
            NodeCount = m_nodes.Length,
            PlaneCount = PlaneCount,
        };

        public void Dispose()
        {
            if (!m_nodes.IsCreated)
                return;
            m_nodes.Dispose();
            m_planes.Dispose();
        }

        /// <summary>What is wrong with the table, or null: check this before using it. On any thread.</summary>
        public unsafe string FindProblem(GridCube region, long dataBytes, StoreLayout layout, bool isChunk)
        {
            using var shapes = layout.CreateShapes(Allocator.Persistent);
            var check = View;
            check.Shapes = (PlaneShape*)shapes.GetUnsafeReadOnlyPtr();
            check.Region = region;
            check.DataBytes = dataBytes;
            check.IsChunk = isChunk;
            var problem = check.FindProblem();
            return problem.IsNone ? null : Describe(problem, check);
        }

        // Describes what check found; its memory must still exist.
        internal static unsafe string Describe(TableProblem problem, in TableCheck check)
        {
            return problem.Fault switch
            {
                TableFault.Hash => "the node table is damaged: " + StoreFile.HashProblem((ulong)problem.Wanted,
                    (ulong)problem.Got),
                TableFault.Roots => "wanted " + (check.IsChunk ? "nodes" : "one node") +
                    " without a parent at the table's start, got " + problem.Got,
                TableFault.Orphans => "nodes " + problem.Node + " and on are no node's children",
                TableFault.PointSum => "wanted " + problem.Wanted + " points in all nodes, got " + problem.Got,
                _ => "node " + problem.Node + ": " + DescribeNode(problem, check, check.Nodes[problem.Node]),
            };
        }

        static unsafe string DescribeNode(TableProblem problem, in TableCheck check, NodeRecord node)
        {
            var range = problem.Fault == TableFault.Plane
                ? check.Planes[(long)problem.Node * check.PlaneCount + problem.Got] : default;
            return problem.Fault switch
            {
                TableFault.Side => "side 2^" + node.SideLog2 + " with cells of 2^" + node.CellLog2,
                TableFault.OutsideRegion => "cube " + node.Cube + " outside of " + check.Region,
                TableFault.NotOfOctree => "cube " + node.Cube + " is not of the octree of " + check.Region,
                TableFault.Parent => "parent " + node.Parent,
                TableFault.ParentCube => "cube " + node.Cube + " in a parent of " + check.Nodes[node.Parent].Cube,
                TableFault.NotAChild => "is none of its parent's children",
                TableFault.Children => "children " + node.FirstChild + " to " + ((long)node.FirstChild + node.ChildCount),
                TableFault.PointCount => "wanted 1 to " + StoreFormat.MaxPointsPerNode + " points, got " + node.PointCount,
                TableFault.BlockCount => "wanted " + PlaneShape.BlocksOf(node.PointCount) + " blocks, got " + node.BlockCount,
                TableFault.Bounds => "bounds are turned round",
                TableFault.InlinedLeaf => "is no guest of node " + node.PlaneNode,
                TableFault.FirstBlock => "its own blocks begin at " + node.FirstBlock,
                TableFault.InlinedBlocks => "is a guest: wanted blocks from " + problem.Wanted + ", got " + problem.Got,
                TableFault.PlaneBlocks => "wanted " + problem.Wanted + " hosted blocks, got " + problem.Got,
                TableFault.InlinedPlane => "a guest with a plane of its own",
                _ => "plane " + problem.Got + ": " + range.LengthBytes + " bytes from " + range.OffsetBytes +
                    " in a file with room to " + check.DataBytes,
            };
        }
    }
}
