namespace FastPoints.Store
{
    /// <summary>The first thing that is wrong with a table. Blittable, for jobs.</summary>
    public struct TableProblem
    {
        public TableFault Fault;
        public int Node;

        /// <summary>The expected or actual value, depending on the fault.</summary>
        public long Wanted;
        public long Got;

        public TableProblem(TableFault fault, int node = 0, long wanted = 0, long got = 0)
        {
            Fault = fault;
            Node = node;
            Wanted = wanted;
            Got = got;
        }

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
