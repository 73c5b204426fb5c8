using Unity.Mathematics;

namespace FastPoints.Store
{
    // Whether a table of nodes is consistent, before anything in it is used. Reads memory alone: for jobs as well.
    internal unsafe struct TableCheck
    {
        public NodeRecord* Nodes;
        public PlaneRange* Planes; // By node times PlaneCount, plus plane.
        public int NodeCount;
        public int PlaneCount;
        public PlaneShape* Shapes; // The position's is that of nodes that are not wide.
        public GridCube Region;
        public long DataBytes; // Planes lie between the header and this offset.
        public bool IsChunk; // Several nodes may have no parent.

        public TableProblem FindProblem()
        {
            long nextChild = 0;
            while (nextChild < NodeCount && Nodes[nextChild].Parent == -1)
                nextChild++;
            if (NodeCount > 0 && (nextChild == 0 || (!IsChunk && nextChild != 1)))
                return new TableProblem(TableFault.Roots, 0, 1, nextChild);
            for (int i = 0; i < NodeCount; i++)
            {
                var problem = FindInTree(i, ref nextChild);
                if (problem.IsNone)
                    problem = FindInPlaneNode(i);
                if (problem.IsNone)
                    problem = FindInPlanes(i);
                if (!problem.IsNone)
                    return problem;
            }
            return nextChild == NodeCount ? default : new TableProblem(TableFault.Orphans, (int)nextChild);
        }

        TableProblem FindInTree(int index, ref long nextChild)
        {
            var node = Nodes[index];
            if (node.SideLog2 > GridCube.MaxSideLog2 || node.CellLog2 > node.SideLog2)
                return new TableProblem(TableFault.Side, index);
            if (!Region.Contains(node.Cube))
                return new TableProblem(TableFault.OutsideRegion, index);
            var from = node.Corner - Region.Corner;
            if ((from.X | from.Y | from.Z) << (64 - node.SideLog2) != 0 && node.SideLog2 > 0)
                return new TableProblem(TableFault.NotOfOctree, index);
            if (node.Parent >= index || node.Parent < -1)
                return new TableProblem(TableFault.Parent, index);
            if (node.Parent >= 0)
            {
                var parent = Nodes[node.Parent];
                if (!parent.Cube.Contains(node.Cube) || (parent.SideLog2 == node.SideLog2 && node.SideLog2 != 0))
                    return new TableProblem(TableFault.ParentCube, index);
                if (index < parent.FirstChild || index >= (long)parent.FirstChild + parent.ChildCount)
                    return new TableProblem(TableFault.NotAChild, index);
            }
            if (node.ChildCount < 0 || (node.ChildCount > 0 && node.FirstChild != nextChild) ||
                node.ChildCount > NodeCount - nextChild)
                return new TableProblem(TableFault.Children, index);
            nextChild += node.ChildCount;
            if (node.PointCount < 1 || node.PointCount > StoreFormat.MaxPointsPerNode)
                return new TableProblem(TableFault.PointCount, index);
            if (node.BlockCount != PlaneShape.BlocksOf(node.PointCount))
                return new TableProblem(TableFault.BlockCount, index);
            if (node.MinX > node.MaxX || node.MinY > node.MaxY || node.MinZ > node.MaxZ)
                return new TableProblem(TableFault.Bounds, index);
            return default;
        }

        TableProblem FindInPlaneNode(int index)
        {
            var node = Nodes[index];
            if (node.PlaneNode != index)
            {
                bool isInlined = node.PlaneNode == node.Parent && node.PlaneNode >= 0 && node.ChildCount == 0 &&
                    node.PlaneBlocks == 0 &&
                    node.ChunkCount == 0 && Nodes[node.PlaneNode].PlaneNode == node.PlaneNode;
                return isInlined ? default : new TableProblem(TableFault.InlinedLeaf, index);
            }
            if (node.FirstBlock != 0)
                return new TableProblem(TableFault.FirstBlock, index);
            // The children are not checked yet, but they are in the table.
            long blocks = node.BlockCount;
            long end = math.min(NodeCount, (long)node.FirstChild + node.ChildCount);
            for (long child = node.FirstChild; child < end; child++)
            {
                if (Nodes[child].PlaneNode != index)
                    continue;
                if (Nodes[child].FirstBlock != blocks)
                    return new TableProblem(TableFault.InlinedBlocks, (int)child, blocks, Nodes[child].FirstBlock);
                blocks += Nodes[child].BlockCount;
            }
            return blocks == node.PlaneBlocks ? default
                : new TableProblem(TableFault.PlaneBlocks, index, blocks, node.PlaneBlocks);
        }

        TableProblem FindInPlanes(int index)
        {
            var node = Nodes[index];
            for (int p = 0; p < PlaneCount; p++)
            {
                var range = Planes[(long)index * PlaneCount + p];
                if (node.PlaneNode != index)
                {
                    if (range.LengthBytes != 0)
                        return new TableProblem(TableFault.InlinedPlane, index);
                    continue;
                }
                var shape = p == StoreLayout.PositionPlane && node.IsWide ? new PlaneShape(3, 7) : Shapes[p];
                long shortest = PlaneShape.LengthBytes((long)node.PlaneBlocks * shape.DescriptorWords);
                if (range.OffsetBytes < FileHeader.SizeBytes || range.OffsetBytes % PlaneShape.AlignmentBytes != 0 ||
                    range.LengthBytes < shortest || range.LengthBytes % PlaneShape.AlignmentBytes != 0 ||
                    range.OffsetBytes > DataBytes - range.LengthBytes)
                    return new TableProblem(TableFault.Plane, index, 0, p);
            }
            return default;
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

    /// <summary>The faults that a file's table of nodes can have.</summary>
    public enum TableFault : byte
    {
        None,
        /// <summary>The bytes differ from those that were written.</summary>
        Hash,
        Roots,
        Orphans,
        PointSum,
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
}
