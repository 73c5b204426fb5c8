using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Records
{
    /// <summary>Puts some of a chunk's records in order, one after the other, and prepares the sampling: where cubes end in the
    /// order, and each record's priority. The slices of a chunk follow one another.</summary>
    [BurstCompile]
    internal unsafe struct GatherRecordsJob : IJob
    {
        /// <summary>Takes about 4 ms.</summary>
        public const int PointsOfSlice = 30000;

        // Records that are copied, then looked at while they are in the cache.
        const int PointsOfRun = 512;

        /// <summary>The points of this slice, in the order.</summary>
        public int First;
        public int End;

        /// <summary>By page: its address.</summary>
        [ReadOnly] public NativeList<ulong> PageTable;
        public RecordLayout Layout;
        public Points.GridCube Cube;
        [ReadOnly] public NativeArray<uint> Order;
        public NativeArray<byte> Records;

        /// <summary>By point: log2 of the side of the smallest cube that has it and the point before; of the first one,
        /// 255.</summary>
        public NativeArray<byte> CommonCubeLog2;

        /// <summary>By point: the upper half of its hash.</summary>
        public NativeArray<uint> Priority;

        /// <summary>The sum of the hashes is added; the first slice begins with it.</summary>
        public NativeReference<ulong> Checksum;

        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            Run();
            Slices.End(begin);
        }

        void Run()
        {
            var table = new RecordTable
            {
                Pages = (RecordPages.Page**)PageTable.GetUnsafeReadOnlyPtr(),
                Layout = Layout,
                Corner = Cube.Corner,
            };
            int words = Layout.StrideBytes >> 2;
            var order = (uint*)Order.GetUnsafeReadOnlyPtr();
            var records = (byte*)Records.GetUnsafePtr();
            var common = (byte*)CommonCubeLog2.GetUnsafePtr();
            var priority = (uint*)Priority.GetUnsafePtr();
            ulong sum = First > 0 ? Checksum.Value : 0;
            for (int first = First; first < End; first += PointsOfRun)
            {
                int end = math.min(End, first + PointsOfRun);
                var to = (uint*)(records + (long)first * Layout.StrideBytes);
                for (int i = first; i < end; i++, to += words)
                {
                    var from = (uint*)table.At(order[i]);
                    for (int w = 0; w < words; w++)
                        to[w] = from[w];
                }
                sum += Sampling.Prepare(records, first, end, Layout, Cube.Corner, common, priority);
            }
            Checksum.Value = sum;
        }
    }

    /// <summary>What every sampler stands on.</summary>
    internal static unsafe class Sampling
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
