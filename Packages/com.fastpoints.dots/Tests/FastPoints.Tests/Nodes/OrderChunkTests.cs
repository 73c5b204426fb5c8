using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Store;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Tests.Nodes
{
    sealed unsafe class OrderChunkTests
    {
        static readonly Grid3 s_corner = new Grid3(1000, -50000, 7);

        static IEnumerable<TestCaseData> Clouds()
        {
            foreach (var cloud in SamplingClouds.All())
                yield return cloud;
            yield return Case("large volume", SamplingClouds.Volume(70000, 1 << 21));
            yield return Case("large surface", SamplingClouds.Surface(70000, 1 << 17));
            yield return Case("70,000 equal and some others", SamplingClouds.Make(80000, (r, i) =>
                (i % 8 > 0 ? new Grid3(77, 5, 1 << 18) : new Grid3(r.NextInt(1 << 20), r.NextInt(1 << 20), 9), r)));
            yield return Case("far apart, then falling in the last bits", SamplingClouds.Make(20000, (r, i) =>
                (i < 8 ? new Grid3((long)i << 35, 0, (long)i << 34) : new Grid3(20000 - i, 0, 0), r)));
        }

        [TestCaseSource(nameof(Clouds))]
        public void Order_AnyCloud_MatchesSorting(Grid3[] positions)
        {
            var expected = Bytes(positions, 9, out var layout);
            var order = new int[positions.Length];
            for (int i = 0; i < order.Length; i++)
                order[i] = i;
            Array.Sort(order, (a, b) => Compare(positions, expected, layout.StrideBytes, a, b));
            var sorted = new byte[expected.Length];
            for (int i = 0; i < order.Length; i++)
                Array.Copy(expected, order[i] * layout.StrideBytes, sorted, i * layout.StrideBytes, layout.StrideBytes);

            ulong sum = 0;
            foreach (int costPerSlice in new[] { 1, 100000, int.MaxValue })
            {
                var (found, common, priority, checksum) = Run(positions, layout, expected, costPerSlice);
                Assert.That(found.AsSpan().SequenceEqual(sorted), "in slices of " + costPerSlice);
                sum = 0;
                fixed (byte* records = sorted)
                    for (int i = 0; i < order.Length; i++)
                    {
                        ulong hash = layout.HashOf(records + i * layout.StrideBytes, RecordHash.ChecksumSeed);
                        sum += hash;
                        Assert.That(priority[i], Is.EqualTo((uint)(hash >> 32)));
                        Assert.That(common[i], Is.EqualTo(i == 0 ? byte.MaxValue
                            : MortonOrder.CommonCubeLog2(positions[order[i - 1]], positions[order[i]])));
                    }
                Assert.That(checksum, Is.EqualTo(sum));
            }
        }

        static TestCaseData Case(string name, Grid3[] positions) => new TestCaseData((object)positions).SetName("{m}(" + name +
            ")");

        /// <summary>Records with seven bytes of attributes, a few of which differ.</summary>
        static byte[] Bytes(Grid3[] positions, uint seed, out RecordLayout layout)
        {
            long max = 0;
            foreach (var position in positions)
                max |= position.X | position.Y | position.Z;
            layout = new RecordLayout(max >> 32 != 0, s_corner - new Grid3(3, 2, 1), 7);
            var random = new Unity.Mathematics.Random(seed);
            var bytes = new byte[positions.Length * layout.StrideBytes];
            fixed (byte* records = bytes)
                for (int i = 0; i < positions.Length; i++)
                {
                    byte* record = records + i * layout.StrideBytes;
                    var position = s_corner + positions[i];
                    layout.SetPosition(record, position.X, position.Y, position.Z);
                    layout.AttributesOf(record)[0] = (byte)random.NextInt(2);
                    layout.AttributesOf(record)[6] = (byte)random.NextInt(3);
                }
            return bytes;
        }

        static int Compare(Grid3[] positions, byte[] records, int stride, int a, int b)
        {
            int order = MortonOrder.Compare(positions[a], positions[b]);
            for (int w = stride - 8; w < stride && order == 0; w += 4)
                order = BitConverter.ToUInt32(records, a * stride + w).CompareTo(BitConverter.ToUInt32(records, b * stride + w));
            return order;
        }

        static (byte[] Sorted, byte[] Common, uint[] Priority, ulong Checksum) Run(Grid3[] positions, RecordLayout layout,
            byte[] records, int costPerSlice)
        {
            int count = positions.Length, side = 0;
            foreach (var position in positions)
                while ((position.X | position.Y | position.Z) >> side != 0)
                    side++;
            var pool = new RecordPagePool(layout.StrideBytes, count / RecordPages.RecordsPerPage);
            var pages = default(RecordPages);
            fixed (byte* first = records)
                pool.Append(ref pages, first, count);
            using var scratch = new OrderScratch(Allocator.Persistent);
            using var numbers = new NativeArray<uint>(count, Allocator.Persistent);
            using var sorted = new NativeArray<byte>(records.Length, Allocator.Persistent);
            using var commonCube = new NativeArray<byte>(count, Allocator.Persistent);
            using var priorities = new NativeArray<uint>(count, Allocator.Persistent);
            using var sum = new NativeReference<ulong>(Allocator.Persistent);
            using var slices = new SliceTimes(Allocator.Persistent);
            var job = new OrderChunkJob
            {
                Pages = pages,
                Layout = layout,
                Cube = new GridCube(s_corner, side),
                Scratch = scratch,
                BucketOfPoint = numbers,
                CostPerSlice = costPerSlice,
                Records = sorted,
                CommonCubeLog2 = commonCube,
                Priority = priorities,
                Checksum = sum,
                SliceTimes = slices,
            };
            do
                job.Schedule().Complete();
            while (!scratch.IsDone);
            pool.FreeAll();
            return (sorted.ToArray(), commonCube.ToArray(), priorities.ToArray(), sum.Value);
        }
    }
}
