using System.Collections.Generic;
using System.Linq;
using FastPoints.Sampling;
using NUnit.Framework;
using Unity.Jobs;

namespace FastPoints.Tests.Sampling
{
    public class ManyBlocksTests
    {
        [Test]
        public void FirstWaves_TenMillionBlocks_VisitFewOfThem()
        {
            using var reader = new VirtualReader(100_000_000, 10, false);
            Assert.That(reader.BlockCount, Is.EqualTo(10_000_000));
            using var sampler = new PreviewWaveSampler(reader, 200_000, 1);
            var waves = new List<PreviewSample.Wave>();
            sampler.WaveReady += waves.Add;
            JobCoroutine.RunToEnd(sampler.Run(0, new StageProgress()));
            Assert.That(waves.Select(w => w.Points), Is.EqualTo(new[] { 2_000, 20_000, 200_000 }));
            // Blocks of ten points are read as a whole: no more of them than it takes.
            Assert.That(waves[0].BytesRead, Is.LessThanOrEqualTo(12 * 2_100));
            var tenths = new int[10];
            foreach (int y in sampler.Sample.Points.Column<int>("Y").ToArray().Take(sampler.Sample.Count))
                tenths[(long)y * 150_000 / 10_000_000]++;
            Assert.That(tenths, Has.All.EqualTo(20_000).Within(400));
        }

        [Test]
        public void Waves_OfMoreBlocksThanStates_ComeBeforeAFifthWhereThatIsLong()
        {
            using var reader = new VirtualReader(60_000_000, 100_000, false);
            using var first = new PreviewWaveSampler(reader, 20_000, 1);
            JobCoroutine.RunToEnd(first.Run(0, new StageProgress()));
            using var refining = new RefiningSampler(reader, 100_000, 1, first.Sample, first.Sample.Bounds);
            var shares = new List<double>();
            refining.WaveReady += wave => shares.Add((refining.Sample.Count - refining.Sample.PlaceholderCount) / 100_000.0);
            var coroutine = new JobCoroutine(refining.Run(0, new StageProgress()));
            while (shares.Count < 2 && !coroutine.Tick(10))
                JobHandle.ScheduleBatchedJobs();
            coroutine.Cancel();
            Assert.That(shares[0], Is.EqualTo(0.05).Within(0.005));
            Assert.That(shares[1], Is.EqualTo(0.1).Within(0.005));
        }
    }
}
