namespace FastPoints.Store
{
    /// <summary>The first thing that is wrong with a table. Blittable, for jobs.</summary>
    public struct TableProblem
    {
        public TableFault Fault;
        public int Node;

        /// <summary>What was wanted or got: which depends on the fault.</summary>
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
}
