using System.Collections.Generic;
using System.Linq;
using FastPoints.Evaluation;
using FastPoints.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Evaluation
{
    public class RangeSamplerTests
    {
        static MemoryPointReader Numbered(int count, int pointsPerBlock, int readable = int.MaxValue)
        {
            var batch = TestBatches.New(count, PositionColumns.Attributes(AttributeType.Int32));
            for (int i = 0; i < count; i++)
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, i);
            return new MemoryPointReader(batch, pointsPerBlock, true, readable);
        }

        static int[] Take(MemoryPointReader reader, List<BlockRange> ranges, int wanted)
        {
            using var sampler = new RangeSampler(reader, ranges, wanted);
            JobCoroutine.RunToEnd(sampler.Run(new StageProgress()));
            using var points = sampler.TakePoints();
            Assert.That(sampler.Points, Is.Null);
            return points.Column<int>(AttributeNames.Z).ToArray().Take(points.Count).ToArray();
        }

        [Test]
        public void WholeSource_FewerWanted_IsEveryNth([Values(1, 7, 1000, 9999, 10_000, 20_000)] int wanted,
            [Values(1, 7)] int workers)
        {
            using var threads = new WorkerCount(workers);
            using var reader = Numbered(10_000, 777);
            int count = System.Math.Min(wanted, 10_000);
            Assert.That(Take(reader, RangeSampler.Whole(reader), wanted),
                Is.EqualTo(Enumerable.Range(0, count).Select(i => (int)(i * 10_000L / count))));
        }

        [Test]
        public void Poisson_SinglePoints_ChoosesTheSame()
        {
            using var reader = Numbered(10_000, 777);
            Assert.That(Take(reader, RangeSampler.Single(reader, 321), 321),
                Is.EqualTo(Take(reader, RangeSampler.Whole(reader), 321)));
        }

        [Test]
        public void First_OfASource_IsItsBeginning()
        {
            using var reader = Numbered(10_000, 777);
            Assert.That(Take(reader, RangeSampler.First(reader, 2345), 2345), Is.EqualTo(Enumerable.Range(0, 2345)));
            Assert.That(RangeSampler.First(reader, 1_000_000).Sum(r => (long)r.Count), Is.EqualTo(10_000));
        }

        [Test]
        public void Prefixes_OfEachBlock_AreTaken()
        {
            using var reader = Numbered(2500, 1000);
            Assert.That(Take(reader, RangeSampler.Prefixes(reader, 0.01), 1000),
                Is.EqualTo(Enumerable.Range(0, 10).Concat(Enumerable.Range(1000, 10)).Concat(Enumerable.Range(2000, 5))));
            Assert.That(Take(reader, RangeSampler.Prefixes(reader, 1e-9), 1000), Is.EqualTo(new[] { 0, 1000, 2000 }));
        }

        [Test]
        public void Sample_TruncatedSource_GivesTheExistingPoints()
        {
            using var reader = Numbered(10_000, 777, 4321);
            Assert.That(Take(reader, RangeSampler.Whole(reader), 100), Is.EqualTo(Enumerable.Range(0, 44).Select(i => i * 100)));
        }

        [Test]
        public void NothingToTake_IsEmpty()
        {
            using var reader = Numbered(0, 777);
            Assert.That(Take(reader, RangeSampler.Whole(reader), 100), Is.Empty);
            Assert.That(RangeSampler.Single(reader, 0), Is.Empty);
        }

        [Test]
        public void Cancel_InTheMiddle_FreesItsMemory()
        {
            using var reader = Numbered(100_000, 100);
            using var sampler = new RangeSampler(reader, RangeSampler.Whole(reader), 1000);
            var work = new CoroutineStack(sampler.Run(null));
            for (int step = 0; step < 5; step++)
                Assert.That(work.MoveNext(), Is.True);
            work.Dispose();
        }
    }
}
