using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Store;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Tests.Nodes
{
    sealed class SampledPoints
    {
        public Grid3[] Positions; // In order along the Morton curve, from the cube's corner.
        public uint[] Priority;
        public int[] NodeOfPoint;
        public NodeDraft[] Nodes;

        public static unsafe SampledPoints Run(IReadOnlyList<Grid3> positions, Sampler sampler, NodeSizes sizes,
            int costPerSlice = int.MaxValue)
        {
            var sorted = Sorted(positions, out int side);
            var result = new SampledPoints { Positions = sorted };
            int count = sorted.Length;
            var layout = new RecordLayout(side > 32, default, 0);
            using var scratch = new SampleScratch(Allocator.Persistent);
            using var records = new NativeArray<byte>(count * layout.StrideBytes, Allocator.Persistent);
            using var common = new NativeArray<byte>(count, Allocator.Persistent);
            using var priority = new NativeArray<uint>(count, Allocator.Persistent);
            using var nodeOfPoint = new NativeArray<int>(count, Allocator.Persistent);
            using var tops = new NativeArray<TopNode>(0, Allocator.Persistent);
            using var slices = new SliceTimes(Allocator.Persistent);
            using var nodes = new NativeList<NodeDraft>(64, Allocator.Persistent);
            var averaged = new AveragedColumns
            {
                Columns = new NativeArray<StoredColumn>(0, Allocator.Persistent),
                AverageOfPoint = new NativeArray<int>(0, Allocator.Persistent),
                Sums = new NativeList<AverageSums>(0, Allocator.Persistent),
            };
            var record = (byte*)records.GetUnsafePtr();
            for (int i = 0; i < count; i++)
                layout.SetPosition(record + i * layout.StrideBytes, sorted[i].X, sorted[i].Y, sorted[i].Z);
            new SampleInputs { CommonCubeLog2 = (byte*)common.GetUnsafePtr(), Priority = (uint*)priority.GetUnsafePtr() }
                .Prepare(record, 0, count, layout, default);
            var job = new SampleNodesJob
            {
                Count = count,
                RootSideLog2 = side,
                Sizes = sizes,
                Layout = layout,
                IsRandom = sampler == Sampler.Random,
                Records = records,
                CommonCubeLog2 = common,
                Priority = priority,
                Tops = tops,
                NodeOfPoint = nodeOfPoint,
                Nodes = nodes,
                Averaged = averaged,
                SliceTimes = slices,
                Scratch = scratch,
                CostPerSlice = costPerSlice,
            };
            do
                job.Schedule().Complete();
            while (!scratch.IsDone);
            result.Priority = priority.ToArray();
            result.NodeOfPoint = nodeOfPoint.ToArray();
            result.Nodes = nodes.AsArray().ToArray();
            averaged.Columns.Dispose();
            averaged.AverageOfPoint.Dispose();
            averaged.Sums.Dispose();
            return result;
        }

        /// <param name="side">log2 of the side of the smallest cube at the origin that has them all.</param>
        static Grid3[] Sorted(IReadOnlyList<Grid3> positions, out int side)
        {
            var sorted = new Grid3[positions.Count];
            long max = 0;
            for (int i = 0; i < sorted.Length; i++)
            {
                sorted[i] = positions[i];
                max |= sorted[i].X | sorted[i].Y | sorted[i].Z;
            }
            Array.Sort(sorted, MortonOrder.Compare);
            side = 0;
            while (max >> side != 0)
                side++;
            return sorted;
        }

        /// <summary>Smallest distance between two sampled points, by the smaller of their spacings: 1 and more is
        /// right.</summary>
        public double SmallestRatio()
        {
            double smallest = double.PositiveInfinity;
            var sampled = new List<int>();
            for (int i = 0; i < Positions.Length; i++)
                if (IsSampled(i))
                    sampled.Add(i);
            // Along x, so that few pairs are looked at.
            sampled.Sort((a, b) => Positions[a].X.CompareTo(Positions[b].X));
            double widest = 0;
            foreach (var node in Nodes)
                if (!node.IsLeaf)
                    widest = Math.Max(widest, Math.Pow(2, node.CellLog2));
            for (int a = 0; a < sampled.Count; a++)
                for (int b = a + 1; b < sampled.Count && Positions[sampled[b]].X - Positions[sampled[a]].X < widest; b++)
                {
                    int cell = Math.Min(Nodes[NodeOfPoint[sampled[a]]].CellLog2, Nodes[NodeOfPoint[sampled[b]]].CellLog2);
                    smallest = Math.Min(smallest, DistanceOf(sampled[a], sampled[b]) / Math.Pow(2, cell));
                }
            return smallest;
        }

        public bool IsSampled(int point) => !Nodes[NodeOfPoint[point]].IsLeaf && Nodes[NodeOfPoint[point]].SideLog2 > 0;

        public double DistanceOf(int a, int b)
        {
            var d = Positions[a] - Positions[b];
            return Math.Sqrt((double)d.X * d.X + (double)d.Y * d.Y + (double)d.Z * d.Z);
        }
    }

    static class SamplingClouds
    {
        public static Grid3[] Make(int count, Func<Unity.Mathematics.Random, int, (Grid3, Unity.Mathematics.Random)> make)
        {
            var random = new Unity.Mathematics.Random(99);
            var positions = new Grid3[count];
            for (int i = 0; i < count; i++)
                (positions[i], random) = make(random, i);
            return positions;
        }

        public static Grid3[] Volume(int count, int side) => Make(count, (r, i) =>
            (new Grid3(r.NextInt(side), r.NextInt(side), r.NextInt(side)), r));

        public static Grid3[] Surface(int count, int side) => Make(count, (r, i) =>
        {
            int x = r.NextInt(side), y = r.NextInt(side);
            return (new Grid3(x, y, (long)(side * (0.5 + 0.2 * Math.Sin(9.0 * x / side) * Math.Cos(7.0 * y / side)))), r);
        });

        public static Grid3[] Lattice(int edge, int step)
        {
            var positions = new List<Grid3>();
            for (int i = 0; i < edge * edge * edge; i++)
                positions.Add(new Grid3(i % edge * step, i / edge % edge * step, i / edge / edge * step));
            return positions.ToArray();
        }

        public static IEnumerable<TestCaseData> All()
        {
            yield return Case("volume", Volume(3000, 1 << 20));
            yield return Case("surface", Surface(3000, 1 << 16));
            yield return Case("line", Make(2000, (r, i) => (new Grid3(i * 37, i * 37, i * 37), r)));
            yield return Case("lattice of one step", Lattice(14, 1));
            yield return Case("lattice of the spacing", Lattice(14, 64));
            yield return Case("all equal", Make(1000, (r, i) => (new Grid3(7, 8, 9), r)));
            yield return Case("density of a million to one", Make(3000, (r, i) => (i % 1000 == 0
                ? new Grid3(r.NextInt(1 << 30), r.NextInt(1 << 30), r.NextInt(1 << 30))
                : new Grid3((1 << 29) + r.NextInt(1000), 77 + r.NextInt(1000), 5 + r.NextInt(1000)), r)));
            yield return Case("four steps wide", Make(2000, (r, i) => (new Grid3(r.NextInt(4), r.NextInt(4), r.NextInt(4)), r)));
            yield return Case("as wide as integers", Make(2000, (r, i) =>
                (new Grid3(r.NextInt(int.MaxValue), r.NextInt(int.MaxValue), i % 2 * (long)int.MaxValue), r)));
        }

        static TestCaseData Case(string name, Grid3[] positions) => new TestCaseData((object)positions).SetName("{m}(" + name +
            ")");
    }
}
