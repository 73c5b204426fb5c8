using Unity.Mathematics;

namespace FastPoints.Partition
{
    /// <summary>What the stored positions of a sample show, axis by axis. Blittable.</summary>
    public struct SampleFindings
    {
        /// <summary>Of the finite ones; min above max where there are none.</summary>
        public double3 Min;
        public double3 Max;

        /// <summary>The lowest binary digit that any value has, as a power of two; int.MaxValue where all are zero.</summary>
        public int3 LowestDigit;
    }
}
