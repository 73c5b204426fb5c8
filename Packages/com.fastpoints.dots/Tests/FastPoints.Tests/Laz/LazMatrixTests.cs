using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Las;
using FastPoints.Reading;
using FastPoints.Sources;
using NUnit.Framework;

namespace FastPoints.Tests.Laz
{
    public class LazMatrixTests
    {
        const string Matrix = "data/laszip-matrix";

        static IEnumerable<string> Files()
        {
            if (!TestData.TryPath(Matrix, out string folder))
                return new[] { "none" };
            return Directory.GetFiles(folder, "*.laz").Select(Path.GetFileName).OrderBy(name => name, StringComparer.Ordinal);
        }

        static IEnumerable<string> FilesOfEachFormat() =>
            Files().Where(name => name.Contains("variable") || name.Contains("las15") || name == "none");

        static string TruthOf(string path)
        {
            string name = Path.GetFileName(path);
            return Path.Combine(Path.GetDirectoryName(path), name.Substring(0, name.Contains("las15") ? 10 : 4) + ".las.gz");
        }

        [TestCaseSource(nameof(Files))]
        public void Read_WholeFile_MatchesTheReference(string name)
        {
            string path = TestData.PathOrIgnore(Matrix + "/" + name);
            using var reader = LazFileReading.Open(path);
            var layout = LazFileReading.LayoutOf(path);
            Assert.That(LazFileReading.Difference(LazFileReading.Records(reader, layout), LazFileReading.Truth(TruthOf(path)),
                layout.RecordBytes), Is.Null);
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [TestCaseSource(nameof(FilesOfEachFormat))]
        public void Read_RangesAndSelections_MatchTheReference(string name)
        {
            string path = TestData.PathOrIgnore(Matrix + "/" + name);
            var layout = LazFileReading.LayoutOf(path);
            var truth = LazFileReading.Truth(TruthOf(path));
            using var reader = LazFileReading.Open(path);
            var schema = reader.Info.Schema;
            for (int i = 0; i < schema.Count; i++)
            {
                var wanted = schema.Select(schema[i].Name, schema[(i * 5 + 2) % schema.Count].Name);
                var ranges = new List<BlockRange>();
                for (int block = reader.BlockCount - 1; block >= 0; block--)
                {
                    int points = Math.Min(reader.PointsInBlock(block), 1000 + i);
                    ranges.Add(new BlockRange(block, points / 3, points - points / 3));
                    ranges.Add(new BlockRange(block, 0, points / 3));
                }
                var got = (byte[])truth.Clone();
                foreach (var range in ranges)
                    Flip(got, layout, wanted, reader.FirstPointOfBlock(range.Block) + range.First, range.Count);
                LazFileReading.Read(reader, layout, ranges, wanted, 3, got);
                Assert.That(LazFileReading.Difference(got, truth, layout.RecordBytes), Is.Null, wanted.ToString());
            }
        }

        static void Flip(byte[] records, LasRecordLayout layout, PointSchema wanted, long first, int count)
        {
            foreach (var field in layout.Fields.Where(field => wanted.Has(field.Name)))
                for (long point = first; point < first + count; point++)
                {
                    long at = point * layout.RecordBytes + field.ByteOffset;
                    if (field.IsBits)
                        records[at] ^= (byte)(((1 << field.BitWidth) - 1) << field.BitShift);
                    for (int i = 0; !field.IsBits && i < field.Type.SizeOf(); i++)
                        records[at + i] ^= 255;
                }
        }

        [TestCase("point10")]
        [TestCase("point-color")]
        [TestCase("point-time")]
        [TestCase("point-time-color")]
        [TestCase("example")]
        [TestCase("1_4_w_evlr")]
        [TestCase("no-points-1.3")]
        [TestCase("pdrf4-1.3")]
        [TestCase("pdrf6-1.4")]
        [TestCase("pdrf7-v4-1.4")]
        [TestCase("pdrf8-1.4")]
        [TestCase("pdrf10-1.4")]
        [TestCase("pdrf9-1.5")]
        [TestCase("ripple")]
        [TestCase("extra", "extrabytes")]
        [TestCase("laszip-generated", "1.2-with-color")]
        [TestCase("liblas-generated", "1.2-with-color")]
        [TestCase("simple-laszip-compressor-version-1.2r0", "1.2-with-color")]
        public void Read_SampleWithTwin_MatchesTheTwin(string name, string twin = null)
        {
            string path = TestData.SampleOrIgnore("laz/" + name + ".laz");
            string las = TestData.SampleOrIgnore("las/" + (twin ?? name) + ".las");
            using var reader = LazFileReading.Open(path);
            var layout = LazFileReading.LayoutOf(path);
            Assert.That(LazFileReading.Difference(LazFileReading.Records(reader, layout), LazFileReading.Truth(las),
                layout.RecordBytes), Is.Null);
        }

        [TestCase("broken_coder.laz", FailureCode.Unsupported, "entropy coder: wanted 0, got 15")]
        [TestCase("broken_type.laz", FailureCode.Unsupported, "item type: wanted 0 or 6 to 14, got 22")]
        public void Open_BrokenSample_NamesTheFault(string name, FailureCode code, string detail)
        {
            string path = TestData.SampleOrIgnore("broken/" + name);
            Failures.Of(() => PointReaders.Open(path).Dispose(), code, detail);
        }

        [TestCase("laz/autzen_trim.laz", 110000)]
        [TestCase("laz/append-bug.laz", 37805)]
        [TestCase("laz/fullwave.laz", 10750)]
        [TestCase("laz/plane.laz", 28185)]
        [TestCase("laz/point-time-1.4.las.laz", 1065)]
        [TestCase("laz/ellipsoid-1.4.laz", 100000)]
        [TestCase("laz/32-1-472-150-76.laz", 5658)]
        [TestCase("laz/las14_prf6.laz", 135)]
        [TestCase("laz/MixedConifer.laz", 37657)]
        [TestCase("copc/1.2-with-color.copc.laz", 1065)]
        [TestCase("copc/example.copc.laz", 30)]
        [TestCase("copc/simple_with_page.copc.laz", 1065)]
        public void Read_Sample_HasTheCountOfItsRow(string name, long points)
        {
            string path = TestData.SampleOrIgnore(name);
            using var reader = LazFileReading.Open(path);
            var layout = LazFileReading.LayoutOf(path);
            var records = LazFileReading.Records(reader, layout);
            Assert.That(records.Length / layout.RecordBytes, Is.EqualTo(points));
            Assert.That(reader.Info.PointsClaimed, Is.EqualTo((ulong)points));
            Assert.That(reader.Info.Warnings.Where(warning => warning.Text.Contains("chunk")), Is.Empty);
        }
    }
}
