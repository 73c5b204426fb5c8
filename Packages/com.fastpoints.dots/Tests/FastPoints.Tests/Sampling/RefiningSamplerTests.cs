using System.Collections.Generic;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Sampling;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Sampling
{
    public class RefiningSamplerTests
    {
        const int Edge = 200;

        /// <summary>Four points above each other at each place of a square of <see cref="Edge"/>, square after square of a tenth
        /// of the edge: each is a block of 1,600 points.</summary>
        static MemoryPointReader Square(int pointsPerBlock, int pointsReadable = int.MaxValue)
        {
            var batch = TestBatches.New(4 * Edge * Edge, AttributeType.Int32,
                new PointAttribute(AttributeNames.Intensity, AttributeType.UInt16));
            for (int i = 0; i < batch.Count; i++)
            {
                int square = i / 1600, index = i % 400;
                TestBatches.Set(batch, 0, i, square % 10 * 20 + index % 20);
                TestBatches.Set(batch, 1, i, square / 10 * 20 + index / 20);
                TestBatches.Set(batch, 2, i, i % 1600 / 400);
                TestBatches.Set(batch, 3, i, i % 60_000);
            }
            return new MemoryPointReader(batch, pointsPerBlock, fixedStride: false, pointsReadable);
        }

        static BoundsGeo Bounds => new BoundsGeo(default, new double3(Edge, Edge, 4));

        static (int, int, int)[] Positions(PreviewSample sample)
        {
            var x = sample.Points.Column<int>(AttributeNames.X);
            var y = sample.Points.Column<int>(AttributeNames.Y);
            var z = sample.Points.Column<int>(AttributeNames.Z);
            return Enumerable.Range(0, sample.Count).Select(i => (x[i], y[i], z[i])).ToArray();
        }

        static List<(int, int, int)[]> Waves(PointReader reader, int wanted, int slots, List<int> placeholders = null)
        {
            var waves = new List<(int, int, int)[]>();
            using var sampler = new RefiningSampler(reader, wanted, 1, null, Bounds);
            sampler.WaveReady += wave =>
            {
                Assert.That(wave.Points, Is.EqualTo(sampler.Sample.Count));
                waves.Add(Positions(sampler.Sample));
                placeholders?.Add(sampler.Sample.PlaceholderCount);
            };
            JobCoroutine.RunToEnd(sampler.Run(slots, new StageProgress()));
            return waves;
        }

        [TestCase(1600), TestCase(1777), TestCase(160_000), TestCase(500)]
        public void Sample_AtTheEnd_EqualsTheFullScans(int pointsPerBlock)
        {
            using var reader = Square(pointsPerBlock);
            using var exact = new FileOrderSampler(reader, 30_000, 5);
            JobCoroutine.RunToEnd(exact.Run(0, null));
            using var expected = exact.TakeSample();
            using var sampler = new RefiningSampler(reader, 30_000, 5, null, Bounds);
            JobCoroutine.RunToEnd(sampler.Run(3, null));
            using var sample = sampler.TakeSample();
            Assert.That(Positions(sample), Is.EqualTo(Positions(expected)));
            Assert.That(sample.Bounds, Is.EqualTo(expected.Bounds));
            Assert.That(sample.IsFullScan, Is.True);
            Assert.That(sample.PlaceholderCount, Is.Zero);
            Assert.That(sample.PointsInSource, Is.EqualTo(160_000));
            Assert.That(sampler.Waves, Has.Count.EqualTo(3));
        }

        [TestCase(1600), TestCase(500)]
        public void Waves_AnySlotsAndWorkers_AreTheSame(int pointsPerBlock)
        {
            using var reader = Square(pointsPerBlock);
            List<(int, int, int)[]> expected = null;
            foreach (int workers in new[] { 1, 2, 7 })
                foreach (int slots in new[] { 1, 3, 9 })
                {
                    using var count = new WorkerCount(workers);
                    var waves = Waves(reader, 20_000, slots);
                    expected ??= waves;
                    Assert.That(waves, Is.EqualTo(expected));
                }
        }

        [Test]
        public void Waves_BeforeTheEnd_HoldTheScansPointsAndNoPointTwice()
        {
            using var reader = Square(1600);
            var placeholders = new List<int>();
            var waves = Waves(reader, 20_000, 2, placeholders);
            var final = new HashSet<(int, int, int)>(waves[2]);
            for (int wave = 0; wave < 2; wave++)
            {
                Assert.That(new HashSet<(int, int, int)>(waves[wave]), Has.Count.EqualTo(waves[wave].Length));
                int chosen = waves[wave].Count(final.Contains);
                // A point that stands in for others may be one of the scan's that has not been come to.
                Assert.That(chosen, Is.InRange(waves[wave].Length - placeholders[wave], waves[wave].Length));
            }
            // An eighth of the read points is in the scan's sample.
            Assert.That(waves[1].Length - placeholders[1], Is.EqualTo(10_000).Within(600));
        }

        [Test]
        public void Waves_OfBlocksTooManyForStates_ShowTheFirstSampleWhereNoBlockIsRead()
        {
            using var reader = Square(500);
            using var first = new PreviewWaveSampler(reader, 8000, 1);
            JobCoroutine.RunToEnd(first.Run(2, null));
            using var before = first.TakeSample();
            var places = new HashSet<(int, int)>(Positions(before).Select(p => (p.Item1 / 10, p.Item2 / 10)));
            using var sampler = new RefiningSampler(reader, 20_000, 1, before, Bounds);
            int waves = 0;
            sampler.WaveReady += wave =>
            {
                var positions = Positions(sampler.Sample);
                Assert.That(new HashSet<(int, int, int)>(positions), Has.Count.EqualTo(positions.Length));
                if (++waves < 3)
                    Assert.That(places.Except(positions.Select(p => (p.Item1 / 10, p.Item2 / 10))), Is.Empty);
            };
            JobCoroutine.RunToEnd(sampler.Run(2, null));
            Assert.That(waves, Is.EqualTo(3));
            Assert.That(places, Has.Count.GreaterThan(250));
        }

        [Test]
        public void Waves_AtAHalf_LeaveNoReadRegionEmpty()
        {
            // One point in 20 is anywhere in the square, all others are in a tenth of its edges.
            var batch = TestBatches.New(160_000, PositionColumns.Attributes(AttributeType.Int32));
            var random = new Unity.Mathematics.Random(3);
            for (int i = 0; i < batch.Count; i++)
            {
                int edge = i % 20 == 7 ? 20_000 : 2000;
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, axis == 2 ? 0 : random.NextInt(edge));
            }
            using var reader = new MemoryPointReader(batch, 1600, fixedStride: false);
            var waves = new List<(int, int, int)[]>();
            using var sampler = new RefiningSampler(reader, 20_000, 1, null,
                new BoundsGeo(default, new double3(20_000, 20_000, 1)));
            sampler.WaveReady += wave => waves.Add(Positions(sampler.Sample));
            JobCoroutine.RunToEnd(sampler.Run(2, null));
            // A 32nd of the edge: 1,024 cells; of the 4,000 points that were read anywhere about a tenth is the scan's.
            int[] cells = waves.Select(w => w.Select(p => (p.Item1 / 625, p.Item2 / 625)).Distinct().Count()).ToArray();
            Assert.That(cells[1], Is.GreaterThan(980));
            Assert.That(waves[1].Count(p => p.Item1 > 2000 || p.Item2 > 2000), Is.GreaterThan(3500));
            Assert.That(waves[2].Count(p => p.Item1 > 2000 || p.Item2 > 2000), Is.EqualTo(1000).Within(150));
            Assert.That(waves[1], Has.Length.LessThanOrEqualTo(20_000));
        }

        [Test]
        public void Sample_TruncatedSource_SamplesTheExistingPoints()
        {
            using var reader = Square(1600, 100_000);
            using var sampler = new RefiningSampler(reader, 16_000, 1, null, Bounds);
            JobCoroutine.RunToEnd(sampler.Run(3, null));
            using var sample = sampler.TakeSample();
            Assert.That(sample.Count, Is.EqualTo(10_000).Within(1));
            Assert.That(sample.PointsInSource, Is.EqualTo(100_000));
        }

        [TestCase(0), TestCase(1)]
        public void Sample_OfFewPoints_Exists(int wanted)
        {
            using var reader = Square(1600);
            Assert.That(Waves(reader, wanted, 2)[2], Has.Length.EqualTo(wanted));
        }

        [Test]
        public void Sample_WithoutExtent_IsTheFullScans()
        {
            using var reader = Square(1600);
            using var sampler = new RefiningSampler(reader, 1000, 1, null, BoundsGeo.Empty);
            JobCoroutine.RunToEnd(sampler.Run(3, null));
            Assert.That(sampler.Sample.Count, Is.EqualTo(1000));
        }

        [Test]
        public void Run_CancelledAnywhere_FreesItsMemoryAndKeepsTheLastWave()
        {
            using var reader = Square(1600);
            for (int steps = 0; steps < 400; steps += 23)
            {
                using var sampler = new RefiningSampler(reader, 16_000, 1, null, Bounds);
                var work = new CoroutineStack(sampler.Run(3, null));
                for (int step = 0; step < steps && work.MoveNext(); step++) { }
                work.Dispose();
                Assert.That(sampler.Sample?.Count ?? 0,
                    Is.EqualTo(sampler.Waves.Count == 0 ? 0 : sampler.Waves[sampler.Waves.Count - 1].Points));
            }
        }

        [Test]
        public void Run_WhilePaused_ReadsNothingUntilResumed()
        {
            using var reader = Square(1600);
            using var sampler = new RefiningSampler(reader, 16_000, 1, null, Bounds) { IsPaused = true };
            var work = new CoroutineStack(sampler.Run(3, null));
            for (int step = 0; step < 1000; step++)
            {
                Assert.That(work.MoveNext(), Is.True);
                work.Current.Complete();
            }
            Assert.That(sampler.Waves, Is.Empty);
            sampler.IsPaused = false;
            while (work.MoveNext())
                work.Current.Complete();
            Assert.That(sampler.Waves, Has.Count.EqualTo(3));
        }
    }
}
