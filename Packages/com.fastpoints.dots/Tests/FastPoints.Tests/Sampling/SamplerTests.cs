using FastPoints.Sampling;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Sampling
{
    public class SamplerTests
    {
        static PreviewSample Uniform(MemoryPointReader reader, int wanted, int slots, uint seed = 1)
        {
            using var sampler = new FileOrderSampler(reader, wanted, seed);
            JobCoroutine.RunToEnd(sampler.Run(slots, new StageProgress()));
            return sampler.TakeSample();
        }

        static int[] Indices(PreviewSample sample)
        {
            var column = sample.Points.Column<int>(AttributeNames.X);
            var intensity = sample.Points.Column<ushort>(AttributeNames.Intensity);
            var indices = new int[sample.Count];
            for (int i = 0; i < indices.Length; i++)
            {
                indices[i] = column[i];
                Assert.That((int)intensity[i], Is.EqualTo(column[i] % 60_000));
            }
            return indices;
        }

        [TestCase(1), TestCase(999), TestCase(50_000)]
        public void Uniform_FewerWanted_TakesExactlyOneOfEachStratum(int wanted)
        {
            using var reader = new MemoryPointReader(TestBatches.Numbered(50_000), 3000);
            using var sample = Uniform(reader, wanted, 3);
            var indices = Indices(sample);
            var strata = new SampleStrata(50_000, wanted, 1);
            Assert.That(indices.Length, Is.EqualTo(wanted));
            for (int i = 0; i < wanted; i++)
                Assert.That(strata.StratumOf(indices[i]), Is.EqualTo(i));
            Assert.That(sample.PointsInSource, Is.EqualTo(50_000));
            Assert.That(sample.Fraction, Is.EqualTo(wanted / 50_000.0));
            Assert.That(sample.IsFullScan, Is.True);
            Assert.That(sample.Points.Schema.Has(AttributeNames.GpsTime), Is.False);
        }

        [Test]
        public void Uniform_MoreWantedThanAvailable_IsTheWholeSourceInOrder()
        {
            using var reader = new MemoryPointReader(TestBatches.Numbered(1234), 100);
            using var sample = Uniform(reader, 5000, 4);
            var indices = Indices(sample);
            Assert.That(indices.Length, Is.EqualTo(1234));
            for (int i = 0; i < indices.Length; i++)
                Assert.That(indices[i], Is.EqualTo(i));
            Assert.That(sample.HasAllPoints, Is.True);
            Assert.That(sample.Bounds.Max, Is.EqualTo(new double3(1233, 0, 999)));
        }

        [Test]
        public void Samplers_AnySlotsWorkersAndBlocks_ChooseTheSamePoints()
        {
            int[] uniform = null;
            foreach (int workers in new[] { 1, 2, 7 })
                foreach (int slots in new[] { 1, 2, 9 })
                {
                    using var count = new WorkerCount(workers);
                    using var reader = new MemoryPointReader(TestBatches.Numbered(40_000), 1000 * slots + 17);
                    using var sample = Uniform(reader, 3000, slots);
                    uniform ??= Indices(sample);
                    Assert.That(Indices(sample), Is.EqualTo(uniform));
                }
        }

        [Test]
        public void Samplers_AnotherSeed_ChooseOtherPoints()
        {
            using var reader = new MemoryPointReader(TestBatches.Numbered(40_000), 4096);
            using var one = Uniform(reader, 1000, 2, 1);
            using var other = Uniform(reader, 1000, 2, 2);
            Assert.That(Indices(one), Is.Not.EqualTo(Indices(other)));
        }

        [Test]
        public void Samplers_NonFinitePositions_AreSkippedAndCounted()
        {
            var positions = new double3[5000];
            int bad = 0;
            for (int i = 0; i < positions.Length; i++)
            {
                positions[i] = new double3(i, 1, 2);
                if (i % 7 != 3)
                    continue;
                positions[i][i % 3] = i % 2 == 0 ? double.NaN : double.NegativeInfinity;
                bad++;
            }
            using var reader = new MemoryPointReader(TestBatches.OfPositions(positions), 600);
            using var sample = Uniform(reader, 10_000, 3);
            Assert.That(sample.NonFiniteCount, Is.EqualTo(bad));
            Assert.That(sample.Count, Is.EqualTo(5000 - bad));
            Assert.That(sample.HasAllPoints, Is.True);
            var x = sample.Points.Column<double>(AttributeNames.X);
            int next = 0;
            for (int i = 0; i < positions.Length; i++)
                if (i % 7 != 3)
                    Assert.That(x[next++], Is.EqualTo(i));
            Assert.That(sample.Bounds.IsFinite, Is.True);
        }

        [Test]
        public void Samplers_TruncatedSource_GiveTheExistingPoints()
        {
            using var reader = new MemoryPointReader(TestBatches.Numbered(10_000), 999, true, 4321);
            using var sample = Uniform(reader, 100_000, 3);
            Assert.That(sample.Count, Is.EqualTo(4321));
            Assert.That(sample.PointsInSource, Is.EqualTo(4321));
            Assert.That(Indices(sample)[4320], Is.EqualTo(4320));
        }

        [Test]
        public void Samplers_NoPoints_GiveAnEmptySample()
        {
            using var reader = new MemoryPointReader(TestBatches.Numbered(0), 1000);
            using var uniform = Uniform(reader, 100, 2);
            Assert.That(uniform.Count, Is.EqualTo(0));
            Assert.That(uniform.Bounds.IsEmpty, Is.True);
        }

        [Test]
        public void Samplers_SourceWithoutPositions_IsUnsupported()
        {
            var batch = TestBatches.New(3, new[] { new PointAttribute("Value", AttributeType.UInt8) });
            using var reader = new MemoryPointReader(batch, 10);
            Assert.That(() => new FileOrderSampler(reader, 10, 1),
                Throws.TypeOf<PointCloudException>().With.Property("Code").EqualTo(FailureCode.Unsupported));
        }

        [Test]
        public void Samplers_CancelledHalfway_FreeTheirMemory()
        {
            using var reader = new MemoryPointReader(TestBatches.Numbered(50_000), 500);
            using var sampler = new FileOrderSampler(reader, 5000, 1);
            var work = new CoroutineStack(sampler.Run(4, null));
            for (int step = 0; step < 10; step++)
                Assert.That(work.MoveNext(), Is.True);
            work.Dispose();
            Assert.That(sampler.TakeSample(), Is.Null);
        }

        [Test]
        public void MaxPoints_LargestSample_StaysWithinItsMemory()
        {
            using var batch = TestBatches.Numbered(1);
            int max = PreviewSample.MaxPoints(batch.Schema);
            Assert.That((long)max * (batch.Schema.BytesPerPoint + 1), Is.LessThanOrEqualTo(PreviewSample.MaxBytes));
            Assert.That(max, Is.GreaterThan(1_000_000));
        }
    }
}
