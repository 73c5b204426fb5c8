using System;
using System.Linq;
using FastPoints.Evaluation;
using FastPoints.Picture;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Evaluation
{
    public class CompareSamplesTests
    {
        static double3[] Positions(int count, uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var positions = new double3[count];
            for (int i = 0; i < count; i++)
            {
                double x = random.NextDouble(0, 100), y = random.NextDouble(0, 60);
                positions[i] = new double3(700_000 + x, y, 5 * Math.Sin(x * 0.1) * Math.Cos(y * 0.2));
            }
            return positions;
        }

        static MemoryPointReader Reader(double3[] positions) => new MemoryPointReader(TestBatches.OfPositions(positions), 4096);

        static SampleError[] Measure(double3[] cloud, params double3[][] samples)
        {
            using var reader = Reader(cloud);
            using var comparison = new CompareSamples(reader, new PictureOptions(), 160, 90);
            JobCoroutine.RunToEnd(comparison.Prepare(new StageProgress()));
            var errors = new SampleError[samples.Length];
            for (int i = 0; i < samples.Length; i++)
            {
                using var batch = TestBatches.OfPositions(samples[i]);
                errors[i] = new SampleError();
                JobCoroutine.RunToEnd(comparison.Measure(batch, batch.Count, reader.Info.Transform, comparison.FullViews,
                    errors[i]));
                Assert.That(batch.Count, Is.EqualTo(samples[i].Length));
            }
            JobCoroutine.RunToEnd(comparison.LookUp(new StageProgress()));
            return errors;
        }

        static double3[] Scrambled(double3[] positions)
        {
            var random = new Unity.Mathematics.Random(77);
            return positions.OrderBy(_ => random.NextUInt()).ToArray();
        }

        [Test]
        public void Compare_TheFullCloudInAnyOrder_HasNoError()
        {
            var cloud = Positions(20_000, 1);
            var error = Measure(cloud, Scrambled(cloud))[0];
            Assert.That(error.Fraction, Is.EqualTo(1));
            Assert.That(error.Distance.Queries, Is.EqualTo(cloud.Length));
            Assert.That(error.Distance.Rms, Is.Zero);
            Assert.That(error.Distance.Ranked99, Is.Zero);
            Assert.That(error.Cells.PointsOfCloud, Is.EqualTo(error.Cells.PointsOfSample));
            Assert.That(error.Cells.Uncovered256, Is.Zero);
            Assert.That(error.Cells.Bias, Is.Zero);
            Assert.That(error.LookedUp, Is.EqualTo(CompareSamples.LookedUpPerSample));
            Assert.That(error.Found, Is.EqualTo(error.LookedUp));
        }

        [Test]
        public void Compare_TheFullCloudAndAPart_IsAtAndAboveTheFloor()
        {
            var cloud = Positions(20_000, 1);
            using var reader = Reader(cloud);
            using var comparison = new CompareSamples(reader, new PictureOptions(), 160, 90);
            JobCoroutine.RunToEnd(comparison.Prepare(null));
            ImageError PictureOf(double3[] points)
            {
                using var batch = TestBatches.OfPositions(points);
                var error = new SampleError();
                JobCoroutine.RunToEnd(comparison.Measure(batch, batch.Count, reader.Info.Transform, null, error));
                return error.Picture;
            }
            Assert.That(PictureOf(Scrambled(cloud)), Is.EqualTo(comparison.Floor));
            Assert.That(comparison.Floor.Flip, Is.InRange(0.001, 0.1), "the reference is smooth");
            Assert.That(PictureOf(Scrambled(cloud).Take(4000).ToArray()).Flip, Is.GreaterThan(2 * comparison.Floor.Flip));
        }

        [Test]
        public void Errors_MorePoints_AreSmallerAndHalfTheCloudIsBiased()
        {
            var cloud = Positions(40_000, 2);
            var mixed = Scrambled(cloud);
            var errors = Measure(cloud, mixed.Take(400).ToArray(), mixed.Take(8000).ToArray(),
                cloud.Where(p => p.y < 30).ToArray());
            var few = errors[0];
            var many = errors[1];
            var half = errors[2];
            Assert.That(many.Distance.Rms, Is.LessThan(few.Distance.Rms / 2));
            Assert.That(many.Distance.Ranked95, Is.LessThan(many.Distance.Ranked99));
            Assert.That(many.Cells.Uncovered64, Is.LessThan(few.Cells.Uncovered64));
            Assert.That(many.Picture.Ssim, Is.GreaterThan(few.Picture.Ssim));
            Assert.That(many.Cells.Bias, Is.LessThan(4 * many.Cells.BiasByChance));
            Assert.That(half.Cells.Bias, Is.GreaterThan(0.9));
            Assert.That(half.Cells.BiasByChance, Is.LessThan(0.3));
            Assert.That(half.Picture.Uncovered, Is.GreaterThan(0.2));
            Assert.That(half.Distance.Ranked95, Is.GreaterThan(10 * many.Distance.Ranked99));
        }

        [Test]
        public void Distances_OfASmallCloud_MatchBruteForce()
        {
            var cloud = Positions(1500, 3);
            var sample = cloud.Take(100).ToArray();
            var error = Measure(cloud, sample)[0];
            using var reader = Reader(cloud);
            using var comparison = new CompareSamples(reader, new PictureOptions(), 160, 90);
            JobCoroutine.RunToEnd(comparison.Prepare(null));
            double unit = math.length(comparison.Bounds.Size);
            var distances = cloud.Select(p => sample.Min(s => math.distance(s, p)) / unit).OrderBy(d => d).ToArray();
            Assert.That(error.Distance.Rms, Is.EqualTo(Math.Sqrt(distances.Average(d => d * d))).Within(1e-12));
            Assert.That(error.Distance.Ranked95, Is.EqualTo(distances[1424]).Within(1e-12));
            Assert.That(error.Distance.Ranked99, Is.EqualTo(distances[1484]).Within(1e-12));
        }

        [Test]
        public void Find_PointsNotInTheCloud_AreNotFound()
        {
            var cloud = Positions(5000, 4);
            var errors = Measure(cloud, cloud.Take(1000).ToArray(), cloud.Take(1000).Concat(Positions(1000, 5)).ToArray());
            Assert.That(errors[0].LookedUp, Is.EqualTo(1000));
            Assert.That(errors[0].Found, Is.EqualTo(1000));
            Assert.That(errors[1].LookedUp, Is.EqualTo(2000));
            Assert.That(errors[1].Found, Is.EqualTo(1000));
        }

        [Test]
        public void Compare_AnyNumberOfThreads_GivesTheSameErrors()
        {
            var cloud = Positions(12_000, 6);
            var sample = Scrambled(cloud).Take(2000).ToArray();
            SampleError first = null;
            foreach (int workers in new[] { 1, 2, 7 })
            {
                using var threads = new WorkerCount(workers);
                var error = Measure(cloud, sample)[0];
                first ??= error;
                Assert.That(error.Distance, Is.EqualTo(first.Distance));
                Assert.That(error.Cells, Is.EqualTo(first.Cells));
                Assert.That(error.Picture, Is.EqualTo(first.Picture));
                for (int view = 0; view < 3; view++)
                    Assert.That(error.Views[view].Rgba.SequenceEqual(first.Views[view].Rgba), Is.True);
            }
        }

        [Test]
        public void Measure_PrefixOfABatch_EqualsASampleOfItsOwn()
        {
            var cloud = Positions(5000, 8);
            var alone = Measure(cloud, cloud.Take(700).ToArray())[0];
            using var reader = Reader(cloud);
            using var comparison = new CompareSamples(reader, new PictureOptions(), 160, 90);
            JobCoroutine.RunToEnd(comparison.Prepare(null));
            var error = new SampleError();
            JobCoroutine.RunToEnd(comparison.Measure(reader.Points, 700, reader.Info.Transform, null, error));
            Assert.That(error.Distance, Is.EqualTo(alone.Distance));
            Assert.That(error.Cells, Is.EqualTo(alone.Cells));
            Assert.That(error.Picture, Is.EqualTo(alone.Picture));
            Assert.That(error.PictureAtSameCount, Is.Null);
        }

        [Test]
        public void Measure_OddClouds_Succeeds()
        {
            var nothing = new double3[0];
            Assert.That(Measure(nothing, nothing)[0].Distance.Rms, Is.Zero);
            var equal = Enumerable.Repeat(new double3(3, 4, 5), 1000).ToArray();
            var one = Measure(equal, new[] { equal[0] }, nothing);
            Assert.That(one[0].Distance.Rms, Is.Zero);
            Assert.That(one[0].Cells.Uncovered256, Is.Zero);
            Assert.That(one[1].Distance.Rms, Is.EqualTo(double.PositiveInfinity));
            var broken = Positions(2000, 9);
            for (int i = 0; i < broken.Length; i += 3)
                broken[i][i % 2] = i % 2 == 0 ? double.NaN : double.PositiveInfinity;
            var error = Measure(broken, broken)[0];
            Assert.That(error.Distance.Rms, Is.Zero);
            Assert.That(error.Found, Is.EqualTo(error.LookedUp).And.GreaterThan(1000));
        }

        [Test]
        public void Cancel_InTheMiddle_FreesItsMemory([Values(1, 4, 9, 14)] int steps)
        {
            using var reader = Reader(Positions(20_000, 1));
            using var comparison = new CompareSamples(reader, new PictureOptions(), 160, 90);
            var work = new CoroutineStack(comparison.Prepare(null));
            for (int step = 0; step < steps; step++)
                Assert.That(work.MoveNext(), Is.True);
            work.Dispose();
        }
    }
}
