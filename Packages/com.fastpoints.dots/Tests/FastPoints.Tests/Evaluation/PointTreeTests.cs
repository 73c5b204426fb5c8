using System;
using FastPoints.Evaluation;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Evaluation
{
    public class PointTreeTests
    {
        static double3[] Cloud(string kind, int count, uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var points = new double3[count];
            for (int i = 0; i < count; i++)
            {
                var p = random.NextDouble3();
                switch (kind)
                {
                    case "far": points[i] = p + new double3(4_500_000, 5_800_000, 300); break;
                    case "clusters": points[i] = math.floor(p * 4) * 1000 + random.NextDouble3() * 1e-3; break;
                    case "equal": points[i] = new double3(1, 2, 3); break;
                    case "line": points[i] = new double3(i, 0, 0); break;
                    case "lattice": points[i] = math.floor(p * 5); break;
                    default: points[i] = p; break;
                }
            }
            return points;
        }

        static double[] NearestSq(PointBatch batch, double3[] queries)
        {
            using var tree = new PointTree();
            JobCoroutine.RunToEnd(tree.Build(batch, batch.Count, PositionTransform.Identity));
            using var asked = new NativeArray<double3>(queries, Allocator.Persistent);
            using var distancesSq = new NativeArray<double>(queries.Length, Allocator.Persistent);
            new NearestDistancesJob
            {
                Queries = asked,
                QueryCount = queries.Length,
                Points = tree.Points,
                Nodes = tree.Nodes,
                Count = tree.Count,
                Levels = tree.Levels,
                DistancesSq = distancesSq,
            }.ScheduleParallel(NearestDistancesJob.PieceCount(queries.Length), 1, default).Complete();
            return distancesSq.ToArray();
        }

        [Test]
        public void Nearest_AnyCloud_MatchesBruteForce(
            [Values("cube", "far", "clusters", "equal", "line", "lattice")] string kind, [Values(1, 8, 9, 17, 2000)] int count)
        {
            var points = Cloud(kind, count, 7);
            var queries = Cloud(kind, 600, 8);
            var expected = new double[queries.Length];
            for (int i = 0; i < queries.Length; i++)
            {
                expected[i] = double.PositiveInfinity;
                foreach (var point in points)
                    expected[i] = Math.Min(expected[i], math.distancesq(point, queries[i]));
            }
            using var batch = TestBatches.OfPositions(points);
            foreach (int workers in new[] { 1, 7 })
            {
                using var threads = new WorkerCount(workers);
                Assert.That(NearestSq(batch, queries), Is.EqualTo(expected));
            }
        }

        [Test]
        public void Nearest_NonFinitePositions_AreSkipped()
        {
            using var batch = TestBatches.OfPositions(new double3(double.NaN, 0, 0), new double3(1, 1, 1),
                new double3(0, double.NegativeInfinity, 0));
            Assert.That(NearestSq(batch, new[] { new double3(1, 1, 3) }), Is.EqualTo(new[] { 4.0 }));
        }

        [Test]
        public void Nearest_NoPoints_IsInfinitelyFar()
        {
            using var batch = TestBatches.OfPositions();
            Assert.That(NearestSq(batch, new[] { new double3(1, 1, 3) }), Is.EqualTo(new[] { double.PositiveInfinity }));
        }

        [Test]
        public void Rank_OneToAHundred_HasPercentilesAndRootMeanSquare()
        {
            using var distancesSq = new NativeArray<double>(120, Allocator.Persistent);
            using var error = new NativeReference<DistanceError>(Allocator.Persistent);
            var values = distancesSq;
            for (int i = 0; i < 100; i++)
            {
                double distance = (i * 37 % 100) + 1;
                values[i] = distance * distance;
            }
            new RankDistancesJob { DistancesSq = distancesSq, Count = 100, Unit = 10, Error = error }.Schedule().Complete();
            Assert.That(error.Value.Ranked95, Is.EqualTo(9.5).Within(1e-12));
            Assert.That(error.Value.Ranked99, Is.EqualTo(9.9).Within(1e-12));
            Assert.That(error.Value.Rms, Is.EqualTo(Math.Sqrt(338350 / 100.0) / 10).Within(1e-12));
            Assert.That(error.Value.Queries, Is.EqualTo(100));
        }
    }
}
