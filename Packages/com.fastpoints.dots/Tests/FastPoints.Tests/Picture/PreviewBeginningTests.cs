using System.Linq;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Picture;
using FastPoints.Reading;
using FastPoints.Sampling;
using NUnit.Framework;

namespace FastPoints.Tests.Picture
{
    public class PreviewBeginningTests
    {
        const int LongChunkPoints = 1000, Points = 5000;

        /// <param name="chunkPoints">0 for one stream without chunks.</param>
        static LazFileWriter Writer(int chunkPoints) => new LazFileWriter
        {
            PointFormat = 3,
            ChunkPoints = chunkPoints == 0 ? new int[0] : new[] { chunkPoints },
            TableLocation = chunkPoints == 0 || chunkPoints == Points ? LazTableLocation.AtOffset : LazTableLocation.Missing,
        };

        static PointReader Open(TemporaryFile file)
        {
            using var source = RandomAccessFile.Open(file.Path);
            return LazReader.Open(LasFile.Read(source), source, LongChunkPoints);
        }

        static PreviewPicture Take(PointReader reader, PreviewOptions options)
        {
            options.Points = 2000;
            var preview = new PreviewPicture(reader, options);
            JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()));
            return preview;
        }

        static int[] Xs(PreviewSample sample) =>
            sample.Points.Column<int>(AttributeNames.X).ToArray().Take(sample.Count).ToArray();

        [TestCase(400, 1200), TestCase(3000, 1000), TestCase(0, 1000), TestCase(Points, 1000)]
        public void FindPrefixes_BlocksUnknown_GivesFirstPointsUntilAllAreFound(int chunkPoints, int expected)
        {
            var writer = Writer(chunkPoints);
            var records = LazRecords.Make(3, 0, Points, 5);
            var all = records.SelectMany(record => record).ToArray();
            using var file = new TemporaryFile(writer.Write(records), ".laz");
            using var reader = Open(file);
            var layout = LazFileReading.LayoutOf(file.Path);
            var prefixes = (IPrefixSource)reader;
            Assert.That(prefixes.HasPrefixes, Is.True);
            JobCoroutine.RunToEnd(prefixes.FindPrefixes(1));
            Assert.That(reader.BlocksAreKnown, Is.False);
            Assert.That(reader.PointCount, Is.EqualTo(expected));
            Assert.That(LazFileReading.Difference(LazFileReading.Records(reader, layout),
                all.Take(expected * writer.RecordBytes).ToArray(), writer.RecordBytes), Is.Null);
            int warnings = reader.Info.Warnings.Count;

            JobCoroutine.RunToEnd(reader.IndexBlocks());
            Assert.That(prefixes.HasPrefixes, Is.False);
            Assert.That(LazFileReading.Difference(LazFileReading.Records(reader, layout), all, writer.RecordBytes), Is.Null);
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(warnings));
        }

        [TestCase(400, 1200), TestCase(0, 1000)]
        public void QuickPreview_BlocksUnknown_ShowsTheBeginningAndReportsIt(int chunkPoints, int expected)
        {
            using var file = new TemporaryFile(Writer(chunkPoints).Write(LazRecords.Make(3, 0, Points, 5)), ".laz");
            using var reader = Open(file);
            using var preview = Take(reader, new PreviewOptions { Quick = true });
            Assert.That(reader.BlocksAreKnown, Is.False, "that takes a look through all of the file");
            Assert.That(preview.Sample.Count, Is.EqualTo(expected));
            Assert.That(preview.Sample.IsOfPrefix, Is.True);
            Assert.That(preview.Sample.Fraction, Is.EqualTo(expected / (double)Points));
            Assert.That(reader.Info.Warnings.Select(warning => warning.Text),
                Has.Exactly(1).Contains("beginning alone, " + 100 * expected / Points + " % of the points"));
        }

        [TestCase(400), TestCase(0)]
        public void Preview_BlocksUnknown_EndsWithTheFullScansSample(int chunkPoints)
        {
            using var file = new TemporaryFile(Writer(chunkPoints).Write(LazRecords.Make(3, 0, Points, 5)), ".laz");
            using var reader = Open(file);
            using var exactReader = Open(file);
            using var preview = Take(reader, new PreviewOptions());
            using var exact = Take(exactReader, new PreviewOptions { Exact = true });
            Assert.That(preview.Sample.IsOfPrefix, Is.False);
            Assert.That(preview.Sample.IsFullScan, Is.True);
            Assert.That(Xs(preview.Sample), Is.EqualTo(Xs(exact.Sample)));
            Assert.That(reader.Info.Warnings.Select(warning => warning.Text), Has.None.Contains("beginning alone"));
            // The beginning's wave came first.
            Assert.That(preview.Waves[0].Points, Is.EqualTo(chunkPoints == 0 ? 1000 : 1200));
            Assert.That(preview.Waves.Select(wave => wave.Seconds), Is.Ordered);
            Assert.That(exact.Waves, Has.Count.EqualTo(1));
        }

        [Test]
        public void Preview_FewPointsWithoutATable_IsCompleteAtOnce()
        {
            var writer = Writer(400);
            using var file = new TemporaryFile(writer.Write(LazRecords.Make(3, 0, 900, 5)), ".laz");
            using var reader = Open(file);
            using var preview = Take(reader, new PreviewOptions());
            Assert.That(preview.Sample.HasAllPoints, Is.True);
            Assert.That(preview.Sample.IsOfPrefix, Is.False);
            Assert.That(preview.Sample.Count, Is.EqualTo(900));
        }
    }
}
