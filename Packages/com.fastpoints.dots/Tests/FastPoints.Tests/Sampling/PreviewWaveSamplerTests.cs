using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Sources;
using FastPoints.Tests.Las;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Sampling
{
    [Category("Smoke")]
    public class PreviewWaveSamplerTests : FolderTests
    {
        string FilePath => Folder.File("cloud");

        PointReader Numbered(int count, bool isBigEndian = false)
        {
            var bytes = new List<byte>(Encoding.ASCII.GetBytes("ply\nformat binary_" + (isBigEndian ? "big" : "little")
                + "_endian 1.0\nelement vertex " + count
                + "\nproperty int x\nproperty int y\nproperty int z\n"
                + "property uchar class\nproperty ushort intensity\nend_header\n"));
            for (int i = 0; i < count; i++)
            {
                Add(i, 4);
                Add(-i, 4);
                Add(i % 1000, 4);
                Add(7, 1);
                Add(i % 60_000, 2);
            }
            File.WriteAllBytes(FilePath, bytes.ToArray());
            return PointReaders.Open(FilePath);

            void Add(int value, int size)
            {
                for (int i = 0; i < size; i++)
                    bytes.Add((byte)(value >> 8 * (isBigEndian ? size - 1 - i : i)));
            }
        }

        static PreviewSample Take(PointReader reader, int wanted, int slots = 0, uint seed = 1,
            List<PreviewSample.Wave> waves = null)
        {
            using var sampler = new PreviewWaveSampler(reader, wanted, seed);
            sampler.WaveReady += wave => waves?.Add(wave);
            JobCoroutine.RunToEnd(sampler.Run(slots, new StageProgress()));
            return sampler.TakeSample();
        }

        static int[] Indices(PreviewSample sample)
        {
            var column = sample.Points.Column<int>(AttributeNames.X);
            var y = sample.Points.Column<int>(AttributeNames.Y);
            var intensity = sample.Points.Column<ushort>(AttributeNames.Intensity);
            var indices = new int[sample.Count];
            for (int i = 0; i < indices.Length; i++)
            {
                indices[i] = column[i];
                Assert.That(y[i], Is.EqualTo(-column[i]));
                Assert.That((int)intensity[i], Is.EqualTo(column[i] % 60_000));
            }
            return indices;
        }

        [Test]
        public void Waves_OfAFile_ArePrefixesOfTheSampleSpreadOverTheFile()
        {
            using var reader = Numbered(400_000);
            var waves = new List<PreviewSample.Wave>();
            using var sample = Take(reader, 50_000, 3, 1, waves);
            var indices = Indices(sample);
            Assert.That(indices.Length, Is.EqualTo(50_000));
            Assert.That(new HashSet<int>(indices), Has.Count.EqualTo(50_000));
            Assert.That(waves, Has.Count.EqualTo(3));
            Assert.That(waves[0].Points, Is.EqualTo(2000).Within(16));
            Assert.That(waves[1].Points, Is.EqualTo(20_000).Within(16));
            Assert.That(waves[2].Points, Is.EqualTo(50_000));
            foreach (var wave in waves)
            {
                // Each tenth of the file has a tenth of the wave, within two ranges.
                var tenths = new int[10];
                for (int i = 0; i < wave.Points; i++)
                    tenths[indices[i] / 40_000]++;
                Assert.That(tenths, Has.All.EqualTo(wave.Points / 10).Within(Math.Max(48, wave.Points / 50)));
            }
            Assert.That(sample.IsFullScan, Is.False);
            Assert.That(sample.Fraction, Is.EqualTo(0.125));
        }

        [Test]
        public void Waves_Ready_ComeBeforeTheRestAndDoNotChange()
        {
            using var reader = Numbered(100_000);
            using var sampler = new PreviewWaveSampler(reader, 30_000, 1);
            var first = new List<int>();
            int raised = 0;
            sampler.WaveReady += wave =>
            {
                raised++;
                Assert.That(sampler.Sample.Count, Is.EqualTo(wave.Points));
                var indices = Indices(sampler.Sample);
                for (int i = 0; i < first.Count; i++)
                    Assert.That(indices[i], Is.EqualTo(first[i]));
                first = new List<int>(indices);
            };
            JobCoroutine.RunToEnd(sampler.Run(4, null));
            Assert.That(raised, Is.EqualTo(3));
            Assert.That(first, Has.Count.EqualTo(30_000));
        }

        static int[] IndicesWithAnySlotsAndWorkers(PointReader reader)
        {
            int[] expected = null;
            foreach (int workers in new[] { 1, 2, 7 })
                foreach (int slots in new[] { 1, 2, 9 })
                {
                    using var count = new WorkerCount(workers);
                    using var sample = Take(reader, 23_456, slots);
                    expected ??= Indices(sample);
                    Assert.That(Indices(sample), Is.EqualTo(expected));
                }
            return expected;
        }

        [Test]
        public void Sample_AnySlotsAndWorkers_IsTheSame()
        {
            using var reader = Numbered(120_000);
            int[] expected = IndicesWithAnySlotsAndWorkers(reader);
            using var other = Take(reader, 23_456, 3, 2);
            Assert.That(Indices(other), Is.Not.EqualTo(expected));
        }

        [TestCase(1), TestCase(15), TestCase(16), TestCase(1999), TestCase(9000), TestCase(10_000), TestCase(50_000)]
        public void Sample_OfAnySize_HasExactlyAsManyDistinctPoints(int wanted)
        {
            using var reader = Numbered(10_000);
            using var sample = Take(reader, wanted, 4);
            Assert.That(sample.Count, Is.EqualTo(Math.Min(wanted, 10_000)));
            Assert.That(new HashSet<int>(Indices(sample)), Has.Count.EqualTo(sample.Count));
            Assert.That(sample.HasAllPoints, Is.EqualTo(wanted >= 10_000));
        }

        [Test]
        public void Sample_OfABigEndianFile_MatchesTheLittleEndianOne()
        {
            int[] little;
            using (var reader = Numbered(30_000))
            using (var sample = Take(reader, 4000))
                little = Indices(sample);
            using (var reader = Numbered(30_000, true))
            using (var sample = Take(reader, 4000))
                Assert.That(Indices(sample), Is.EqualTo(little));
        }

        [Test]
        public void Sample_OfEachLasFormat_HasTheFilesPoints([Range(0, 10)] int format)
        {
            using var file = new LasTestFile { Minor = 4, Format = format }.RandomPoints(20_000).Save();
            using var reader = PointReaders.Open(file.Path);
            using var sample = Take(reader, 3000);
            var all = new Dictionary<(int, int, int), int>();
            using (var whole = Take(reader, 20_000))
            {
                Assert.That(whole.Count, Is.EqualTo(20_000));
                using var exact = new FileOrderSampler(reader, 20_000, 1);
                JobCoroutine.RunToEnd(exact.Run(0, null));
                using var reference = exact.TakeSample();
                Count(reference, 1);
                Count(whole, -1);
                Assert.That(all.Values, Has.All.EqualTo(0));
                Count(reference, 1);
            }
            Count(sample, -1);
            Assert.That(all.Values, Has.All.GreaterThanOrEqualTo(0));

            void Count(PreviewSample of, int by)
            {
                var x = of.Points.Column<int>(AttributeNames.X);
                var y = of.Points.Column<int>(AttributeNames.Y);
                var intensity = of.Points.Column<ushort>(AttributeNames.Intensity);
                for (int i = 0; i < of.Count; i++)
                {
                    var key = (x[i], y[i], (int)intensity[i]);
                    all.TryGetValue(key, out int count);
                    all[key] = count + by;
                }
            }
        }

        [Test]
        public void Sample_NonFinitePositions_AreSkippedAndCounted()
        {
            var bytes = new List<byte>(Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\nelement vertex 5000\n"
                + "property double x\nproperty double y\nproperty double z\nend_header\n"));
            int bad = 0;
            for (int i = 0; i < 5000; i++)
            {
                var position = new double3(i, 1, 2);
                if (i % 7 == 3)
                {
                    position[i % 3] = i % 2 == 0 ? double.NaN : double.NegativeInfinity;
                    bad++;
                }
                for (int axis = 0; axis < 3; axis++)
                    bytes.AddRange(BitConverter.GetBytes(position[axis]));
            }
            File.WriteAllBytes(FilePath, bytes.ToArray());
            using var reader = PointReaders.Open(FilePath);
            var waves = new List<PreviewSample.Wave>();
            using var sample = Take(reader, 5000, 2, 1, waves);
            Assert.That(sample.NonFiniteCount, Is.EqualTo(bad));
            Assert.That(sample.Count, Is.EqualTo(5000 - bad));
            Assert.That(sample.HasAllPoints, Is.True);
            Assert.That(sample.Bounds.Min, Is.EqualTo(new double3(0, 1, 2)));
            Assert.That(waves[waves.Count - 1].Points, Is.EqualTo(sample.Count));
            var seen = new HashSet<double>();
            var x = sample.Points.Column<double>(AttributeNames.X);
            for (int i = 0; i < sample.Count; i++)
                Assert.That(seen.Add(x[i]) && (int)x[i] % 7 != 3, Is.True);
        }

        [Test]
        public void Sample_ShrunkFile_FailsAndReportsIt()
        {
            using var reader = Numbered(200_000);
            using (var stream = new FileStream(FilePath, FileMode.Open, FileAccess.Write, FileShare.ReadWrite))
                stream.SetLength(stream.Length / 2);
            using var sampler = new PreviewWaveSampler(reader, 10_000, 1);
            Assert.That(() => JobCoroutine.RunToEnd(sampler.Run(3, null)),
                Throws.TypeOf<PointCloudException>().With.Property("Code").EqualTo(FailureCode.Truncated));
        }

        [Test]
        public void Sample_CancelledAnywhere_FreesItsMemory()
        {
            using var reader = Numbered(50_000);
            for (int steps = 0; steps < 40; steps += 3)
            {
                using var sampler = new PreviewWaveSampler(reader, 25_000, 1);
                var work = new CoroutineStack(sampler.Run(3, null));
                for (int step = 0; step < steps && work.MoveNext(); step++) { }
                work.Dispose();
            }
        }

        static MemoryPointReader Blocks(int count, int pointsPerBlock) =>
            new MemoryPointReader(TestBatches.Numbered(count), pointsPerBlock, fixedStride: false);

        [Test]
        public void Prefixes_OfManyBlocks_ComeFromAllOfTheSourceInEachWave()
        {
            using var reader = Blocks(400_000, 1000);
            var waves = new List<PreviewSample.Wave>();
            using var sample = Take(reader, 100_000, 3, 1, waves);
            var indices = Indices(sample);
            Assert.That(new HashSet<int>(indices), Has.Count.EqualTo(100_000));
            Assert.That(waves, Has.Count.EqualTo(3));
            foreach (var wave in waves)
            {
                var tenths = new int[10];
                for (int i = 0; i < wave.Points; i++)
                    tenths[indices[i] / 40_000]++;
                Assert.That(tenths, Has.All.EqualTo(wave.Points / 10).Within(wave.Points * 0.06));
            }
            // The first quarter of each block, and nothing else.
            foreach (int index in indices)
                Assert.That(index % 1000, Is.LessThan(251));
        }

        [TestCase(1, 100), TestCase(49, 100), TestCase(2000, 100), TestCase(2100, 7), TestCase(9999, 1)]
        [TestCase(10_000, 333), TestCase(20_000, 10_000)]
        public void Prefixes_OfAnySize_AreExactlyAsManyDistinctPoints(int wanted, int pointsPerBlock)
        {
            using var reader = Blocks(10_000, pointsPerBlock);
            using var sample = Take(reader, wanted, 2);
            Assert.That(sample.Count, Is.EqualTo(Math.Min(wanted, 10_000)));
            Assert.That(new HashSet<int>(Indices(sample)), Has.Count.EqualTo(sample.Count));
        }

        [Test]
        public void Prefixes_AnySlotsAndWorkers_AreTheSame()
        {
            using var reader = Blocks(60_000, 777);
            IndicesWithAnySlotsAndWorkers(reader);
        }

        [Test]
        public void Prefixes_TruncatedSource_GivesTheExistingPoints()
        {
            using var whole = Blocks(10_000, 100);
            using var reader = new MemoryPointReader(whole.Points, 100, false, 4_321);
            using var sample = Take(reader, 5_000, 2);
            Assert.That(sample.Count, Is.EqualTo(43 * 50 + 21));
            Assert.That(Indices(sample), Has.All.LessThan(4_321));
        }
    }
}
