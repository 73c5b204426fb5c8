using FastPoints.Points;

namespace FastPoints.Octree
{
    /// <summary>What every sampler stands on.</summary>
    public static unsafe class Sampling
    {
        /// <summary>No node yet.</summary>
        public const int Unassigned = -1;

        /// <summary>From records in order: where cubes end, and priorities.</summary>
        /// <returns>The sum of the records' hashes.</returns>
        public static ulong Prepare(byte* records, int count, RecordLayout layout, Grid3 corner, byte* commonCubeLog2,
            uint* priority)
        {
            ulong sum = 0;
            var before = default(Grid3);
            int stride = layout.StrideBytes;
            for (int i = 0; i < count; i++)
            {
                byte* record = records + (long)i * stride;
                var place = layout.PlaceOf(record);
                ulong hash = Store.RecordHash.Of(place, layout.AttributesOf(record), layout.AttributeBytes,
                    Store.RecordHash.ChecksumSeed);
                sum += hash;
                priority[i] = (uint)(hash >> 32);
                place -= corner;
                commonCubeLog2[i] = i == 0 ? byte.MaxValue : (byte)MortonOrder.CommonCubeLog2(before, place);
                before = place;
            }
            return sum;
        }
    }
}
