using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using FastPoints.Core;
using FastPoints.Import;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Tests.Support;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Sampling
{
    [Category("Smoke")]
    public class DensityEstimateTests : FolderTests
    {
        const int Points = 200_000, Lines = 800, PatchPoints = 250;
        const double Size = 100;

        public enum Order
        {
            ScanLines,
            Curve,
            Patches,

            Chance,
        }

        static double3[] Cloud(Order order, uint seed)
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
                return points.OrderBy(p => (int)(p.y / Size * Lines)).ThenBy(p => p.x).ToArray();
            if (order == Order.Curve || order == Order.Patches)
                points = points.OrderBy(p => Morton.Encode((uint)(10 * (p.x + Size)), (uint)(10 * (p.y + Size)), 0)).ToArray();
            if (order == Order.Patches)
                return Enumerable.Range(0, Points / PatchPoints).OrderBy(i => random.Next())
                    .SelectMany(i => new ArraySegment<double3>(points, i * PatchPoints, PatchPoints)).ToArray();
            return points;
        }

        PointReader Reader(double3[] points)
        {
            string path = Folder.File("cloud.ply");
            using (var file = File.Create(path))
            {
                file.Write(Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\nelement vertex " + points.Length
                    + "\nproperty double x\nproperty double y\nproperty double z\nend_header\n"));
                file.Write(MemoryMarshal.AsBytes(points.AsSpan()));
            }
            return PointReaders.Open(path);
        }

        static DensityEstimate Estimate(PreviewSample sample)
        {
            DensityEstimate density = null;
            JobCoroutine.RunToEnd(DensityEstimate.Of(sample, sample.Bounds, d => density = d));
            return density;
        }

        static DensityEstimate Estimate(PointReader reader, int wanted, uint seed)
        {
            using var sampler = PreviewSampler.Create(reader, wanted, seed);
            JobCoroutine.RunToEnd(sampler.Run(0, new StageProgress()));
            return Estimate(sampler.Sample);
        }

        static int[] Count(IReadOnlyList<DensityLeaf> leaves, double3[] points)
        {
            var edges = leaves.Select(l => l.Edge).Distinct().ToArray();
            var corner = leaves[0].Min;
            var numbers = new Dictionary<(double, int3), int>();
            for (int i = 0; i < leaves.Count; i++)
                numbers.Add((leaves[i].Edge, (int3)math.round((leaves[i].Min - corner) / leaves[i].Edge)), i);
            var counts = new int[leaves.Count];
            foreach (var point in points)
                foreach (double edge in edges)
                    if (numbers.TryGetValue((edge, (int3)math.floor((point - corner) / edge)), out int leaf))
                        counts[leaf]++;
            return counts;
        }

        [Test]
        public void Errors_OfRuns_CoverTheTruthInNineOfTenCells([Values] Order order, [Values(10_000, 50_000)] int wanted)
        {
            int known = 0, covered = 0;
            var relative = new List<double>();
            for (uint seed = 1; seed <= 2; seed++)
            {
                var points = Cloud(order, seed);
                using var reader = Reader(points);
                using var density = Estimate(reader, wanted, seed);
                var leaves = density.Leaves().ToList();
                var truths = Count(leaves, points);
                foreach (var (leaf, truth) in leaves.Zip(truths, (l, t) => (l, t)).Where(p => p.l.Cell.IsKnown))
                {
                    double error = Math.Abs(truth - leaf.Cell.Points);
                    known++;
                    covered += error <= 2 * leaf.Cell.StandardError ? 1 : 0;
                    relative.Add(leaf.Cell.StandardError / leaf.Cell.Points);
                }
            }
            Assert.That(known, Is.GreaterThan(100));
            Assert.That(covered / (double)known, Is.GreaterThan(0.9));
            // An error that says nothing would cover anything.
            Assert.That(relative.OrderBy(r => r).ElementAt(known / 2), Is.LessThan(0.35));
        }

        [Test]
        public void Sum_OfAllCells_IsTheCloudWithinItsError([Values] Order order)
        {
            var points = Cloud(order, 7);
            using var reader = Reader(points);
            using var density = Estimate(reader, 20_000, 7);
            Assert.That(density.Inside.Points + density.Outside.Points, Is.EqualTo(Points).Within(1));
            Assert.That(density.Leaves().Sum(l => l.Cell.Points), Is.EqualTo(density.Inside.Points).Within(1));
        }

        [Test]
        public void Cells_ThatNoPointWasSampledIn_AreUnknownAndNotEmpty()
        {
            var points = Cloud(Order.ScanLines, 3);
            using var reader = Reader(points);
            using var density = Estimate(reader, 20_000, 3);
            var leaves = density.Leaves().ToList();
            Assert.That(leaves.Where(l => !l.Cell.IsKnown).Select(l => l.Cell.StandardError), Is.Not.Empty.And.All.NaN);
            var truths = Count(leaves, points);
            Assert.That(leaves.Zip(truths, (l, t) => l.Cell.IsKnown ? 0 : t).Sum(), Is.GreaterThan(0),
                "none of them being empty is what the name says");
        }

        [Test]
        public void Estimate_OfAllPoints_IsExactAndWithoutError()
        {
            var points = Cloud(Order.Chance, 5);
            using var reader = Reader(points);
            using var density = Estimate(reader, Points, 5);
            var leaves = density.Leaves().ToList();
            Assert.That(leaves.Select(l => l.Cell.Points), Is.EqualTo(Count(leaves, points)).Within(1e-6 * Points));
            Assert.That(leaves.Where(l => l.Cell.IsKnown).Select(l => l.Cell.StandardError), Is.All.Zero);
        }

        [Test]
        public void Estimate_OfAnySlotsAndWorkers_IsTheSame()
        {
            var points = Cloud(Order.Curve, 2);
            using var reader = Reader(points);
            var results = new List<string>();
            foreach (int workers in new[] { 1, 4 })
            {
                using var threads = new WorkerCount(workers);
                using var density = Estimate(reader, 20_000, 2);
                results.Add(string.Join(";", density.Leaves().Select(l => l.Min + " " + l.Edge + " " + l.Cell.Points + " "
                    + l.Cell.StandardError)));
            }
            Assert.That(results[0], Is.EqualTo(results[1]));
        }

        static MemoryPointReader Blocks(double3[] points)
        {
            var batch = TestBatches.New(Points, TestBatches.Xyz(AttributeType.Float64));
            for (int i = 0; i < Points; i++)
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, points[i][axis]);
            return new MemoryPointReader(batch, 5_000, false);
        }

        [Test]
        public void Estimate_OfBeginningsAndScans_AddsUpToTheCloud([Values(2_000, 30_000)] int wanted,
            [Values(200, 20_000)] int before)
        {
            using var reader = Blocks(Cloud(Order.Curve, 4));
            using (var density = Estimate(reader, wanted, 4))
                Assert.That(density.Inside.Points + density.Outside.Points, Is.EqualTo(Points).Within(1));

            using var first = PreviewSampler.Create(reader, before, 1);
            JobCoroutine.RunToEnd(first.Run(0, new StageProgress()));
            using var refining = new RefiningSampler(reader, wanted, 1, first.Sample, first.Sample.Bounds);
            int waves = 0;
            refining.WaveReady += wave =>
            {
                waves++;
                using var density = Estimate(refining.Sample);
                Assert.That(density.Inside.Points + density.Outside.Points, Is.EqualTo(Points).Within(1));
            };
            JobCoroutine.RunToEnd(refining.Run(0, new StageProgress()));
            Assert.That(waves, Is.EqualTo(before == 200 ? 3 : 1), "a wave of fewer points than were there before is none");
        }
    }
}
