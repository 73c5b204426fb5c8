using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Las;
using FastPoints.Picture;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Sources;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Picture
{
    public class PreviewExtremesTests : FolderTests
    {
        const int LasRecordBytes = 20;

        string FilePath => Folder.File("cloud.laz");

        static PreviewPicture Take(PointReader reader, PreviewOptions options)
        {
            var preview = new PreviewPicture(reader, options);
            JobCoroutine.RunToEnd(preview.Run(new StageProgress()));
            return preview;
        }

        static int[] Xs(PreviewSample sample) =>
            sample.Points.Column<int>(AttributeNames.X).ToArray().Take(sample.Count).ToArray();

        static string[] Warnings(PointReader reader) => reader.Info.Warnings.Select(w => w.Text).ToArray();

        /// <summary>A LAS file of format 0 that claims so many points, and has room for them; x counts those that are
        /// written.</summary>
        void WriteLas(long points, int stride, Func<long, bool> written)
        {
            using var file = new FileStream(FilePath, FileMode.Create, FileAccess.Write, FileShare.ReadWrite);
            var header = new LasHeader
            {
                VersionMinor = 4,
                PointFormat = 0,
                RecordBytes = LasRecordBytes,
                HeaderBytes = LasHeader.BytesOf(4),
                PointsOffset = (uint)LasHeader.BytesOf(4),
                Count64 = (ulong)points,
                LegacyCount = (uint)Math.Min(points, uint.MaxValue),
                Scale = new double3(0.01, 0.01, 0.01),
                Max = new double3(1e6, 1e6, 1e6),
                SystemIdentifier = "",
                GeneratingSoftware = "FastPoints tests",
            };
            var bytes = header.ToBytes();
            file.Write(bytes, 0, bytes.Length);
            file.SetLength(bytes.Length + points * LasRecordBytes);
            var record = new byte[LasRecordBytes];
            for (long i = 0; i < points; i += stride)
            {
                if (!written(i))
                    continue;
                BitConverter.GetBytes((int)i + 1).CopyTo(record, 0);
                BitConverter.GetBytes((int)(i / 1000)).CopyTo(record, 4);
                file.Position = bytes.Length + i * LasRecordBytes;
                file.Write(record, 0, record.Length);
            }
        }

        [Test]
        public void Preview_TruncatedChunkOf100MillionPoints_ShowsTheExistingPoints()
        {
            var writer = new LazFileWriter { PointFormat = 3, ChunkPoints = new int[0], Claims = 100_000_000 };
            File.WriteAllBytes(FilePath, writer.Write(LazRecords.Make(3, 0, 5000, 5)));
            using var reader = PointReaders.Open(FilePath);
            using var preview = Take(reader, new PreviewOptions { Points = 2000 });
            Assert.That(preview.Sample.Count, Is.InRange(1, 2000));
            Assert.That(preview.Image, Is.Not.Null);
            Assert.That(Warnings(reader), Is.Not.Empty);
        }

        [Test, Category("Long"), Explicit]
        public void Preview_ManyChunksOfTwoPoints_EndsWithTheFullScansPoints() =>
            Preview_ChunksOfOneOrTwoPoints_EndsWithTheFullScansPoints(2, 100_000);

        [TestCase(1, 3000), TestCase(2, 12_000)]
        public void Preview_ChunksOfOneOrTwoPoints_EndsWithTheFullScansPoints(int chunkPoints, int points)
        {
            var writer = new LazFileWriter { PointFormat = 0, ChunkPoints = new[] { chunkPoints } };
            File.WriteAllBytes(FilePath, writer.Write(LazRecords.Make(0, 0, points, 5)));
            using var exactReader = PointReaders.Open(FilePath);
            using var exact = Take(exactReader, new PreviewOptions { Points = 1000, Exact = true });
            using var reader = PointReaders.Open(FilePath);
            Assert.That(reader.BlockCount, Is.EqualTo(points / chunkPoints));
            using var preview = Take(reader, new PreviewOptions { Points = 1000 });
            Assert.That(Xs(preview.Sample), Is.EqualTo(Xs(exact.Sample)));
            Assert.That(Warnings(reader), Is.Empty);
        }

        [Test]
        public void Preview_SparseFileWithHoles_SamplesDataAndHoles()
        {
            // 400 MB, of which every tenth segment of 50,000 records has points: the others read as zeros.
            WriteLas(20_000_000, 100, i => i / 50_000 % 10 == 3);
            using var reader = PointReaders.Open(FilePath);
            long bytes = long.MaxValue;
            // How much is read along depends on how quick reads seem: on a busy machine the quickest of a few tries counts.
            for (int i = 0; i < 6 && bytes >= 40_000_000; i++)
            {
                using var preview = Take(reader, new PreviewOptions { Points = 100_000 });
                Assert.That(preview.Sample.Count, Is.EqualTo(100_000));
                // One record in a hundred of a tenth of the file.
                Assert.That(Xs(preview.Sample).Count(x => x > 0), Is.EqualTo(100).Within(60));
                bytes = Math.Min(bytes, preview.Sample.BytesRead);
            }
            Assert.That(bytes, Is.LessThan(40_000_000));
        }

        [Test]
        public void Preview_GrowingFile_ShowsTheClaimedPointsAndReportsIt()
        {
            WriteLas(100_000, 1, i => true);
            using var reader = PointReaders.Open(FilePath);
            using var preview = new PreviewPicture(reader, new PreviewOptions { Points = 1000 });
            using (var file = new FileStream(FilePath, FileMode.Append, FileAccess.Write, FileShare.ReadWrite))
                file.Write(new byte[5000], 0, 5000);
            JobCoroutine.RunToEnd(preview.Run(new StageProgress()));
            Assert.That(preview.Sample.Count, Is.EqualTo(1000));
            Assert.That(Xs(preview.Sample), Has.All.InRange(1, 100_000));
            Assert.That(Warnings(reader),
                Has.Exactly(1).Contains("changed while it was read (2,000,375 bytes before, 2,005,375 now)"));
        }

        [Test]
        public void Preview_ReplacedFile_ReportsIt()
        {
            WriteLas(100_000, 1, i => true);
            using var reader = PointReaders.Open(FilePath);
            using var preview = new PreviewPicture(reader, new PreviewOptions { Points = 1000 });
            WriteLas(200_000, 1, i => false);
            JobCoroutine.RunToEnd(preview.Run(new StageProgress()));
            Assert.That(Warnings(reader), Has.Exactly(1).Contains("changed while it was read"));
        }

        [Test]
        public void Preview_TruncatedFile_FailsWithTheReason()
        {
            WriteLas(100_000, 1, i => true);
            using var reader = PointReaders.Open(FilePath);
            using var preview = new PreviewPicture(reader, new PreviewOptions { Points = 1000 });
            using (var file = new FileStream(FilePath, FileMode.Open, FileAccess.Write, FileShare.ReadWrite))
                file.SetLength(50_000);
            Failures.Of(() => JobCoroutine.RunToEnd(preview.Run(new StageProgress())), FailureCode.Truncated, FilePath);
        }

        [Test]
        public void Waves_OfAFile25TimesAsLarge_ReadNoMore()
        {
            long[] BytesOfWaves()
            {
                var bytes = new List<long>();
                using var reader = PointReaders.Open(FilePath);
                using var preview = new PreviewPicture(reader, new PreviewOptions());
                preview.WaveReady += (_, wave) => bytes.Add(wave.BytesRead);
                JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()));
                return bytes.ToArray();
            }
            long[] Least() => BytesOfWaves().Zip(BytesOfWaves(), Math.Min).Zip(BytesOfWaves(), Math.Min).ToArray();
            WriteLas(20_000_000, 25_000_000, i => true);
            long[] of20M = Least(); // Of gaps more is read where the machine was slow at the first wave.
            WriteLas(500_000_000, 25_000_000, i => true); // 10 GB, all of it a hole but for 20 records.
            var growth = Least().Zip(of20M, (large, small) => large / (double)small).ToArray();
            Assert.That(growth, Has.Length.EqualTo(of20M.Length).And.All.LessThan(1.2));
        }
    }
}
