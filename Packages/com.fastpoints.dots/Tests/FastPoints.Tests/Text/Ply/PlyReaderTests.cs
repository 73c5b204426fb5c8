using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Text
{
    [Category("Smoke")]
    public class PlyReaderTests
    {
        static readonly string[] s_formats = { "ascii", "binary_little_endian", "binary_big_endian" };

        static readonly object[][] s_types =
        {
            new object[] { "char", AttributeType.Int8, sbyte.MinValue, sbyte.MaxValue },
            new object[] { "int8", AttributeType.Int8, (sbyte)-1, (sbyte)1 },
            new object[] { "uchar", AttributeType.UInt8, (byte)0, byte.MaxValue },
            new object[] { "uint8", AttributeType.UInt8, (byte)1, (byte)254 },
            new object[] { "bool", AttributeType.UInt8, (byte)0, (byte)1 },
            new object[] { "short", AttributeType.Int16, short.MinValue, short.MaxValue },
            new object[] { "int16", AttributeType.Int16, (short)-2, (short)258 },
            new object[] { "ushort", AttributeType.UInt16, (ushort)0, ushort.MaxValue },
            new object[] { "uint16", AttributeType.UInt16, (ushort)1, (ushort)513 },
            new object[] { "int", AttributeType.Int32, int.MinValue, int.MaxValue },
            new object[] { "int32", AttributeType.Int32, -3, 0x01020304 },
            new object[] { "uint", AttributeType.UInt32, 0u, uint.MaxValue },
            new object[] { "uint32", AttributeType.UInt32, 1u, 0xFF020304u },
            new object[] { "int64", AttributeType.Int64, long.MinValue, long.MaxValue },
            new object[] { "uint64", AttributeType.UInt64, 0x0102030405060708ul, ulong.MaxValue },
            new object[] { "float", AttributeType.Float32, -0.1f, 3.4028235e38f },
            new object[] { "float32", AttributeType.Float32, 1.17549435e-38f, 1e-45f },
            new object[] { "double", AttributeType.Float64, -0.1, 1.7976931348623157e308 },
            new object[] { "float64", AttributeType.Float64, 430123.12345678901, 5e-324 },
        };

        /// <summary>Exporters have written remarks without "comment"; what may declare values is refused.</summary>
        [Test]
        public void Open_UnknownHeaderLine_IsAWarningUnlessItMayDeclareValues(
            [Values("Created by Blender 2.80 - www.blender.org", "author", "date 2020 01 02")] string line)
        {
            using (var file = PlyTestFile.WithHeader("ascii", "element vertex 1", line, "property float x", "property float y",
                "property float z"))
            {
                System.IO.File.WriteAllBytes(file.Path, file.Text("1 2 3\n").ToArray());
                var contents = FileContents.OfPly(file.Path);
                Assert.That(contents.Points, Is.EqualTo(1));
                Assert.That(contents.Warning("header line").Text, Does.Contain("got \"" + line.Split(' ')[0] + "\""));
            }
            foreach (string declaration in new[] { "propert float q", "propert list uchar int q", "elem face 3" })
                using (var file = PlyTestFile.WithHeader("ascii", "element vertex 1", "property float x", "property float y",
                    "property float z", declaration))
                {
                    System.IO.File.WriteAllBytes(file.Path, file.Text("1 2 3\n").ToArray());
                    Assert.That(Assert.Throws<PointCloudException>(() => FileContents.OfPly(file.Path)).Message,
                        Does.Contain("header line"));
                }
        }

        static void Append(PlyTestFile file, string format, bool endsLine, params object[] values)
        {
            if (format != "ascii")
            {
                file.Values(format == "binary_big_endian", values);
                return;
            }
            foreach (object value in values)
                file.Text(value is float single ? single.ToString("R", CultureInfo.InvariantCulture) + " "
                    : value is double number ? number.ToString("R", CultureInfo.InvariantCulture) + " "
                    : System.Convert.ToString(value, CultureInfo.InvariantCulture) + " ");
            if (endsLine)
                file.Text("\n");
        }

        static PlyTestFile Xyz(string format, int points, params string[] moreLines)
        {
            var lines = new List<string> { "element vertex " + points, "property float x", "property float y",
                "property float z" };
            lines.AddRange(moreLines);
            return PlyTestFile.WithHeader(format, lines.ToArray());
        }

        [Test]
        public void Read_EachTypeInEachEncoding_KeepsItsBits(
            [ValueSource(nameof(s_formats))] string format, [Range(0, 17)] int row)
        {
            var type = s_types[row];
            using var file = Xyz(format, 2, "property " + type[0] + " thing", "property uchar last");
            Append(file, format, true, 1f, 2f, 3f, type[2], (byte)7);
            Append(file, format, true, 4f, 5f, 6f, type[3], (byte)8);
            file.Save();
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Points, Is.EqualTo(2));
            Assert.That(contents.Info.Schema[3].Type, Is.EqualTo(type[1]));
            var wanted = new List<byte>(PlyTestFile.BytesOf(type[2]));
            wanted.AddRange(PlyTestFile.BytesOf(type[3]));
            Assert.That(contents.Bytes("thing"), Is.EqualTo(wanted.ToArray()));
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f, 4f }));
            Assert.That(contents.Column<float>("Z"), Is.EqualTo(new[] { 3f, 6f }));
            Assert.That(contents.Column<byte>("last"), Is.EqualTo(new byte[] { 7, 8 }));
            Assert.That(contents.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Read_CoordinatesOfEachType_AreColumnsOfThatType(
            [ValueSource(nameof(s_formats))] string format, [Values("short", "int", "float", "double")] string type)
        {
            using var file = PlyTestFile.WithHeader(format, "element vertex 2", "property " + type + " x",
                "property " + type + " y", "property " + type + " z");
            object Cast(int v) => type == "short" ? (short)v : type == "int" ? v : type == "float" ? (float)v : (object)(double)v;
            Append(file, format, true, Cast(1), Cast(-2), Cast(3));
            Append(file, format, true, Cast(4), Cast(5), Cast(-600));
            file.Save();
            var contents = FileContents.OfPly(file.Path);
            var wanted = new List<byte>(PlyTestFile.BytesOf(Cast(3)));
            wanted.AddRange(PlyTestFile.BytesOf(Cast(-600)));
            Assert.That(contents.Bytes("Z"), Is.EqualTo(wanted.ToArray()));
            Assert.That(contents.Info.Transform.Scale.x, Is.EqualTo(1));
        }

        [Test]
        public void Read_AnySubsetOfAttributes_GivesTheSameAsAll([ValueSource(nameof(s_formats))] string format)
        {
            var types = new[] { "uchar", "uchar", "ushort", "ushort", "ushort", "ushort", "double", "double", "float", "char",
                "int64" };
            var lines = new List<string>();
            for (int i = 0; i < types.Length; i++)
                lines.Add("property " + types[i] + " p" + i);
            using var file = Xyz(format, 3, lines.ToArray());
            for (int n = 0; n < 3; n++)
                Append(file, format, true, 0.5f + n, 1.5f, -2.5f, (byte)n, (byte)(n + 1), (ushort)(n + 600),
                    (ushort)(n + 700),
                    (ushort)(n + 800), (ushort)(n + 900), n + 0.125, n - 0.125, n * 3f, (sbyte)-n, n - 70000000000L);
            file.Save();
            var all = FileContents.OfPly(file.Path);
            var random = new Random(5);
            for (int trial = 0; trial < 60; trial++)
            {
                var names = new List<string>();
                foreach (var attribute in all.Info.Schema)
                    if (random.Next(2) == 0)
                        names.Add(attribute.Name);
                if (names.Count == 0)
                    continue;
                var some = FileContents.OfPly(file.Path, names.ToArray());
                foreach (string name in names)
                    Assert.That(some.Bytes(name), Is.EqualTo(all.Bytes(name)), name);
            }
        }

        [Test]
        public void Read_ListsAroundAndWithinTheVertices_AreSkipped([ValueSource(nameof(s_formats))] string format)
        {
            using var file = PlyTestFile.WithHeader(format, "element camera 1", "property float f", "property double g",
                "element nothing 5", "element face 3", "property uchar flag", "property list uchar int i",
                    "property list int double d",
                "element vertex 3", "property list ushort short before", "property float x", "property float y",
                "property list uchar uchar middle", "property float z", "property uchar red",
                "element edge 1", "property int a");
            Append(file, format, true, 1f, 2.0);
            Append(file, format, true, (byte)1, (byte)3, 0, 1, 2, 1, 0.5);
            Append(file, format, true, (byte)2, (byte)0, 0);
            Append(file, format, true, (byte)3, (byte)1, 9, 2, 0.5, 0.25);
            Append(file, format, true, (ushort)0, 1f, 2f, (byte)1, (byte)77, 3f, (byte)10);
            Append(file, format, true, (ushort)2, (short)-5, (short)6, 4f, 5f, (byte)0, 6f, (byte)20);
            Append(file, format, true, (ushort)1, (short)1, 7f, 8f, (byte)2, (byte)1, (byte)2, 9f, (byte)30);
            Append(file, format, true, 5);
            file.Save();
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Info.Schema.ToString(), Is.EqualTo("X:Float32, Y:Float32, Z:Float32, Red:UInt8"));
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f, 4f, 7f }));
            Assert.That(contents.Column<float>("Y"), Is.EqualTo(new[] { 2f, 5f, 8f }));
            Assert.That(contents.Column<float>("Z"), Is.EqualTo(new[] { 3f, 6f, 9f }));
            Assert.That(contents.Info.Warnings, Is.Empty);
            Assert.That(FileContents.OfPly(file.Path, "Z").Column<float>("Z"), Is.EqualTo(new[] { 3f, 6f, 9f }));
        }

        [Test]
        public void Read_ListsBeforeTheVerticesOnly_KeepsFixedRecords(
            [Values("binary_little_endian", "binary_big_endian")] string format)
        {
            using var file = PlyTestFile.WithHeader(format, "element face 2", "property list uint short i", "element vertex 2",
                "property float x", "property float y", "property float z");
            Append(file, format, true, 2u, (short)1, (short)2, 0u, 1f, 2f, 3f, 4f, 5f, 6f);
            file.Save();
            using (var reader = PointReaders.Open(file.Path))
            {
                Assert.That(reader.BlocksAreKnown, Is.False);
                JobCoroutine.RunToEnd(reader.IndexBlocks());
                Assert.That(reader.BlocksAreKnown, Is.True);
                Assert.That(reader.HasCheapRanges, Is.True);
                Assert.That(reader.PointCount, Is.EqualTo(2));
            }
            Assert.That(FileContents.OfPly(file.Path).Column<float>("X"), Is.EqualTo(new[] { 1f, 4f }));
        }

        [Test]
        public void Read_PartsOfABlock_GivesThesePoints([ValueSource(nameof(s_formats))] string format, [Values] bool hasList)
        {
            string list = hasList ? "property list uchar uchar l" : "property uchar l";
            using var file = Xyz(format, 100, list);
            for (int n = 0; n < 100; n++)
                Append(file, format, true, (float)n, n * 0.5f, -(float)n, (byte)0);
            file.Save();
            using var reader = PointReaders.Open(file.Path);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            Assert.That(reader.BlockCount, Is.EqualTo(1));
            using var read = reader.CreateRead(reader.Info.Schema.Select("X", "Y"), 40, Allocator.Persistent);
            foreach (var range in new[] { new BlockRange(0, 0, 40), new BlockRange(0, 60, 40),
                new BlockRange(0, 99, 1),
                         new BlockRange(0, 5, 0), new BlockRange(0, 31, 7) })
            {
                read.Begin(range);
                read.Complete();
                Assert.That(read.FirstPoint, Is.EqualTo(range.First));
                Assert.That(read.Points.Count, Is.EqualTo(range.Count));
                var y = read.Points.Column<float>("Y");
                for (int i = 0; i < range.Count; i++)
                    Assert.That(y[i], Is.EqualTo((range.First + i) * 0.5f));
            }
            Assert.That(() => read.Begin(new BlockRange(0, 0, 41)), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => read.Begin(new BlockRange(0, 90, 11)), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => read.Begin(new BlockRange(1, 0, 1)), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => read.Complete(), Throws.InvalidOperationException);
        }

        [Test]
        public void Read_SeveralSlotsInFlight_EachGivesItsRange([ValueSource(nameof(s_formats))] string format)
        {
            using var file = Xyz(format, 60);
            for (int n = 0; n < 60; n++)
                Append(file, format, true, (float)n, 0f, 0f);
            file.Save();
            using var reader = PointReaders.Open(file.Path);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            var reads = new BlockRead[3];
            for (int i = 0; i < reads.Length; i++)
                reads[i] = reader.CreateRead(reader.Info.Schema, 20, Allocator.Persistent);
            for (int i = 0; i < reads.Length; i++)
                reads[i].Begin(new BlockRange(0, 20 * i, 20));
            Assert.That(() => reads[0].Begin(new BlockRange(0, 0, 1)), Throws.InvalidOperationException);
            for (int i = 0; i < reads.Length - 1; i++)
            {
                reads[i].Complete();
                Assert.That(reads[i].Points.Column<float>("X")[19], Is.EqualTo(20 * i + 19));
            }
            // The last is given up in flight.
            foreach (var read in reads)
            {
                read.Dispose();
                read.Dispose();
            }
        }

        [Test]
        public void CreateRead_AttributeMissingInTheFile_Throws()
        {
            using var file = Xyz("binary_little_endian", 1).Values(false, 1f, 2f, 3f).Save();
            using var reader = PointReaders.Open(file.Path);
            var other = new PointSchema(new[] { new PointAttribute("Red", AttributeType.UInt8) });
            Assert.That(() => reader.CreateRead(other, 1, Allocator.Persistent), Throws.ArgumentException);
        }

        [Test]
        public void Read_NoVertices_IsAnEmptyCloud([ValueSource(nameof(s_formats))] string format, [Values] bool hasList)
        {
            using var file = Xyz(format, 0, hasList ? "property list uchar int l" : "property int l").Save();
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Blocks, Is.EqualTo(0));
            Assert.That(contents.Info.PointsReadable, Is.EqualTo(0));
            Assert.That(contents.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Read_FewerVerticesThanClaimed_GivesTheExistingOnes([ValueSource(nameof(s_formats))] string format,
            [Values] bool hasList,
            [Values("4", "99999999999", "18446744073709551615", "999999999999999999999999")] string claimed)
        {
            using var file = PlyTestFile.WithHeader(format, "element vertex " + claimed, "property float x", "property float y",
                "property float z", hasList ? "property list uchar uchar l" : "property uchar l");
            for (int n = 0; n < 3; n++)
                Append(file, format, true, (float)n, 0f, 0f, (byte)0);
            if (format != "ascii")
                file.Values(false, 1f);
            file.Save();
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 0f, 1f, 2f }));
            Assert.That(contents.Info.PointsReadable, Is.EqualTo(3));
            Assert.That(contents.Info.Warnings.Count, Is.EqualTo(1));
            var warning = contents.Warning("got 3");
            long wanted = format != "ascii" && hasList ? file.Length - 4 : file.Length;
            Assert.That(warning.ByteOffset, Is.EqualTo(wanted));
        }

        [Test]
        public void Read_NoneOfTheClaimedVertices_IsTruncated([ValueSource(nameof(s_formats))] string format,
            [Values] bool hasList)
        {
            using var file = Xyz(format, 5, hasList ? "property list uchar uchar l" : "property uchar l").Save();
            var failure = Failures.Of(() => FileContents.OfPly(file.Path), FailureCode.Truncated);
            Assert.That(failure.ByteOffset, Is.EqualTo(file.Length));
        }

        [Test]
        public void Read_BytesAfterTheLastElement_AreIgnoredWithAWarning()
        {
            using var file = Xyz("binary_little_endian", 1).Values(false, 1f, 2f, 3f).Text("tail").Save();
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Points, Is.EqualTo(1));
            Assert.That(contents.Warning("4 bytes behind").ByteOffset, Is.EqualTo(file.Length - 4));
        }

        [Test]
        public void Read_BareCrInABinaryFile_StartsTheDataAfterIt()
        {
            const string Header = "ply\rformat binary_little_endian 1.0\relement vertex 2\rproperty uchar x\r" +
                                  "property uchar y\rproperty uchar z\rend_header\r";
            using var file = new PlyTestFile(Header).Raw(new byte[] { 10, 13, 3, 4, 5, 6 }).Save();
            Assert.That(FileContents.OfPly(file.Path).Column<byte>("X"), Is.EqualTo(new byte[] { 10, 4 }));
        }

        [Test]
        public void Open_CommentsAndElements_AreFacts()
        {
            using var file = Xyz("ascii", 0, "comment made by hand", "obj_info shift 5").Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.Format, Is.EqualTo("PLY"));
            Assert.That(reader.Info.Version, Is.EqualTo("1.0"));
            Assert.That(reader.Info.Facts, Does.Contain(new KeyValuePair<string, string>("comment", "made by hand")));
            Assert.That(reader.Info.Facts, Does.Contain(new KeyValuePair<string, string>("obj_info", "shift 5")));
            Assert.That(reader.Info.Facts, Does.Contain(new KeyValuePair<string, string>("encoding", "ascii")));
        }

        [TestCase("element face 1", "property float x", "no vertex element")]
        [TestCase("element vertex 1", "property float y", "no property x")]
        [TestCase("element vertex 1", "property list uchar float x", "no property x")]
        public void Open_NoPositions_IsRefused(string element, string property, string message)
        {
            using var file = PlyTestFile.WithHeader("ascii", element, property, "property float z").Text("1 2\n").Save();
            Failures.Of(() => PointReaders.Open(file.Path), FailureCode.BadInput, message);
        }

        [Test]
        public void Open_HeaderWithoutEnd_IsRefusedAfterItsBound()
        {
            using var file = new PlyTestFile("ply\nformat ascii 1.0\ncomment ");
            file.Raw(new byte[2 << 20]).Save();
            Failures.Of(() => PointReaders.Open(file.Path), FailureCode.BadInput, "1048576");
        }

        [Test]
        public void Open_LongHeader_IsRead()
        {
            using var file = Xyz("ascii", 1, "comment " + new string('c', 200000)).Text("1 2 3\n").Save();
            Assert.That(FileContents.OfPly(file.Path).Points, Is.EqualTo(1));
        }

        [Test]
        public void Read_FileThatShrankSinceItWasOpened_IsTruncated()
        {
            using var file = Xyz("binary_little_endian", 1000).Raw(new byte[12000]).Save();
            using var reader = PointReaders.Open(file.Path);
            using (var stream = new FileStream(file.Path, FileMode.Open, FileAccess.Write, FileShare.ReadWrite))
                stream.SetLength(5000);
            using var read = reader.CreateRead(reader.Info.Schema, 1000, Allocator.Persistent);
            read.Begin(new BlockRange(0, 0, 1000));
            Assert.That(Assert.Throws<PointCloudException>(() => read.Complete()).Code, Is.EqualTo(FailureCode.Truncated));
        }

        [Test]
        public void Read_ManyRecords_ComeInBlocks([Values("binary_little_endian", "binary_big_endian")] string format,
            [Values] bool hasList)
        {
            const int Points = 150000;
            using var file = Xyz(format, Points, hasList ? "property list uchar ushort l" : "property uchar l");
            for (int n = 0; n < Points; n++)
            {
                Append(file, format, true, (float)n, (float)-n, 0.5f, (byte)(hasList ? n % 3 : 0));
                if (hasList)
                    file.Raw(new byte[n % 3 * 2]);
            }
            file.Save();
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Points, Is.EqualTo(Points));
            Assert.That(contents.Blocks, Is.GreaterThan(1));
            var x = contents.Column<float>("X");
            var y = contents.Column<float>("Y");
            for (int n = 0; n < Points; n++)
                if (x[n] != n || y[n] != -n)
                    Assert.Fail("point " + n);
        }

        [Test]
        public void IndexBlocks_NegativeListLength_KeepsThePointsBefore()
        {
            using var file = Xyz("binary_little_endian", 4, "property list char int l");
            file.Values(false, 1f, 2f, 3f, (sbyte)1, 5, 4f, 5f, 6f, (sbyte)-1, 7, 7f, 8f, 9f, (sbyte)0).Save();
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f }));
            Assert.That(contents.Warning("negative length").ByteOffset, Is.EqualTo(file.Length - 13 - 4 - 1));
        }

        [Test]
        public void IndexBlocks_ListLongerThanTheFile_KeepsThePointsBefore()
        {
            using var file = Xyz("binary_big_endian", 2, "property list uint64 double l");
            file.Values(true, 1f, 2f, 3f, 0ul, 4f, 5f, 6f, ulong.MaxValue, 7.0).Save();
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f }));
            Assert.That(contents.Warning("ends within").ByteOffset, Is.EqualTo(file.Length - 28));
        }

        [Test]
        public void IndexBlocks_Cancelled_FreesEverything([ValueSource(nameof(s_formats))] string format)
        {
            using var file = Xyz(format, 3, "property list uchar uchar l");
            for (int n = 0; n < 3; n++)
                Append(file, format, true, (float)n, 0f, 0f, (byte)0);
            file.Save();
            using var reader = PointReaders.Open(file.Path);
            var work = new CoroutineStack(reader.IndexBlocks());
            Assert.That(work.MoveNext(), Is.True);
            work.Dispose();
            Assert.That(reader.BlocksAreKnown, Is.False);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            Assert.That(reader.PointCount, Is.EqualTo(3));
        }
    }
}
