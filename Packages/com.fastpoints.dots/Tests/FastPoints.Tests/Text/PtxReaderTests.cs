using System.Linq;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Text
{
    public class PtxReaderTests : FolderTests
    {
        string Write(string text) => Folder.Write("cloud.ptx", text);

        [TestCase(3, 4, 2, 5), TestCase(100, 200, 60, 100)]
        public void Open_TwoScans_AreOneCloud(int columns, int rows, int columns2, int rows2)
        {
            string text = PtxTestFile.Scan(columns, rows) + PtxTestFile.Scan(columns2, rows2, 7) + "\n";
            using var reader = ReadPoints.Open(Write(text));
            Assert.That(reader.Info.Format, Is.EqualTo("PTX"));
            Assert.That(reader.PointCount, Is.EqualTo(columns * rows + columns2 * rows2));
            Assert.That(reader.Info.Schema.Select(a => a.Name), Is.EqualTo(new[]
                { "X", "Y", "Z", "Intensity", "Red", "Green", "Blue", "PointSourceId" }));
            var scans = new[] { (columns * rows, 1000, 1), (columns2 * rows2, 7, 2) };
            var wanted = scans.SelectMany(s => Enumerable.Range(0, s.Item1).Where(i => i % 3 != 2)
                .Select(i => (I: i, Shift: s.Item2, Scan: s.Item3))).ToArray();
            int at = 0;
            ReadPoints.EachBlock(reader, reader.Info.Schema, read =>
            {
                for (int i = 0; i < read.Points.Count; i++, at++)
                {
                    var (n, shift, scan) = wanted[at];
                    // (x, y) becomes (-y, x), and is shifted.
                    Assert.That(read.Points.Column<double>(0)[i], Is.EqualTo(shift + n + 1));
                    Assert.That(read.Points.Column<double>(1)[i], Is.EqualTo(20 + n + 0.25));
                    Assert.That(read.Points.Column<double>(2)[i], Is.EqualTo(3.5));
                    Assert.That(read.Points.Column<float>(3)[i], Is.EqualTo(0.75f));
                    Assert.That(read.Points.Column<byte>(4)[i], Is.EqualTo((byte)n));
                    Assert.That(read.Points.Column<byte>(6)[i], Is.EqualTo(255), "300 is as much as a byte holds");
                    Assert.That(read.Points.Column<ushort>(7)[i], Is.EqualTo(scan));
                }
            });
            Assert.That(at, Is.EqualTo(wanted.Length));
            Assert.That(reader.Info.Warnings, Is.Empty);
            Assert.That(reader.Info.Scanners, Is.EqualTo(new[] { new double3(1000, 20, 3), new double3(7, 20, 3) }));
        }

        [Test]
        public void Open_ScanInTheWorldsCoordinates_HasItsScannersPosition()
        {
            using var reader = ReadPoints.Open(Write(PtxTestFile.Scan(2, 3).Replace("1000 20 3 1", "0 0 0 1")));
            ReadPoints.EachBlock(reader, reader.Info.Schema, _ => { });
            Assert.That(reader.Info.Scanners, Is.EqualTo(new[] { new double3(1, 2, 3) }));
        }

        [Test]
        public void Read_TruncatedFile_GivesThePositionsBeforeAndAWarning()
        {
            string text = PtxTestFile.Scan(5, 6);
            using var reader = ReadPoints.Open(Write(text.Substring(0, text.TrimEnd('\n').LastIndexOf('\n') + 1)));
            Assert.That(reader.PointCount, Is.EqualTo(29));
            Assert.That(reader.Info.Warnings.Single().Text, Does.Contain("wanted 30 places, got 29"));
        }

        [Test]
        public void Read_BadLinesAndTextAfterAScan_AreSkippedWithWarnings()
        {
            string text = PtxTestFile.Scan(2, 3).Replace("1.25 -2", "word -2") + "the end of it\n";
            using var reader = ReadPoints.Open(Write(text));
            Assert.That(ReadPoints.EachBlock(reader, reader.Info.Schema, _ => { }), Is.EqualTo(3));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("wanted the header of another")
                .And.Some.Contains("1 lines are no points of 7 values"));
            Assert.That(reader.Info.Warnings.All(w => w.ByteOffset > 0), Is.True);
        }

        [TestCase("9999999999\n9999999999\n"), TestCase("1\n0\n")]
        public void Open_LargeClaims_AllocatesNothing(string size)
        {
            string text = size + PtxTestFile.Scan(2, 2).Substring(4);
            if (size.StartsWith("9"))
            {
                using var reader = ReadPoints.Open(Write(text));
                Assert.That(reader.PointCount, Is.EqualTo(4));
                return;
            }
            Failures.Of(() => ReadPoints.Open(Write(text)), FailureCode.Truncated, "no points");
        }

        [Test]
        public void Lines_OfAnotherNumberOfValues_AreRefused() => Failures.Of(() => ReadPoints.Open(
            Write(PtxTestFile.Scan(2, 2).Replace("0.75 0 7 300", "0.75 0 7"))), FailureCode.Unsupported, "values in a line");
    }
}
