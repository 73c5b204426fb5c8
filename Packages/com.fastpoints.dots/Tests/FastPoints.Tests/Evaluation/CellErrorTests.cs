using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Evaluation;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Evaluation
{
    [Category("Smoke")]
    public class CellErrorTests
    {
        /// <summary>Points of uneven density on a bent surface, in metres far from the origin.</summary>
        static double3[] Cloud(int count, uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var points = new double3[count];
            for (int i = 0; i < count; i++)
            {
                double u = random.NextDouble(), v = random.NextDouble();
                points[i] = new double3(400_000 + 100 * u * u, 5_000_000 + 60 * v, 20 + 10 * u * v);
            }
            return points;
        }

        static CellOccupancy Count(ErrorGrid grid, double3[] points)
        {
            var cells = new CellOccupancy(Allocator.Persistent);
            using var batch = TestBatches.OfPositions(points);
            new CountSampledCellsJob
            {
                Sample = batch.Bytes,
                Positions = PositionColumns.Of(batch),
                Transform = PositionTransform.Identity,
                Count = points.Length,
                Grid = grid,
                CellsOf128th = cells.CellsOf128th,
                PointsOfBlock = cells.PointsOfBlock,
            }.Schedule().Complete();
            return cells;
        }

        static CellError Compare(CellOccupancy cloud, CellOccupancy sample)
        {
            using var error = new NativeReference<CellError>(Allocator.Persistent);
            new CompareOccupancyJob
            {
                CellsOfCloud = cloud.CellsOf128th,
                PointsOfCloud = cloud.PointsOfBlock,
                CellsOfSample = sample.CellsOf128th,
                PointsOfSample = sample.PointsOfBlock,
                Error = error,
            }.Schedule().Complete();
            return error.Value;
        }

        static CellError Compare(ErrorGrid grid, double3[] cloud, double3[] sample)
        {
            using var cloudCells = Count(grid, cloud);
            using var sampleCells = Count(grid, sample);
            return Compare(cloudCells, sampleCells);
        }

        static ErrorGrid GridOf(double3[] points)
        {
            var bounds = BoundsGeo.Empty;
            foreach (var point in points)
                bounds.Include(point);
            return new ErrorGrid(bounds);
        }

        /// <summary>Cells by their position, without bits or Morton codes.</summary>
        static Dictionary<(int, int, int), int> ByHand(BoundsGeo bounds, double3[] points, int along)
        {
            double edge = math.cmax(bounds.Size) / ErrorGrid.Cells;
            int coarser = ErrorGrid.Cells / along;
            var cells = new Dictionary<(int, int, int), int>();
            foreach (var point in points)
            {
                if (!bounds.Contains(point))
                    continue;
                const double Last = ErrorGrid.Cells - 1;
                var at = math.min(math.floor((point - bounds.Min) * (1 / edge)), new double3(Last, Last, Last));
                var cell = ((int)at.x / coarser, (int)at.y / coarser, (int)at.z / coarser);
                cells.TryGetValue(cell, out int count);
                cells[cell] = count + 1;
            }
            return cells;
        }

        [Test]
        public void Compare_SeededClouds_MatchesADictionary([Values(1u, 2u, 3u)] uint seed)
        {
            var cloud = Cloud(40_000, seed);
            var random = new Unity.Mathematics.Random(seed + 100);
            var sample = cloud.Where(p => random.NextDouble() < 0.02 + 0.1 * (p.x - 400_000) / 100).ToArray();
            // Some of the cloud lies outside of the grid.
            var bounds = new BoundsGeo(cloud[0], cloud[0]);
            for (int i = 0; i < 200; i++)
                bounds.Include(cloud[i]);
            var grid = new ErrorGrid(bounds);
            var error = Compare(grid, cloud, sample);

            foreach (int along in new[] { 64, 128, 256, 512 })
            {
                var full = ByHand(bounds, cloud, along);
                var part = ByHand(bounds, sample, along);
                int occupied = along == 64 ? error.Occupied64 : along == 128 ? error.Occupied128
                    : along == 256 ? error.Occupied256 : error.Occupied512;
                double bare = along == 64 ? error.Uncovered64 : along == 128 ? error.Uncovered128
                    : along == 256 ? error.Uncovered256 : error.Uncovered512;
                Assert.That(occupied, Is.EqualTo(full.Count));
                Assert.That(bare, Is.EqualTo(full.Keys.Count(c => !part.ContainsKey(c)) / (double)full.Count).Within(1e-12));
            }
            var fullBlocks = ByHand(bounds, cloud, 64);
            var partBlocks = ByHand(bounds, sample, 64);
            double taken = partBlocks.Values.Sum() / (double)fullBlocks.Values.Sum();
            Assert.That(error.PointsOfCloud, Is.EqualTo(fullBlocks.Values.Sum()));
            Assert.That(error.PointsOfSample, Is.EqualTo(partBlocks.Values.Sum()));
            var deviations = fullBlocks.Where(c => c.Value >= CellError.MinPointsOfBlock)
                .Select(c => (partBlocks.TryGetValue(c.Key, out int n) ? n : 0) / (c.Value * taken) - 1).ToArray();
            Assert.That(error.Variation, Is.EqualTo(Math.Sqrt(deviations.Select(d => d * d).Average())).Within(1e-12));
            var fullRegions = ByHand(bounds, cloud, 8);
            var partRegions = ByHand(bounds, sample, 8);
            double bias = fullRegions.Where(r => r.Value * 1000L >= error.PointsOfCloud)
                .Max(r => Math.Abs((partRegions.TryGetValue(r.Key, out int n) ? n : 0) / (r.Value * taken) - 1));
            Assert.That(error.Bias, Is.EqualTo(bias).Within(1e-12));
            Assert.That(error.Bias, Is.GreaterThan(2 * error.BiasByChance), "the sample was made uneven");
        }

        [Test]
        public void Compare_RandomSamples_VaryAsExpectedByChance()
        {
            const int Samples = 100;
            var cloud = Cloud(60_000, 5);
            var grid = GridOf(cloud);
            using var full = Count(grid, cloud);
            var random = new Unity.Mathematics.Random(6);
            int above = 0;
            double variation = 0, byChance = 0;
            for (int i = 0; i < Samples; i++)
            {
                for (int k = 0; k < 6000; k++)
                {
                    int other = random.NextInt(k, cloud.Length);
                    (cloud[k], cloud[other]) = (cloud[other], cloud[k]);
                }
                using var part = Count(grid, cloud.Take(6000).ToArray());
                var error = Compare(full, part);
                above += error.Bias > error.BiasByChance ? 1 : 0;
                variation += error.Variation;
                byChance += error.VariationByChance;
            }
            // A binomial of 100 at a half has a standard deviation of 5.
            Assert.That(above, Is.InRange(Samples / 2 - 20, Samples / 2 + 20));
            Assert.That(variation / byChance, Is.EqualTo(1).Within(0.05));
        }

        [Test]
        public void Compare_TheCloudItself_HasNoError()
        {
            var cloud = Cloud(30_000, 9);
            var error = Compare(GridOf(cloud), cloud, cloud);
            Assert.That(error.PointsOfCloud, Is.EqualTo(cloud.Length));
            foreach (double zero in new[]
                { error.Uncovered64, error.Uncovered128, error.Uncovered256, error.Uncovered512, error.Variation,
                    error.VariationByChance, error.Bias, error.BiasByChance })
                Assert.That(zero, Is.Zero);
        }

        [Test]
        public void Compare_HalfIsMissing_IsSeen()
        {
            var cloud = Cloud(30_000, 9);
            var half = cloud.Where(p => p.y < 5_000_030).ToArray();
            var error = Compare(GridOf(cloud), cloud, half);
            Assert.That(error.Bias, Is.EqualTo(1).Within(0.1));
            Assert.That(error.BiasByChance, Is.LessThan(0.3));
            Assert.That(error.Variation, Is.EqualTo(1).Within(0.1));
            Assert.That(error.Uncovered64, Is.EqualTo(0.5).Within(0.05));
        }

        [Test]
        public void Compare_NothingSampled_LeavesAllCellsEmpty()
        {
            var cloud = Cloud(3000, 9);
            var error = Compare(GridOf(cloud), cloud, new double3[0]);
            Assert.That(error.Uncovered256, Is.EqualTo(1));
            Assert.That(error.Uncovered512, Is.EqualTo(1));
            Assert.That(error.Bias, Is.NaN);
            Assert.That(error.Variation, Is.NaN);
        }

        [Test]
        public void TryCell_DegenerateBoxesAndOddPositions_NeverLeaveTheGrid()
        {
            var point = new double3(5, 6, 7);
            foreach (var bounds in new[]
                { new BoundsGeo(point, point), new BoundsGeo(point, point + new double3(5e-324, 0, 0)), BoundsGeo.Empty,
                    new BoundsGeo(point - 1e300, point + 1e300),
                    new BoundsGeo(point * -double.MaxValue, point * double.MaxValue) })
            {
                var grid = new ErrorGrid(bounds);
                foreach (var at in new[] { point, bounds.Min, bounds.Max, bounds.Center })
                    if (grid.TryCell(at.x, at.y, at.z, out uint cell))
                        Assert.That(cell, Is.LessThan((uint)ErrorGrid.Cells * ErrorGrid.Cells * ErrorGrid.Cells));
                Assert.That(grid.TryCell(double.NaN, 6, 7, out _), Is.False);
                Assert.That(grid.TryCell(double.PositiveInfinity, 6, 7, out _), Is.False.Or.EqualTo(
                    double.IsPositiveInfinity(bounds.Max.x)));
            }
            Assert.That(new ErrorGrid(new BoundsGeo(point, point)).TryCell(5, 6, 7, out uint only), Is.True);
            Assert.That(only, Is.Zero);
        }
    }
}
