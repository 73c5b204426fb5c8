using System;
using FastPoints.Core;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Store
{
    /// <summary>The nodes of one file with the locations of their planes, as they lie in its table. Owns its memory.</summary>
    public sealed class NodeTable : IDisposable
    {
        NativeArray<NodeRecord> m_nodes;
        NativeArray<PlaneRange> m_planes;

        public NodeTable(NativeArray<NodeRecord> nodes, NativeArray<PlaneRange> planes, int planeCount)
        {
            m_nodes = nodes;
            m_planes = planes;
            PlaneCount = planeCount;
        }

        public int PlaneCount { get; }
        public NativeArray<NodeRecord> Nodes => m_nodes;

        /// <summary>Indexed by node times <see cref="PlaneCount"/>, plus plane. A inlined leaf's ranges are empty: its parent's
        /// apply.</summary>
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

        /// <summary>Describes what is wrong with the table, or returns null; check this before using anything that the table
        /// says. See <see cref="TableCheck"/>. Works on any thread.</summary>
        public unsafe string FindProblem(GridCube region, long dataBytes, StoreLayout layout, bool isChunk)
        {
            using var shapes = layout.CreateShapes(Allocator.Persistent);
            var check = View;
            check.Shapes = (PlaneShape*)shapes.GetUnsafeReadOnlyPtr();
            check.Region = region;
            check.DataBytes = dataBytes;
            check.IsChunk = isChunk;
            var problem = check.Find();
            return problem.IsNone ? null : Describe(problem, check);
        }

        // Of what check found; its memory must still exist.
        internal static unsafe string Describe(TableProblem problem, in TableCheck check)
        {
            switch (problem.Fault)
            {
                case TableFault.Hash:
                    return "the node table is damaged: its hash does not fit";
                case TableFault.Roots:
                    return "wanted " + (check.IsChunk ? "nodes" : "one node") +
                        " without a parent at the table's start, got " + problem.Got;
                case TableFault.Orphans:
                    return "nodes " + problem.Node + " and on are no node's children";
                case TableFault.PointSum:
                    return "wanted " + problem.Wanted + " points in all nodes, got " + problem.Got;
            }
            var node = check.Nodes[problem.Node];
            string what = "node " + problem.Node + ": ";
            switch (problem.Fault)
            {
                case TableFault.Side:
                    return what + "side 2^" + node.SideLog2 + " with cells of 2^" + node.CellLog2;
                case TableFault.OutsideRegion:
                    return what + "cube " + node.Cube + " outside of " + check.Region;
                case TableFault.NotOfOctree:
                    return what + "cube " + node.Cube + " is not of the octree of " + check.Region;
                case TableFault.Parent:
                    return what + "parent " + node.Parent;
                case TableFault.ParentCube:
                    return what + "cube " + node.Cube + " in a parent of " + check.Nodes[node.Parent].Cube;
                case TableFault.NotAChild:
                    return what + "is none of its parent's children";
                case TableFault.Children:
                    return what + "children " + node.FirstChild + " to " + ((long)node.FirstChild + node.ChildCount);
                case TableFault.PointCount:
                    return what + "wanted 1 to " + StoreFormat.MaxPointsPerNode + " points, got " + node.PointCount;
                case TableFault.BlockCount:
                    return what + "wanted " + PlaneShape.BlocksOf(node.PointCount) + " blocks, got " + node.BlockCount;
                case TableFault.Bounds:
                    return what + "bounds are turned round";
                case TableFault.InlinedLeaf:
                    return what + "is no guest of node " + node.PlaneNode;
                case TableFault.FirstBlock:
                    return what + "its own blocks begin at " + node.FirstBlock;
                case TableFault.InlinedBlocks:
                    return what + "is a guest: wanted blocks from " + problem.Wanted + ", got " + problem.Got;
                case TableFault.PlaneBlocks:
                    return what + "wanted " + problem.Wanted + " hosted blocks, got " + problem.Got;
                case TableFault.InlinedPlane:
                    return what + "a guest with a plane of its own";
                default:
                    var range = check.Planes[(long)problem.Node * check.PlaneCount + problem.Got];
                    return what + "plane " + problem.Got + ": " + range.LengthBytes + " bytes from " + range.OffsetBytes +
                        " in a file with room to " + check.DataBytes;
            }
        }
    }
}
