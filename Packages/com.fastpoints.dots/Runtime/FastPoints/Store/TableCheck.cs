using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Store
{
    // Whether a page is consistent, before anything in it is used. Reads memory alone: for jobs as well.
    internal unsafe struct TableCheck
    {
        public PageView Page;
        public PageLink Link; // The page above wants it to be so.
        public bool IsRoot; // One node has no parent; elsewhere several may have none.
        readonly long m_bytes;
        readonly ulong m_cloudId;
        readonly PlaneShape* m_shapes; // The position's is that of nodes that are not wide.
        readonly int m_planeCount;
        readonly int m_computedPlanes; // At the end.
        PageHeader m_header;

        public TableCheck(NativeArray<byte> bytes, in PageLink link, in CloudLocalSpace grid, PlaneShape* shapes, int planeCount,
            int computedPlanes = 0)
        {
            Page = PageView.Of(bytes);
            Link = link;
            IsRoot = link.AttachNode < 0;
            m_bytes = bytes.Length;
            m_cloudId = grid.CloudId;
            m_shapes = shapes;
            m_planeCount = planeCount;
            m_computedPlanes = computedPlanes;
            m_header = default;
        }

        public TableProblem FindProblem()
        {
            ulong hash = ContentHash.Of(Page.Bytes, m_bytes);
            if (hash != Link.Hash)
                return new TableProblem(TableFault.Hash, 0, (long)Link.Hash, (long)hash);
            if (!HasHead())
                return new TableProblem(TableFault.Head, 0, m_bytes);
            long nextChild = 0;
            while (nextChild < m_header.NodeCount && Page.Nodes[nextChild].Parent == -1)
                nextChild++;
            if (m_header.NodeCount > 0 && (nextChild == 0 || (IsRoot && nextChild != 1)))
                return new TableProblem(TableFault.Roots, 0, 1, nextChild);
            long nextLink = 0;
            for (int i = 0; i < m_header.NodeCount; i++)
            {
                var problem = FindInTree(i, ref nextChild, ref nextLink);
                if (problem.IsNone)
                    problem = FindInPlaneNode(i);
                if (problem.IsNone)
                    problem = FindInPlanes(i);
                if (!problem.IsNone)
                    return problem;
            }
            if (nextChild != m_header.NodeCount)
                return new TableProblem(TableFault.Orphans, (int)nextChild);
            return nextLink == m_header.LinkCount ? FindInSums() : new TableProblem(TableFault.Link, (int)nextLink);
        }

        bool HasHead()
        {
            if (m_bytes < PageHeader.SizeBytes)
                return false;
            m_header = Page.Header;
            if (m_header.Magic != StoreFormat.PageMagic || m_header.Version != StoreFormat.Version ||
                m_header.CloudId != m_cloudId || m_header.PlaneCount != m_planeCount || m_header.NodeCount < 0 ||
                m_header.LinkCount < 0 || m_header.ContainerCount < 0 || m_header.LengthBytes != m_bytes)
                return false;
            for (int p = 0; p < m_planeCount; p++)
                // Readers take all planes that a cloud was built with from one container, and the computed from another.
                if (Page.ContainerOfPlane[p] < 0 || Page.ContainerOfPlane[p] >= m_header.ContainerCount ||
                    p < m_planeCount - m_computedPlanes && Page.ContainerOfPlane[p] != Page.ContainerOfPlane[0])
                    return m_header.NodeCount == 0;
            for (int c = 0; c < m_header.ContainerCount; c++)
                if (Page.Containers[c].SideLog2 < 0 || Page.Containers[c].SideLog2 > GridCube.MaxSideLog2 ||
                    Page.Containers[c].FileBytes < 0 || Page.Containers[c].Kind > ContainerKind.Hierarchy)
                    return false;
            return true;
        }

        TableProblem FindInTree(int index, ref long nextChild, ref long nextLink)
        {
            var nodes = Page.Nodes;
            var node = nodes[index];
            if (node.SideLog2 > GridCube.MaxSideLog2 || node.CellLog2 > node.SideLog2)
                return new TableProblem(TableFault.Side, index);
            if (!Link.Cube.ContainsAligned(node.Cube))
                return new TableProblem(TableFault.OutsideRegion, index);
            if (!IsOfOctree(node.Cube))
                return new TableProblem(TableFault.NotOfOctree, index);
            if (node.Parent >= index || node.Parent < -1)
                return new TableProblem(TableFault.Parent, index);
            if (node.Parent >= 0)
            {
                var parent = nodes[node.Parent];
                if (!parent.Cube.ContainsAligned(node.Cube) || (parent.SideLog2 == node.SideLog2 && node.SideLog2 != 0))
                    return new TableProblem(TableFault.ParentCube, index);
                if (index < parent.FirstChild || index >= (long)parent.FirstChild + parent.ChildCount)
                    return new TableProblem(TableFault.NotAChild, index);
            }
            if (node.ChildCount < 0 || (node.ChildCount > 0 && node.FirstChild != nextChild) ||
                node.ChildCount > m_header.NodeCount - nextChild)
                return new TableProblem(TableFault.Children, index);
            nextChild += node.ChildCount;
            if (node.LinkCount < 0 || (node.LinkCount > 0 && node.FirstLink != nextLink) ||
                node.LinkCount > m_header.LinkCount - nextLink)
                return new TableProblem(TableFault.Links, index);
            for (long end = nextLink + node.LinkCount; nextLink < end; nextLink++)
                if (!IsLinkRight(Page.Links[nextLink], index))
                    return new TableProblem(TableFault.Link, (int)nextLink);
            if (node.PointCount < 1 || node.PointCount > StoreFormat.MaxPointsPerNode)
                return new TableProblem(TableFault.PointCount, index);
            if (node.BlockCount != PlaneShape.BlocksOf(node.PointCount))
                return new TableProblem(TableFault.BlockCount, index);
            if (node.MinX > node.MaxX || node.MinY > node.MaxY || node.MinZ > node.MaxZ)
                return new TableProblem(TableFault.Bounds, index);
            return default;
        }

        // A page has fewer points and nodes than the one above it: no circle of links is followed for ever.
        bool IsLinkRight(in PageLink link, int node) => link.AttachNode == node && link.SideLog2 >= 0 &&
            link.SideLog2 <= GridCube.MaxSideLog2 && Link.Cube.ContainsAligned(link.Cube) && IsOfOctree(link.Cube) &&
            link.SubtreePointCount > 0 && link.SubtreePointCount < Link.SubtreePointCount &&
            link.SubtreeNodeCount > 0 && link.SubtreeNodeCount < Link.SubtreeNodeCount &&
            link.LengthBytes >= PageHeader.SizeBytes && link.LengthBytes <= StoreFormat.MaxPageBytesToRead &&
            link.Container >= -1 && link.Container < m_header.ContainerCount &&
            link.OffsetBytes >= FileHeader.SizeBytes && link.OffsetBytes <= EndFor(link) - link.LengthBytes;

        // Pages lie before those that link to them: no length is beyond what the file was seen to have.
        long EndFor(in PageLink link) => link.Container < 0 ? Link.OffsetBytes : Page.Containers[link.Container].FileBytes;

        bool IsOfOctree(in GridCube cube)
        {
            var from = cube.Corner - Link.Corner;
            return cube.SideLog2 == 0 || (from.X | from.Y | from.Z) << (64 - cube.SideLog2) == 0;
        }

        TableProblem FindInPlaneNode(int index)
        {
            var nodes = Page.Nodes;
            var node = nodes[index];
            if (node.PlaneNode != index)
            {
                bool isInlined = node.PlaneNode == node.Parent && node.PlaneNode >= 0 && node.ChildCount == 0 &&
                    node.PlaneBlocks == 0 && node.LinkCount == 0 && nodes[node.PlaneNode].PlaneNode == node.PlaneNode;
                return isInlined ? default : new TableProblem(TableFault.InlinedLeaf, index);
            }
            if (node.FirstBlock != 0)
                return new TableProblem(TableFault.FirstBlock, index);
            // The children are not checked yet, but they are in the table.
            long blocks = node.BlockCount;
            long end = math.min(m_header.NodeCount, (long)node.FirstChild + node.ChildCount);
            for (long child = node.FirstChild; child < end; child++)
            {
                if (nodes[child].PlaneNode != index)
                    continue;
                if (nodes[child].FirstBlock != blocks)
                    return new TableProblem(TableFault.InlinedBlocks, (int)child, blocks, nodes[child].FirstBlock);
                blocks += nodes[child].BlockCount;
            }
            return blocks == node.PlaneBlocks ? default
                : new TableProblem(TableFault.PlaneBlocks, index, blocks, node.PlaneBlocks);
        }

        TableProblem FindInPlanes(int index)
        {
            var node = Page.Nodes[index];
            for (int p = 0; p < m_planeCount; p++)
            {
                var range = Page.RangeOf(index, p);
                if (node.PlaneNode != index)
                {
                    if (range.LengthBytes != 0)
                        return new TableProblem(TableFault.InlinedPlane, index);
                    continue;
                }
                var shape = p == StoreLayout.PositionPlane && node.IsWide ? new PlaneShape(3, 7) : m_shapes[p];
                long shortest = PlaneShape.LengthBytes((long)node.PlaneBlocks * shape.DescriptorWords);
                long fileBytes = Page.Containers[Page.ContainerOfPlane[p]].FileBytes;
                if (range.OffsetBytes < FileHeader.SizeBytes || range.LengthBytes < shortest ||
                    range.OffsetBytes > fileBytes - range.LengthBytes)
                    return new TableProblem(TableFault.Plane, index, fileBytes, p);
            }
            return default;
        }

        TableProblem FindInSums()
        {
            long points = 0, nodes = m_header.NodeCount;
            for (int n = 0; n < m_header.NodeCount; n++)
                points += Page.Nodes[n].PointCount;
            if (points != m_header.PointCount)
                return new TableProblem(TableFault.PointSum, 0, m_header.PointCount, points);
            for (int l = 0; l < m_header.LinkCount; l++)
            {
                var link = Page.Links[l];
                // Claims of up to 2^63 each: no sum of them may overflow.
                if (link.SubtreePointCount > Link.SubtreePointCount - points)
                    return new TableProblem(TableFault.PointSum, 0, Link.SubtreePointCount, points);
                if (link.SubtreeNodeCount > Link.SubtreeNodeCount - nodes)
                    return new TableProblem(TableFault.NodeSum, 0, Link.SubtreeNodeCount, nodes);
                points += link.SubtreePointCount;
                nodes += link.SubtreeNodeCount;
            }
            if (points != Link.SubtreePointCount)
                return new TableProblem(TableFault.PointSum, 0, Link.SubtreePointCount, points);
            return nodes == Link.SubtreeNodeCount ? default
                : new TableProblem(TableFault.NodeSum, 0, Link.SubtreeNodeCount, nodes);
        }
    }

    /// <summary>The first thing that is wrong with a table. Blittable, for jobs.</summary>
    public struct TableProblem
    {
        public TableFault Fault;
        public int Node;

        /// <summary>The expected or actual value, depending on the fault.</summary>
        public long Wanted;
        public long Got;

        public TableProblem(TableFault fault, int node = 0, long wanted = 0, long got = 0) =>
            (Fault, Node, Wanted, Got) = (fault, node, wanted, got);

        public bool IsNone => Fault == TableFault.None;
    }

    /// <summary>The faults that a page of a hierarchy can have.</summary>
    public enum TableFault : byte
    {
        None,
        /// <summary>The bytes differ from those that were written.</summary>
        Hash,
        Head,
        Roots,
        Orphans,
        Link,
        Links,
        PointSum,
        NodeSum,
        Side,
        OutsideRegion,
        NotOfOctree,
        Parent,
        ParentCube,
        NotAChild,
        Children,
        PointCount,
        BlockCount,
        Bounds,
        InlinedLeaf,
        FirstBlock,
        InlinedBlocks,
        PlaneBlocks,
        InlinedPlane,
        Plane,
    }

    internal unsafe struct PageView
    {
        [NativeDisableUnsafePtrRestriction] public byte* Bytes;

        public static PageView Of(NativeArray<byte> bytes) => new PageView { Bytes = (byte*)bytes.GetUnsafeReadOnlyPtr() };

        public readonly PageHeader Header => *(PageHeader*)Bytes;
        public readonly int NodeCount => ((PageHeader*)Bytes)->NodeCount;
        public readonly NodeRecord* Nodes => (NodeRecord*)(Bytes + Header.NodesOffset);
        public readonly PackedRange* Ranges => (PackedRange*)(Bytes + Header.RangesOffset);
        public readonly PageLink* Links => (PageLink*)(Bytes + Header.LinksOffset);
        public readonly ContainerRecord* Containers => (ContainerRecord*)(Bytes + Header.ContainersOffset);

        // By plane: the number of the container that all its nodes have it in.
        public readonly int* ContainerOfPlane => (int*)(Bytes + Header.PlanesOffset);

        public readonly PlaneRange RangeOf(int node, int plane) => Ranges[(long)node * Header.PlaneCount + plane].Range;
    }
}
