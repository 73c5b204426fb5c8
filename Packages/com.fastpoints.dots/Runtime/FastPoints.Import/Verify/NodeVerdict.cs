using FastPoints.Store;

namespace FastPoints.Verify
{
    /// <summary>What reading one node's points showed. Blittable.</summary>
    public struct NodeVerdict
    {
        /// <summary>What is wrong with a node; 0 for nothing.</summary>
        public enum Fault
        {
            None,
            PlaneHash,
            PlaneShape,
            BlockCounts,
            OutsideCube,
            Bounds,
            Value,
        }

        public Fault What;

        /// <summary>The plane at fault.</summary>
        public int Plane;

        /// <summary>Sums of the points' hashes: see <see cref="RecordHash"/>.</summary>
        public ulong FirstSum;
        public ulong SecondSum;
    }
}
