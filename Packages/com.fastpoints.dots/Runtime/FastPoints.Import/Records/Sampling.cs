using FastPoints.Points;

namespace FastPoints.Records
{
    /// <summary>What every sampler stands on.</summary>
    public static unsafe class Sampling
    {
        /// <summary>No node yet.</summary>
        public const int Unassigned = -1;

        /// <summary>From records in order: where cubes end, and priorities.</summary>
        /// <param name="first">Of the points that this is done for; of those before it, the last is looked at.</param>
        /// <returns>The sum of the records' hashes.</returns>
        public static ulong Prepare(byte* records, int first, int end, in RecordLayout layout, Grid3 corner, byte* commonCubeLog2,
            uint* priority)
        {
            ulong sum = 0;
            long stride = layout.StrideBytes;
            var before = first > 0 ? layout.PlaceOf(records + (first - 1) * stride) - corner : default;
            for (int i = first; i < end; i++)
            {
                byte* record = records + i * stride;
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
