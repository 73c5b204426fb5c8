using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using FastPoints.Build;
using FastPoints.Export;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Text
{
    [Category("Smoke")]
    public class XyzReaderTests : FolderTests
    {
        string FilePath => Folder.File("cloud");

        PointReader Open(string text, params string[] columns)
        {
            File.WriteAllBytes(FilePath, Encoding.UTF8.GetBytes(text));
            return Open(columns);
        }

        PointReader Open(params string[] columns)
        {
            var reader = PointReaders.Open(FilePath, new ReadOptions { TextColumns = columns.Length > 0 ? columns : null });
            ReadPoints.IndexBlocks(reader);
            return reader;
        }

        static List<string> Points(PointReader reader, params string[] names)
        {
            var schema = names.Length == 0 ? reader.Info.Schema : reader.Info.Schema.Select(names);
            var points = new List<string>();
            ReadPoints.EachBlock(reader, schema, read =>
            {
                for (int i = 0; i < read.Points.Count; i++)
                    points.Add(string.Join(" ", Enumerable.Range(0, schema.Count).Select(c => Value(reader, read.Points, c, i))));
            });
            return points;
        }

        static string Value(PointReader reader, PointBatch batch, int column, int i)
        {
            var attribute = batch.Schema[column];
            object value;
            switch (attribute.Type)
            {
                case AttributeType.UInt8: value = batch.Column<byte>(column)[i]; break;
                case AttributeType.UInt16: value = batch.Column<ushort>(column)[i]; break;
                case AttributeType.Int16: value = batch.Column<short>(column)[i]; break;
                case AttributeType.Int32: value = batch.Column<int>(column)[i]; break;
                case AttributeType.Int64: value = batch.Column<long>(column)[i]; break;
                case AttributeType.Float32: value = batch.Column<float>(column)[i]; break;
                default: value = batch.Column<double>(column)[i]; break;
            }
            int axis = "XYZ".IndexOf(attribute.Name, StringComparison.Ordinal);
            if (axis >= 0 && attribute.Name.Length == 1)
                value = (long)value * decimal.Parse(reader.Info.Transform.Scale[axis].ToString("R", CultureInfo.InvariantCulture),
                    NumberStyles.Float, CultureInfo.InvariantCulture);
            return System.Convert.ToString(value, CultureInfo.InvariantCulture);
        }

        static string Columns(PointReader reader) => reader.Info.Facts.First(f => f.Key == "columns").Value.Split('(')[0].Trim();

        static string Types(PointReader reader) => string.Join(" ", reader.Info.Schema.Skip(3).Select(a => a.Type.ToString()));

        // Every separator that is recognised; the same two points.
        [TestCase("1.5 2.25 -3\n4 5.5 6\n")]
        [TestCase("1.5\t2.25\t-3\n4\t5.5\t6")]
        [TestCase("1.5,2.25,-3\n4,5.5,6\n")]
        [TestCase("1.5, 2.25, -3\r\n4, 5.5, 6\r\n")]
        [TestCase("1.5;2.25;-3\n4;5.5;6\n")]
        [TestCase("1,5;2,25;-3\n4;5,5;6\n")]
        [TestCase("1,5 2,25 -3\n4 5,5 6\n")]
        [TestCase("1,5\t2,25\t-3\r4\t5,5\t6\r")]
        [TestCase("\"1.5\",\"2.25\",\"-3\"\n\"4\",\"5.5\",\"6\"\n")]
        [TestCase("  1.50   2.250 -3  \n\n\n   4 5.5 6.0\n\n")]
        [TestCase("\uFEFF1.5 2.25 -3\n4 5.5 6\n")]
        [TestCase("15e-1 2.25E0 -0.3e+1\n.4e1 +5.5 6\n")]
        [TestCase("# a scan\n// of a street\n1.5 2.25 -3\n# and more\n4 5.5 6\n")]
        [TestCase("2\n1.5 2.25 -3\n4 5.5 6\n")]
        [TestCase("x,y,z\n1.5,2.25,-3\n4,5.5,6\n")]
        [TestCase("Easting Northing Height\n1.5 2.25 -3\n4 5.5 6\n")]
        [TestCase("//X Y Z\n1.5 2.25 -3\n4 5.5 6\n")]
        [TestCase("\"z\";\"x\";\"y\"\n-3;1.5;2.25\n6;4;5.5\n")]
        public void Read_Dialects_GiveTheSamePoints(string text)
        {
            using var reader = Open(text);
            var points = Points(reader, "X", "Y", "Z").Select(p => p.Split(' ').Select(v => decimal.Parse(v,
                NumberStyles.Float, CultureInfo.InvariantCulture)).OrderBy(v => v).ToArray()).ToList();
            Assert.That(points, Is.EqualTo(new[] { new[] { -3m, 1.5m, 2.25m }, new[] { 4m, 5.5m, 6m } }));
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [TestCase("1 2 3 700\n4 5 6 65\n", "X Y Z Intensity", "UInt16")]
        [TestCase("1 2 3 -700\n4 5 6 65\n", "X Y Z Intensity", "Int16")]
        [TestCase("1 2 3 0.25\n4 5 6 1\n", "X Y Z Intensity", "Float32")]
        [TestCase("1 2 3 10 20 30\n4 5 6 255 0 0\n", "X Y Z Red Green Blue", "UInt8 UInt8 UInt8")]
        [TestCase("1 2 3 1000 20 30\n4 5 6 65535 0 0\n", "X Y Z Red Green Blue", "UInt16 UInt8 UInt8")]
        [TestCase("1 2 3 0.5 0.25 1.0\n4 5 6 0.1 0.2 0.3\n", "X Y Z Red Green Blue", "Float32 Float32 Float32")]
        [TestCase("1 2 3 0.6 0 0.8\n4 5 6 0 -1 0.0\n", "X Y Z NormalX NormalY NormalZ", "Float32 Int32 Float32")]
        [TestCase("1 2 3 -40 10 20 30\n4 5 6 7 255 0 0\n", "X Y Z Intensity Red Green Blue", "Int16 UInt8 UInt8 UInt8")]
        [TestCase("1 2 3 117.0 73.0 49.0\n4 5 6 0.0 255.0 0.0\n", "X Y Z Red Green Blue", "UInt8 UInt8 UInt8")]
        [TestCase("1 2 3 117.0 73.0 49.0 255.0\n4 5 6 0.0 12.0 9.0 255.0\n", "X Y Z Red Green Blue Alpha",
            "UInt8 UInt8 UInt8 UInt8")]
        [TestCase("1 2 3 10 20 30 255\n4 5 6 255 0 0 254\n", "X Y Z Intensity Red Green Blue", "UInt16 UInt8 UInt8 UInt8")]
        [TestCase("1 2 3 10 20 30 -40\n4 5 6 255 0 0 7\n", "X Y Z Red Green Blue Intensity", "UInt8 UInt8 UInt8 Int16")]
        [TestCase("1 2 3 10 20 30 0.6 0.1 0.79\n4 5 6 255 0 0 0.0 1.0 0.0\n",
            "X Y Z Red Green Blue NormalX NormalY NormalZ", "UInt8 UInt8 UInt8 Float32 Float32 Float32")]
        [TestCase("1 2 3 9 10 20 30 0.6 0.1 0.79\n4 5 6 7 255 0 0 0.0 1.0 0.0\n",
            "X Y Z Intensity Red Green Blue NormalX NormalY NormalZ", "UInt16 UInt8 UInt8 UInt8 Float32 Float32 Float32")]
        [TestCase("1 2 3 4 -5\n1 2 3 4 -5\n", "X Y Z Intensity Column5", "UInt16 Int32")]
        [TestCase("1 2 3 123456.78901234\n", "X Y Z Intensity", "Float64")]
        [TestCase("x y z classification gps_time foo\n1 2 3 4 123456789.125 5000000000\n",
            "X Y Z Classification GpsTime foo", "UInt8 Float64 Int64")]
        [TestCase("r g b x y z\n1 2 3 4 5 6\n", "Red Green Blue X Y Z", "X")]
        public void Open_Columns_AreGuessedAndStated(string text, string columns, string types)
        {
            using var reader = Open(text);
            Assert.That(Columns(reader), Is.EqualTo(columns));
            if (types != "X")
                Assert.That(Types(reader), Is.EqualTo(types));
            Assert.That(reader.Info.Facts.First(f => f.Key == "columns").Value,
                Does.Contain(char.IsLetter(text[0]) ? "by the file's header" : "guessed from"));
        }

        [Test]
        public void Open_ColumnsGiven_OverrideTheGuess()
        {
            using (var reader = Open("a 10 20 30 1.5 2.5 3.5 9\nb 10 20 31 1.5 2.5 3.5 9\n", "-", "r", "g", "b", "x", "y", "z"))
            {
                Assert.That(Points(reader), Is.EqualTo(new[] { "10 20 30 1.5 2.5 3.5", "10 20 31 1.5 2.5 3.5" }));
                Assert.That(reader.Info.Facts.First(f => f.Key == "columns").Value, Does.Contain("as told"));
            }
            Failures.Of(() => Open("1 2 3\n", "x", "y", "z", "i"),
                FailureCode.BadInput, "columns in a line: wanted 4 (x, y, z, i), got 3");
        }

        [Test]
        public void Read_Coordinates_KeepTheirDigits()
        {
            var random = new System.Random(5);
            var text = new StringBuilder();
            var expected = new List<string>();
            for (int i = 0; i < 5000; i++)
            {
                string x = random.Next(300000, 800000) + "." + random.Next(1000000).ToString("D6");
                string y = "-" + random.Next(4000000, 9000000) + "." + random.Next(10000).ToString("D4");
                string z = random.Next(100) + "." + random.Next(1000000000).ToString("D9");
                text.Append(x).Append(' ').Append(y).Append(' ').Append(z).Append('\n');
                expected.Add(x + " " + y + " " + z);
            }
            using var reader = Open(text.ToString());
            Assert.That(reader.Info.Transform.Scale.x, Is.EqualTo(1e-6));
            Assert.That(reader.Info.Transform.Scale.y, Is.EqualTo(1e-4));
            Assert.That(reader.Info.Transform.Scale.z, Is.EqualTo(1e-9));
            Assert.That(Points(reader), Is.EqualTo(expected));
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Read_MoreDigitsThanTheSample_AreRoundedAndCounted()
        {
            var text = new StringBuilder();
            for (int i = 0; i < 200000; i++)
                text.Append("1.25 2 3\n");
            // Right after the first segment that opening reads: not in the sample.
            int at = 70 * 1024;
            while (text[at] != '\n')
                at++;
            text.Insert(at + 1, "1.258 2 3\n-1.255 2 3\n");
            using var reader = Open(text.ToString());
            var points = Points(reader, "X");
            Assert.That(points.Count, Is.EqualTo(200002));
            Assert.That(points.Where(p => p != "1.25"), Is.EqualTo(new[] { "1.26", "-1.26" }));
            Assert.That(reader.Info.Warnings.Single().Text, Does.StartWith("2 coordinates have more digits"));
            Assert.That(reader.Info.Warnings.Single().ByteOffset, Is.EqualTo(at + 1));
        }

        [Test]
        public void Read_BadLines_AreCountedAndSkipped()
        {
            var lines = Enumerable.Range(0, 100).Select(i => i + " 2 3 4 5 6").ToList();
            lines[20] = "20 2 3 4 5";
            lines[30] = "30 2 word 4 5 6";
            lines[40] = "nan 2 3 4 5 6";
            lines[50] = "50 2 3 4 5 6 7 8";
            lines[60] = "60 2 3 1e400 5 6";
            lines[70] = "1e300 2 3 4 5 6";
            lines[80] = "# a remark";
            lines[90] = "12";
            using var reader = Open(string.Join("\n", lines));
            var expected = Enumerable.Range(0, 100).Where(i => !new[] { 20, 30, 40, 70, 80, 90 }.Contains(i))
                .Select(i => i.ToString());
            Assert.That(Points(reader, "X"), Is.EqualTo(expected));
            Assert.That(Points(reader).Count, Is.EqualTo(94), "whatever is asked for");
            var warnings = reader.Info.Warnings.Select(w => w.Text).ToList();
            Assert.That(warnings, Has.Some.StartsWith("5 lines are no points and left out; the first one: too few values"));
            Assert.That(warnings, Has.Some.StartsWith("1 lines have more values"));
            Assert.That(reader.Info.Warnings[0].ByteOffset,
                Is.EqualTo(string.Join("\n", lines).IndexOf("\n20 2 3 4 5\n", StringComparison.Ordinal) + 1));
        }

        [Test]
        public void Read_EmptyValues_AreZeroAndCounted()
        {
            using var reader = Open("1,2,3,,5\n1,2,3,4,\n1,2,,4,5\n1,2,3, ,5\n1,2,3,4,5\n1,2,3,4,5\n1,2,3,4,5\n");
            Assert.That(Points(reader), Is.EqualTo(new[]
            {
                "1 2 3 0 5", "1 2 3 4 0", "1 2 3 0 5", "1 2 3 4 5", "1 2 3 4 5", "1 2 3 4 5",
            }));
            var warnings = reader.Info.Warnings.Select(w => w.Text).ToList();
            Assert.That(warnings, Has.Some.StartsWith("3 values are empty"));
            Assert.That(warnings, Has.Some.StartsWith("1 lines are no points"));
        }

        [Test]
        public void Read_ValuesOutOfRange_AreClamped()
        {
            var text = new StringBuilder();
            for (int i = 0; i < 200000; i++)
                text.Append("1 2 3 255 0 1\n");
            text.Insert(70000 / 14 * 14, "1 2 3 300 -1 0.5\n");
            using var reader = Open(text.ToString());
            Assert.That(Points(reader), Has.Some.EqualTo("1 2 3 255 0 0"));
            Assert.That(reader.Info.Warnings.Single().Text, Does.StartWith("3 values do not fit"));
        }

        [TestCase("{\"x\": [1, 2, 3]}")]
        [TestCase("[1, 2, 3,\n4, 5, 6]")]
        [TestCase("v 1 2 3\nv 4 5 6\n")]
        [TestCase("OFF\n8 6 12\n0 0 0\n")]
        [TestCase("solid cube of mine\nfacet normal 0 0 1\n")]
        [TestCase("ncols 4\nnrows 6\nxllcorner 0\n1 2 3\n")]
        [TestCase("3\nwater molecule of mine\nO 0 0 0\nH 1 0 0\nH 0 1 0\n")]
        [TestCase("12 monkeys\nate 3 bananas\n1 2 3\n")]
        [TestCase("1 2\n3 4\n")]
        [TestCase("1 2 3\nand then\nmore words\n")]
        [TestCase("")]
        [TestCase(" \n \n")]
        [TestCase("1 2 3\0")]
        [TestCase("G01 X1 Y2 Z3\nG01 X1 Y2 Z3\n")]
        public void Open_OtherText_IsRefused(string text) =>
            Assert.That(() => Open(text), Throws.InstanceOf<PointCloudException>());

        [Test]
        public void Open_NamesWithoutPositions_IsRefused() =>
            Failures.Of(() => Open("time,temperature,humidity\n1,2,3\n"), FailureCode.Unsupported, "time, temperature, humidity");

        [Test]
        public void Open_Ptx_IsNamed() =>
            Failures.Of(() => Open("10\n20\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n"), FailureCode.Unsupported, "PTX");

        [Test]
        public void Open_PtsCount_IsAClaim()
        {
            using (var reader = Open("5\n1 2 3 4\n1 2 3 4\n"))
            {
                Assert.That(reader.Info.Format, Is.EqualTo("PTS"));
                Assert.That(reader.Info.PointsClaimed, Is.EqualTo(5));
                Assert.That(reader.PointCount, Is.EqualTo(2));
                Assert.That(reader.Info.Warnings.Single().Text, Does.Contain("wanted 5, got 2"));
            }
            using (var reader = Open("1 2 3 4\n1 2 3 4\n"))
                Assert.That(reader.Info.HasPointsClaimed, Is.False);
        }

        [Test]
        public void Read_ManyBlocks_InAnyOrder()
        {
            var text = new StringBuilder();
            var random = new System.Random(7);
            const int count = 60000;
            for (int i = 0; i < count; i++)
                text.Append(i).Append(new string(' ', random.Next(1, 20))).Append("2.5 3").Append(i % 3 == 0 ? "\r\n" : "\n");
            using var reader = Open(text.ToString());
            Assert.That(reader.BlockCount, Is.GreaterThan(3));
            Assert.That(Points(reader, "X"), Is.EqualTo(Enumerable.Range(0, count).Select(i => i.ToString())));
            using var read = reader.CreateRead(reader.Info.Schema.Select("X"), 50, Allocator.Persistent);
            for (int block = reader.BlockCount - 1; block >= 0; block--)
            {
                int first = random.Next(reader.PointsInBlock(block) - 50);
                read.Begin(new BlockRange(block, first, 50));
                read.Complete();
                for (int i = 0; i < 50; i++)
                    Assert.That(read.Points.Column<long>(0)[i], Is.EqualTo(reader.FirstPointOfBlock(block) + first + i));
            }
        }

        [Test]
        public void Read_LongLines_AreSkipped()
        {
            var text = new StringBuilder();
            for (int i = 0; i < 10000; i++)
                text.Append("1 2 3\n");
            text.Append("7 8 9").Append(' ', 300 << 10).Append("\n7 8 9").Append(' ', 3000).Append('\n');
            for (int i = 0; i < 60000; i++)
                text.Append("4 5 6\n");
            using var reader = Open(text.ToString());
            var points = Points(reader);
            Assert.That(points.Count(p => p == "1 2 3"), Is.EqualTo(10000));
            Assert.That(points.Count(p => p == "7 8 9"), Is.EqualTo(1));
            Assert.That(points.Count(p => p == "4 5 6"), Is.EqualTo(60000));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contain("longer than"));
        }

        [Test]
        public void Open_OneHugeLine_IsRefusedAtOnce()
        {
            var text = new StringBuilder();
            while (text.Length < 3 << 20)
                text.Append("1.5 2.5 ");
            Assert.That(() => Open(text.ToString()), Throws.InstanceOf<PointCloudException>());
        }

        [Test]
        public void Convert_Text_KeepsEveryPoint()
        {
            var random = new System.Random(3);
            var text = new StringBuilder();
            for (int i = 0; i < 30000; i++)
                text.AppendFormat(CultureInfo.InvariantCulture, "{0:F3} {1:F3} {2:F2} {3} {4} {5}\n",
                    500000 + random.NextDouble() * 100, 4000000 + random.NextDouble() * 100,
                    random.NextDouble() * 10, i % 256, 1, 2);
            string target = FilePath + ".fastpoints";
            try
            {
                using var reader = Open(text.ToString());
                ConvertResult result = null;
                JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, target, new ConvertSettings(), r => result = r, null));
                Assert.That(result.Manifest.Points, Is.EqualTo(30000));
                Assert.That(result.Manifest.Grid.Step.x, Is.EqualTo(0.001));
                var verified = new VerifyResult();
                JobCoroutine.RunToEnd(VerifyCloud.Run(target, new[] { reader }, verified, null));
                Assert.That(verified.Problems, Is.Empty);
                Assert.That(reader.Info.Warnings, Is.Empty);
            }
            finally
            {
                Directory.Delete(target, true);
            }
        }
    }
}
