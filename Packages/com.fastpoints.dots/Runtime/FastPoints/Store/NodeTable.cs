using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Store
{
    /// <summary>The nodes of one page of a hierarchy, with the locations of their planes. Owns its memory.</summary>
    public sealed unsafe class NodeTable : IDisposable
    {
        NativeArray<byte> m_bytes;
        NativeArray<PlaneRange> m_planes;
        readonly PageView m_view;

        // Takes over the bytes of a page without problems.
        internal NodeTable(NativeArray<byte> bytes)
        {
            m_bytes = bytes;
            m_view = PageView.Of(bytes);
            m_planes = new NativeArray<PlaneRange>(m_view.NodeCount * PlaneCount, Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            for (int i = 0; i < m_planes.Length; i++)
                m_planes[i] = m_view.Ranges[i].Range;
        }

        public int PlaneCount => m_view.Header.PlaneCount;
        public NativeArray<NodeRecord> Nodes =>
            Part<NodeRecord>(m_view.Header.NodesOffset, (long)m_view.NodeCount * NodeRecord.SizeBytes);

        /// <summary>By node times PlaneCount, plus plane. Those of an inlined leaf are empty: its parent's apply.</summary>
        public NativeArray<PlaneRange> PlaneRanges => m_planes;

        internal NativeArray<PageLink> Links =>
            Part<PageLink>(m_view.Header.LinksOffset, (long)m_view.Header.LinkCount * PageLink.SizeBytes);

        internal PageView View => m_view;

        public void Dispose()
        {
            if (!m_bytes.IsCreated)
                return;
            m_bytes.Dispose();
            m_planes.Dispose();
        }

        // What is wrong with a page, or null: to be checked before it is used. On any thread.
        internal static string FindProblem(NativeArray<byte> bytes, in PageLink link, in CloudLocalSpace grid, StoreLayout layout)
        {
            using var shapes = layout.CreateShapes(Allocator.Persistent);
            var check = new TableCheck(bytes, link, grid, (PlaneShape*)shapes.GetUnsafeReadOnlyPtr(), shapes.Length,
                layout.ComputedPlaneCount);
            var problem = check.FindProblem();
            return problem.IsNone ? null : Describe(problem, check);
        }

        // Describes what check found; its memory must still exist.
        internal static string Describe(TableProblem problem, in TableCheck check)
        {
            return problem.Fault switch
            {
                TableFault.Hash => "the node table is damaged: " + StoreFile.HashProblem((ulong)problem.Wanted,
                    (ulong)problem.Got),
                TableFault.Head => "is no page of " + problem.Wanted + " bytes of this cloud",
                TableFault.Roots => "wanted " + (check.IsRoot ? "one node" : "nodes") +
                    " without a parent at the table's start, got " + problem.Got,
                TableFault.Orphans => "nodes " + problem.Node + " and on are no node's children",
                TableFault.Link => "link " + problem.Node + " is not one of its nodes', or leads nowhere",
                TableFault.PointSum => "wanted " + problem.Wanted + " points in all nodes, got " + problem.Got,
                TableFault.NodeSum => "wanted " + problem.Wanted + " nodes, got " + problem.Got,
                _ => "node " + problem.Node + ": " + DescribeNode(problem, check, check.Page.Nodes[problem.Node]),
            };
        }

        static string DescribeNode(TableProblem problem, in TableCheck check, NodeRecord node)
        {
            var range = problem.Fault == TableFault.Plane ? check.Page.RangeOf(problem.Node, (int)problem.Got) : default;
            return problem.Fault switch
            {
                TableFault.Side => "side 2^" + node.SideLog2 + " with cells of 2^" + node.CellLog2,
                TableFault.OutsideRegion => "cube " + node.Cube + " outside of " + check.Link.Cube,
                TableFault.NotOfOctree => "cube " + node.Cube + " is not of the octree of " + check.Link.Cube,
                TableFault.Parent => "parent " + node.Parent,
                TableFault.ParentCube => "cube " + node.Cube + " in a parent of " + check.Page.Nodes[node.Parent].Cube,
                TableFault.NotAChild => "is none of its parent's children",
                TableFault.Children => "children " + node.FirstChild + " to " + ((long)node.FirstChild + node.ChildCount),
                TableFault.Links => "links " + node.FirstLink + " to " + ((long)node.FirstLink + node.LinkCount),
                TableFault.PointCount => "wanted 1 to " + StoreFormat.MaxPointsPerNode + " points, got " + node.PointCount,
                TableFault.BlockCount => "wanted " + PlaneShape.BlocksOf(node.PointCount) + " blocks, got " + node.BlockCount,
                TableFault.Bounds => "bounds are turned round",
                TableFault.InlinedLeaf => "is no guest of node " + node.PlaneNode,
                TableFault.FirstBlock => "its own blocks begin at " + node.FirstBlock,
                TableFault.InlinedBlocks => "is a guest: wanted blocks from " + problem.Wanted + ", got " + problem.Got,
                TableFault.PlaneBlocks => "wanted " + problem.Wanted + " hosted blocks, got " + problem.Got,
                TableFault.InlinedPlane => "a guest with a plane of its own",
                _ => "plane " + problem.Got + ": " + range.LengthBytes + " bytes from " + range.OffsetBytes +
                    " in a file of " + problem.Wanted,
            };
        }

        NativeArray<T> Part<T>(long offset, long bytes) where T : unmanaged =>
            m_bytes.GetSubArray((int)offset, (int)bytes).Reinterpret<T>(1);
    }
}
