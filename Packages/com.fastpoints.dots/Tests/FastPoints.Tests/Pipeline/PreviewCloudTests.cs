using System.Collections.Generic;
using System.Linq;
using FastPoints.Base;
using FastPoints.Pipeline;
using FastPoints.Points;
using FastPoints.Preview;
using FastPoints.Tests.Support;
using NUnit.Framework;

namespace FastPoints.Tests.Pipeline
{
    public class PreviewCloudTests
    {
        [Test]
        public void WaveReady_OfBlocksReadDeeper_HandsEachWaveOut()
        {
            var batch = TestBatches.New(600_000, TestBatches.Xyz(AttributeType.Int32));
            for (int i = 0; i < batch.Count; i++)
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, axis == 2 ? 0 : axis == 1 ? i / 800 : i % 800);
            using var reader = new MemoryPointReader(batch, 10_000, fixedStride: false);
            using var preview = new PreviewCloud(reader, new PreviewOptions { Points = 200_000 });
            var waves = new List<SampleWave>();
            preview.WaveReady += (sample, wave) =>
            {
                waves.Add(wave);
                Assert.That(sample.Count, Is.EqualTo(wave.Points));
                // What is told of is spread over all of the cloud.
                var places = sample.Points.Column<int>(AttributeNames.Y);
                Assert.That(places.ToArray().Take(sample.Count).Max() - places.ToArray().Take(sample.Count).Min(), Is.GreaterThan(700));
            };
            WorkPump.RunToEnd(preview.TakeSample(new StageProgress()));
            // 2,000 and 20,000 of beginnings, a fifth, a half, all.
            Assert.That(waves, Has.Count.EqualTo(5));
            Assert.That(waves, Is.EqualTo(preview.Waves));
            Assert.That(waves.Select(w => w.Seconds), Is.Ordered);
            Assert.That(waves.Select(w => w.BytesRead), Is.Ordered);
            Assert.That(waves[waves.Count - 1].Points, Is.EqualTo(preview.Sample.Count));
        }
    }
}
