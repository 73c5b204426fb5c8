using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text.RegularExpressions;
using FastPoints.Las;
using FastPoints.Reading;
using FastPoints.Sources;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Reading
{
    /// <summary>Each LAS and PLY row of the samples' README against what the readers say of that file: kind, version, point
    /// format and record length, count, and points within the header's box. Broken files against the table below.</summary>
    public class SampleReadmeTests
    {
        public sealed class Row
        {
            public string Folder;
            public string File;
            public string Kind;
            public string Version;
            public string PointFormat;
            public long Points;
            public long Bytes;

            public override string ToString() => Folder + "/" + File;
        }

        sealed class Outcome
        {
            public readonly FailureCode? Failure;
            public readonly long Points;
            public readonly string Story;

            public Outcome(FailureCode failure, string detail)
            {
                Failure = failure;
                Story = detail;
            }

            public Outcome(long points, string detail)
            {
                Points = points;
                Story = detail;
            }
        }

        static readonly Dictionary<string, Outcome> s_outcomes = new Dictionary<string, Outcome>
        {
            { "1.2-with-color-clipped.las", new Outcome(1064, "the header claims 1065 points, the file holds 1064") },
            { "1.2-no-points.las", new Outcome(FailureCode.Truncated, "the header claims 1065 points, the file holds 0") },
            { "bad_vlr_count.las", new Outcome(10, "VLR") },
            { "bad-geotiff-keys.las", new Outcome(10, "GeoTIFF key") },
            { "2-2-2-2.laz", new Outcome(FailureCode.Unsupported, "LAS version: wanted 1.0 to 1.5") },
            { "no_vertex.ply", new Outcome(FailureCode.BadInput, "vertex") },
            { "empty.ply", new Outcome(FailureCode.Truncated, "0 bytes") },
            { "diamond_with_bool.ply", new Outcome(6, null) },
            { "utm17_space.pcd", new Outcome(10, null) },
            { "A4.e57", new Outcome(4, null) },
        };

        static readonly Dictionary<string, string> s_oddBounds = new Dictionary<string, string>
        {
            { "simple1_3.las", "raw integers" },
        };

        static IEnumerable<TestCaseData> Sound()
        {
            foreach (var row in Rows("las", "ply"))
                yield return new TestCaseData(row).SetName("Sample_" + row + "_IsWhatItsRowSays");
        }

        static IEnumerable<TestCaseData> Broken()
        {
            foreach (var row in Rows("broken"))
                if (s_outcomes.ContainsKey(row.File))
                    yield return new TestCaseData(row).SetName("Sample_" + row + "_EndsAsStated");
        }

        [Test]
        public void Readme_Rows_Exist()
        {
            TestData.PathOrIgnore("data/samples/README.md");
            Assert.That(Rows("las"), Has.Count.GreaterThanOrEqualTo(38));
            Assert.That(Rows("ply"), Has.Count.GreaterThanOrEqualTo(24));
            var names = Rows("broken").ConvertAll(row => row.File);
            Assert.That(s_outcomes.Keys, Is.SubsetOf(names));
        }

        [TestCaseSource(nameof(Sound))]
        public void Sample(Row row)
        {
            using var reader = PointReaders.Open(Path.Combine(TestData.Samples, row.Folder, row.File));
            Assert.That(reader.Info.Format, Is.EqualTo(row.Kind.Substring(0, 3)));
            Assert.That(reader.Info.Version, Is.EqualTo(row.Version));
            Assert.That(reader.Info.FileBytes, Is.EqualTo(row.Bytes));
            Assert.That(reader.Info.PointsClaimed, Is.EqualTo((ulong)row.Points));
            if (reader.Info.Format == "LAS")
                CheckRecord(row.PointFormat, reader.Info);

            var found = ScanBounds(reader, out long points);
            Assert.That(points, Is.EqualTo(row.Points));
            if (s_oddBounds.TryGetValue(row.File, out string detail))
                Assert.That(reader.Info.Warnings.ConvertAll(warning => warning.Text), Has.Some.Contains(detail));
            if (reader.Info.HasBoundsClaimed && points > 0)
            {
                var step = 2 * math.abs(reader.Info.Transform.Scale);
                Assert.That(math.all(found.Min >= reader.Info.BoundsClaimed.Min - step), Boxes(found, reader.Info));
                Assert.That(math.all(found.Max <= reader.Info.BoundsClaimed.Max + step), Boxes(found, reader.Info));
            }
        }

        [TestCaseSource(nameof(Broken))]
        public void BrokenSample(Row row)
        {
            var outcome = s_outcomes[row.File];
            string path = Path.Combine(TestData.Samples, row.Folder, row.File);
            if (outcome.Failure != null)
            {
                var failure = Assert.Throws<PointCloudException>(() => PointReaders.Open(path).Dispose());
                Assert.That(failure.Code, Is.EqualTo(outcome.Failure));
                Assert.That(failure.Message, Does.Contain(outcome.Story).And.Not.Contain("\n"));
                return;
            }
            using var reader = PointReaders.Open(path);
            ScanBounds(reader, out long points);
            Assert.That(points, Is.EqualTo(outcome.Points));
            if (outcome.Story == null)
                Assert.That(reader.Info.Warnings, Is.Empty);
            else
                Assert.That(reader.Info.Warnings.ConvertAll(warning => warning.Text), Has.Some.Contains(outcome.Story));
        }

        /// <summary>"3" or "3 (61 B)".</summary>
        static void CheckRecord(string reported, SourceInfo info)
        {
            var match = Regex.Match(reported, @"^(\d+)(?: \((\d+) B\))?$");
            Assert.That(match.Success, reported);
            int format = int.Parse(match.Groups[1].Value, CultureInfo.InvariantCulture);
            Assert.That(info.PointFormat, Is.EqualTo(format));
            int bytes = match.Groups[2].Success ? int.Parse(match.Groups[2].Value, CultureInfo.InvariantCulture)
                : LasPointFormat.Of(format).RecordBytes;
            Assert.That(info.RecordBytes, Is.EqualTo(bytes));
        }

        static BoundsGeo ScanBounds(PointReader reader, out long points)
        {
            var bounds = BoundsGeo.Empty;
            ReadPoints.IndexBlocks(reader);
            points = ReadPoints.EachBlock(reader, reader.Info.Schema, read =>
            {
                for (int i = 0; i < read.Points.Count; i++)
                {
                    var stored = new double3(Number(read.Points, AttributeNames.X, i), Number(read.Points, AttributeNames.Y, i),
                        Number(read.Points, AttributeNames.Z, i));
                    var position = reader.Info.Transform.ToGeo(stored);
                    if (math.all(math.isfinite(position)))
                        bounds.Include(position);
                }
            });
            return bounds;
        }

        static double Number(PointBatch points, string name, int i)
        {
            int column = points.Schema.IndexOf(name);
            return points.Schema[column].Type switch
            {
                AttributeType.UInt8 => points.Column<byte>(column)[i],
                AttributeType.Int8 => points.Column<sbyte>(column)[i],
                AttributeType.UInt16 => points.Column<ushort>(column)[i],
                AttributeType.Int16 => points.Column<short>(column)[i],
                AttributeType.UInt32 => points.Column<uint>(column)[i],
                AttributeType.Int32 => points.Column<int>(column)[i],
                AttributeType.Float32 => points.Column<float>(column)[i],
                _ => points.Column<double>(column)[i],
            };
        }

        static string Boxes(BoundsGeo found, SourceInfo info) =>
            "found " + found.Min + " .. " + found.Max + ", claimed " + info.BoundsClaimed.Min + " .. " + info.BoundsClaimed.Max;

        static List<Row> Rows(params string[] folders)
        {
            var rows = new List<Row>();
            string readme = TestData.Samples == null ? null : Path.Combine(TestData.Samples, "README.md");
            if (readme == null || !File.Exists(readme))
                return rows;
            string folder = null;
            Dictionary<string, int> columnOfName = null;
            foreach (string line in File.ReadAllLines(readme))
            {
                if (line.StartsWith("## "))
                {
                    int end = line.IndexOf('/');
                    folder = end > 0 ? line.Substring(3, end - 3) : null;
                    columnOfName = null;
                }
                bool isRow = line.StartsWith("|") && !line.StartsWith("| ---");
                if (!isRow || folder == null || System.Array.IndexOf(folders, folder) < 0)
                    continue;
                var cells = line.Trim('|').Split('|');
                if (columnOfName == null)
                {
                    columnOfName = new Dictionary<string, int>();
                    for (int i = 0; i < cells.Length; i++)
                        columnOfName[cells[i].Trim()] = i;
                    continue;
                }
                rows.Add(new Row
                {
                    Folder = folder,
                    File = cells[columnOfName["file"]].Trim(),
                    Kind = cells[columnOfName["kind"]].Trim(),
                    Version = cells[columnOfName["version"]].Trim(),
                    PointFormat = columnOfName.TryGetValue("point format", out int column) ? cells[column].Trim() : "",
                    Points = Count(cells[columnOfName["points"]]),
                    Bytes = Count(cells[columnOfName["bytes"]]),
                });
            }
            return rows;
        }

        /// <summary>"1,065"; -1 where the cell has no number.</summary>
        static long Count(string cell) =>
            long.TryParse(cell.Trim().Replace(",", ""), NumberStyles.None, CultureInfo.InvariantCulture, out long count)
                ? count
                : -1;
    }
}
