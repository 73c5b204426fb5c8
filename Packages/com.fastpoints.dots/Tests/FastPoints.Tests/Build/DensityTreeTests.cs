using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Build;
using FastPoints.Reading;
using FastPoints.Sampling;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Build
{
    /// <summary>Estimates against all points of clouds of very uneven density, in orders good and bad.</summary>
    [Category("Smoke")]
    public class DensityTreeTests
    {
        const int Points = 200_000, Lines = 800, PatchPoints = 250, RecordBytes = 24, MinRanges = 32;
        const double Size = 100;

        public enum Order
        {
            ScanLines,
            Curve,

            /// <summary>Neighbours together, and what is together anywhere.</summary>
            Patches,

            Chance,
        }

        /// <summary>A hilly surface whose density goes with the inverse square of the distance from four positions: the Morton
        /// codes of its points, in the order.</summary>
        static uint[] Cloud(Order order, uint seed)
        {
            var random = new System.Random((int)seed);
            var points = new double3[Points];
            for (int i = 0; i < Points; i++)
            {
                double angle = random.NextDouble() * 2 * Math.PI, distance = Size / 2 * Math.Pow(random.NextDouble(), 2);
                double x = Size * (0.3 + 0.4 * (i & 1)) + distance * Math.Cos(angle);
                double y = Size * (0.3 + 0.4 * (i >> 1 & 1)) + distance * Math.Sin(angle);
                points[i] = new double3(x, y, 5 * Math.Sin(x / 9) * Math.Cos(y / 7));
            }
            if (order == Order.ScanLines)
                points = points.OrderBy(p => (int)(p.y / Size * Lines)).ThenBy(p => p.x).ToArray();
            else if (order == Order.Curve || order == Order.Patches)
                points = points.OrderBy(p => Morton.Encode((uint)(10 * (p.x + Size)), (uint)(10 * (p.y + Size)), 0)).ToArray();
            if (order == Order.Patches)
                points = Enumerable.Range(0, Points / PatchPoints).OrderBy(i => random.Next())
                    .SelectMany(i => new ArraySegment<double3>(points, i * PatchPoints, PatchPoints)).ToArray();
            double cellsPerUnit = (1 << DensityNumbers.Levels) / (1.5 * Size);
            return points.Select(p => (int3)((p + Size / 4) * cellsPerUnit))
                .Select(c => (uint)Morton.Encode((uint)c.x, (uint)c.y, (uint)c.z))
                .ToArray();
        }

        /// <summary>By runs of evenly spaced points at hashed positions in equal parts of the file; cells of more points than one
        /// stands for are divided.</summary>
        static DensityTree Estimate(uint[] cloud, int wanted, uint seed)
        {
            var plan = new RangePlan(Points, wanted, RecordBytes, seed);
            var codes = new List<uint>();
            var ranges = new List<SampleRange>();
            for (int i = 0; i < plan.RangeCount; i++)
            {
                int before = codes.Count;
                bool isSplit = plan.RangeOf(i, i, out var range, out var second);
                Take(range);
                if (isSplit)
                    Take(second);
                int count = codes.Count - before;
                double weight = Points / ((double)plan.RangeCount * count);
                ranges.Add(new SampleRange { First = before, Count = count, Weight = weight });
            }
            using var codeOfPoint = new NativeArray<uint>(codes.ToArray(), Allocator.TempJob);
            using var allRanges = new NativeArray<SampleRange>(ranges.ToArray(), Allocator.TempJob);
            DensityTree tree = null;
            JobCoroutine.RunToEnd(DensityTree.Count(codeOfPoint, allRanges, codes.Count / (double)Points,
                (double)Points / plan.RangeCount, default, t => tree = t));
            return tree;

            void Take(StridedRange range)
            {
                for (int i = 0; i < range.Count; i++)
                    codes.Add(cloud[range.First + (long)i * range.Step]);
            }
        }

        /// <summary>All cells that are not divided, or of so few runs that these say little of the parts, each with the cloud's
        /// points in it.</summary>
        static IEnumerable<(DensityCell Cell, int Truth)> Leaves(DensityTree tree, uint[] cloud) =>
            Leaves(tree, DensityNumbers.Root, 0, cloud);

        static IEnumerable<(DensityCell Cell, int Truth)> Leaves(DensityTree tree, int cell, int level, uint[] inside)
        {
            int parts = tree.FirstChildOf(cell);
            if (parts < 0 || tree[cell].Ranges < MinRanges)
                return new[] { (tree[cell], inside.Length) };
            var inPart = inside.ToLookup(code => (int)(code >> 3 * (DensityNumbers.Levels - 1 - level) & 7));
            return Enumerable.Range(0, 8).SelectMany(o => Leaves(tree, parts + o, level + 1, inPart[o].ToArray()));
        }

        [Test]
        public void Errors_OfRanges_CoverTheTruthInNineOfTenCells([Values] Order order, [Values(10_000, 50_000)] int wanted)
        {
            int known = 0, covered = 0;
            var relative = new List<double>();
            for (uint seed = 1; seed <= 2; seed++)
            {
                var cloud = Cloud(order, seed);
                using var tree = Estimate(cloud, wanted, seed);
                foreach (var (cell, truth) in Leaves(tree, cloud).Where(l => l.Cell.IsKnown))
                {
                    known++;
                    covered += Math.Abs(truth - cell.Points) <= 2 * cell.StandardError ? 1 : 0;
                    relative.Add(cell.StandardError / cell.Points);
                }
            }
            Assert.That(known, Is.GreaterThan(100));
            Assert.That(covered / (double)known, Is.GreaterThan(0.9));
            // An error that says nothing would cover anything.
            Assert.That(relative.OrderBy(r => r).ElementAt(known / 2), Is.LessThan(0.35));
        }

        [Test]
        public void Sum_OfAllCells_IsTheCloud([Values] Order order)
        {
            var cloud = Cloud(order, 7);
            using var tree = Estimate(cloud, 20_000, 7);
            Assert.That(tree[DensityNumbers.Root].Points, Is.EqualTo(Points).Within(1));
            Assert.That(Leaves(tree, cloud).Sum(l => l.Cell.Points), Is.EqualTo(Points).Within(1));
        }

        [Test]
        public void Cells_WithoutSampledPoints_AreUnknownAndNotEmpty()
        {
            var cloud = Cloud(Order.ScanLines, 3);
            using var tree = Estimate(cloud, 20_000, 3);
            var unknown = Leaves(tree, cloud).Where(l => !l.Cell.IsKnown).ToList();
            Assert.That(unknown.Select(l => l.Cell.StandardError), Is.Not.Empty.And.All.NaN);
            Assert.That(unknown.Sum(l => l.Truth), Is.GreaterThan(0), "none of them being empty is what the name says");
        }

        [Test]
        public void Estimate_OfAllPoints_IsExact()
        {
            var cloud = Cloud(Order.Chance, 5);
            using var tree = Estimate(cloud, Points, 5);
            foreach (var (cell, truth) in Leaves(tree, cloud))
            {
                Assert.That(cell.Points, Is.EqualTo(truth).Within(1e-6 * Points));
                Assert.That(cell.IsKnown ? cell.StandardError : 0, Is.Zero);
            }
        }

        [Test]
        public void Estimate_OfAnyWorkers_IsTheSame()
        {
            var cloud = Cloud(Order.Curve, 2);
            var results = new List<string>();
            foreach (int workers in new[] { 1, 4 })
            {
                using var threads = new WorkerCount(workers);
                using var tree = Estimate(cloud, 20_000, 2);
                results.Add(string.Join(";", Leaves(tree, cloud).Select(l => l.Cell.Points + " " + l.Cell.StandardError)));
            }
            Assert.That(results[0], Is.EqualTo(results[1]));
        }
    }
}
