using FastPoints.Partition;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Records
{
    /// <summary>Copies some of a chunk's records in order and prepares the sampling: where cubes end in the order, and each
    /// record's priority. The slices of a chunk follow one another.</summary>
    [BurstCompile]
    internal unsafe struct GatherRecordsJob : IJob
    {
        /// <summary>A slice takes about 4 ms.</summary>
        public const int PointsOfSlice = 30000;

        // This many records are copied, then examined while they are in the cache.
        const int PointsOfRun = 512;

        /// <summary>The points of this slice in the order.</summary>
        public int First;
        public int End;

        /// <summary>Address of each page.</summary>
        [ReadOnly] public NativeList<ulong> PageTable;
        public RecordLayout Layout;
        public Points.GridCube Cube;
        [ReadOnly] public NativeArray<uint> Order;
        public NativeArray<byte> Records;

        /// <summary>For each point, log2 of the side of the smallest cube with it and the previous point; 255 for the first
        /// one.</summary>
        public NativeArray<byte> CommonCubeLog2;

        /// <summary>For each point, the upper half of its hash.</summary>
        public NativeArray<uint> Priority;

        /// <summary>Receives the sum of the hashes; the first slice resets it.</summary>
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

    /// <summary>The common basis of all samplers.</summary>
    internal static unsafe class Sampling
    {
        /// <summary>The point belongs to no node yet.</summary>
        public const int Unassigned = -1;

        /// <summary>Finds, from records in order, where cubes end, and priorities.</summary>
        /// <param name="first">First point to process; the one before it is read.</param>
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
