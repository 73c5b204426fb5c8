using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using FastPoints.Reading;
using FastPoints.Tests.Reading;
using FastPoints.Text;
using NUnit.Framework;

namespace FastPoints.Tests.Text
{
    public class PcdReaderTests : FolderTests
    {
        const int Many = 150000;

        string Write(byte[] bytes)
        {
            string path = Folder.File("cloud.pcd");
            File.WriteAllBytes(path, bytes);
            return path;
        }

        static IEnumerable<double> Positions(PointReader reader, string axis) =>
            reader.Info.Schema.Single(a => a.Name == axis).Type == AttributeType.Float64 ? ReadPoints.Column<double>(reader, axis)
                : ReadPoints.Column<float>(reader, axis).Select(v => (double)v);

        static void CheckPoints(PointReader reader, int points)
        {
            Assert.That(reader.PointCount, Is.EqualTo(points));
            var all = Enumerable.Range(0, points).ToArray();
            Assert.That(Positions(reader, "X"), Is.EqualTo(all.Select(i => i + 0.5)));
            Assert.That(Positions(reader, "Y"), Is.EqualTo(all.Select(i => (double)-i)));
            Assert.That(ReadPoints.Column<double>(reader, "Z"), Is.EqualTo(all.Select(i => i * 1e-3)).Within(1e-12));
            Assert.That(ReadPoints.Column<byte>(reader, "Red"), Is.EqualTo(all.Select(i => (byte)(i * 7))));
            Assert.That(ReadPoints.Column<byte>(reader, "Green"), Is.EqualTo(all.Select(i => (byte)(i * 5))));
            Assert.That(ReadPoints.Column<byte>(reader, "Blue"), Is.EqualTo(all.Select(i => (byte)(i * 3))));
            Assert.That(ReadPoints.Column<ushort>(reader, "Intensity"), Is.EqualTo(all.Select(i => (ushort)(i % 1000))));
            Assert.That(ReadPoints.Column<float>(reader, "f[0]"), Is.EqualTo(all.Select(i => (float)i)));
            Assert.That(ReadPoints.Column<float>(reader, "f[2]"), Is.All.EqualTo(2f));
        }

        [TestCase("ascii", 300), TestCase("binary", 300), TestCase("binary_compressed", 300)]
        [TestCase("binary_compressed", Many), TestCase("ascii", 0), TestCase("binary_compressed", 0)]
        public void Open_EachEncoding_HasEachPoint(string data, int points)
        {
            using var reader = ReadPoints.Open(Write(PcdTestFile.Make(data, points)));
            Assert.That(reader.Info.Format, Is.EqualTo("PCD"));
            Assert.That(reader.Info.Version, Is.EqualTo("0.7"));
            Assert.That(reader.Info.PointsClaimed, Is.EqualTo((ulong)points));
            Assert.That(reader.Info.Warnings, Is.Empty);
            Assert.That(reader.Info.Schema.Select(a => a.Name), Is.EqualTo(new[]
                { "X", "Y", "Z", "Red", "Green", "Blue", "Intensity", "f[0]", "f[1]", "f[2]" }));
            if (points > 0)
                CheckPoints(reader, points);
        }

        [TestCase(3922, 0, 0), TestCase(1, 0, 0), TestCase(4096, 0, 1), TestCase(3922, 1, 1)]
        public void Open_BinaryWithTrailingBytes_WarnsUnlessTheyPadAPage(int behind, byte last, int warnings)
        {
            var padding = new byte[behind];
            padding[behind - 1] = last;
            using var reader = ReadPoints.Open(Write(PcdTestFile.Make("binary", 300).Concat(padding).ToArray()));
            CheckPoints(reader, 300);
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(warnings));
        }

        [Test]
        public void Compressed_RangesInAnyOrder_GiveThesePoints()
        {
            using var reader = ReadPoints.Open(Write(PcdTestFile.Make("binary_compressed", Many)));
            Assert.That(reader.BlockCount, Is.GreaterThan(2));
            var ranges = Enumerable.Range(0, reader.BlockCount).Reverse().SelectMany(b => new[]
            {
                new BlockRange(b, reader.PointsInBlock(b) - 7, 7), new BlockRange(b, 0, 1), new BlockRange(b, 1000, 5000),
            }).ToList();
            ReadPoints.InTurns(reader, reader.Info.Schema.Select(new[] { "Y", "Green" }), ranges, 3, read =>
            {
                Assert.That(read.Points.Count, Is.EqualTo(read.Range.Count));
                var y = read.Points.Column<float>(0);
                var green = read.Points.Column<byte>(1);
                for (int i = 0; i < read.Points.Count; i++)
                {
                    Assert.That(y[i], Is.EqualTo(-(float)(read.FirstPoint + i)));
                    Assert.That(green[i], Is.EqualTo((byte)((read.FirstPoint + i) * 5)));
                }
            });
        }

        [TestCase("ascii"), TestCase("binary"), TestCase("binary_compressed")]
        public void Read_TruncatedFile_GivesThePointsBeforeAndAWarning(string data)
        {
            byte[] whole = PcdTestFile.Make(data, 3000);
            // Text ends with a complete line: a broken one is reported when it is decoded.
            int length = data == "ascii" ? Array.LastIndexOf(whole, (byte)'\n', whole.Length - 100) + 1 : whole.Length - 40;
            using var reader = ReadPoints.Open(Write(whole.AsSpan(0, length).ToArray()));
            Assert.That(reader.PointCount, Is.InRange(2000, 2999));
            CheckPoints(reader, (int)reader.PointCount);
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(1));
            Assert.That(reader.Info.Warnings[0].Text, Does.Contain("wanted 3000, got " + reader.PointCount));
        }

        [Test]
        public void FloatColor_OfAPixel_IsItsBits()
        {
            float packed = BitConverter.ToSingle(BitConverter.GetBytes(0x00102030), 0);
            foreach (string data in new[] { "ascii", "binary" })
            {
                var head = Encoding.ASCII.GetBytes("VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 1\n" +
                    "HEIGHT 1\nDATA " + data + "\n");
                byte[] point = data == "ascii" ? Encoding.ASCII.GetBytes("1 2 nan " + packed.ToString("R") + "\n")
                    : new[] { 1f, 2f, float.NaN, packed }.SelectMany(BitConverter.GetBytes).ToArray();
                using var reader = ReadPoints.Open(Write(head.Concat(point).ToArray()));
                Assert.That(ReadPoints.Column<byte>(reader, "Red"), Is.EqualTo(new byte[] { 0x10 }), data);
                Assert.That(ReadPoints.Column<byte>(reader, "Blue"), Is.EqualTo(new byte[] { 0x30 }), data);
                Assert.That(Positions(reader, "Z").Single(), Is.NaN);
            }
        }

        /// <summary>Survey coordinates as text: 32 bits would be half a metre off.</summary>
        [Test]
        public void Open_TextOfFloats_KeepsItsDigits()
        {
            string text = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n" +
                "512345.678 4123456.789 12.345\n";
            using var reader = ReadPoints.Open(Write(Encoding.ASCII.GetBytes(text)));
            Assert.That(new[] { "X", "Y", "Z" }.Select(a => Positions(reader, a).Single()),
                Is.EqualTo(new[] { 512345.678, 4123456.789, 12.345 }));
        }

        [TestCase("# .PCD v.5 - Point Cloud Data file format\nVERSION .5\n"), TestCase("VERSION 0.6\n"), TestCase("")]
        public void Open_EachSignature_IsPcd(string head)
        {
            string text = head + "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n";
            using var reader = ReadPoints.Open(Write(Encoding.ASCII.GetBytes(text)));
            Assert.That(reader.Info.Format, Is.EqualTo("PCD"));
            Assert.That(reader.PointCount, Is.EqualTo(1));
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [TestCase("FIELDS x y z", "FIELDS x y", "SIZE: wanted 2 words, got 3")]
        [TestCase("FIELDS x y z", "FIELDS x y q", "no field z")]
        [TestCase("TYPE F F F", "TYPE F F Q", "TYPE: wanted I or U")]
        [TestCase("SIZE 4 4 4", "SIZE 4 4 2", "TYPE: wanted I or U")]
        [TestCase("POINTS 2", "POINTS -2", "POINTS: wanted a whole number")]
        [TestCase("DATA ascii", "DATA zip", "DATA: wanted ascii, binary or binary_compressed")]
        [TestCase("DATA ascii\n", "", "no DATA line")]
        [TestCase("TYPE F F F\n", "", "no TYPE line")]
        [TestCase("POINTS 2\n", "POINTS 99999999999999999999\n", "POINTS: wanted a whole number")]
        public void Open_BadHeader_NamesTheFault(string sound, string bad, string detail)
        {
            string text = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n" +
                "DATA ascii\n1 2 3\n4 5 6\n";
            string path = Write(Encoding.ASCII.GetBytes(text.Replace(sound, bad)));
            var failure = Assert.Throws<PointCloudException>(() => ReadPoints.Open(path).Dispose());
            Assert.That(failure.IsInputAtFault, Is.True);
            Assert.That(failure.Message, Does.StartWith(path).And.Contain(detail));
        }

        [Test]
        public void Open_OddLinesAndCounts_Warns()
        {
            string path = Write(Encoding.ASCII.GetBytes("# .PCD v0.7\nVERSION 0.7\nAUTHOR me\nFIELDS x y z\nSIZE 4 4 4\n" +
                "TYPE F F F\nWIDTH 3\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n"));
            using var reader = ReadPoints.Open(path);
            Assert.That(reader.PointCount, Is.EqualTo(2));
            Assert.That(reader.Info.Warnings.Select(w => w.Text),
                Has.Some.Contains("\"AUTHOR\"").And.Some.Contains("WIDTH times HEIGHT"));
        }

        [TestCase("POINTS 3000\n", "POINTS 4000000000\n"), TestCase("COUNT 1 1 1 1 2 1 3", "COUNT 1 1 1 1 2 1 4000000000")]
        public void Compressed_LargeClaims_AreRefused(string sound, string bad)
        {
            var text = Encoding.GetEncoding(28591);
            string path = Write(text.GetBytes(text.GetString(PcdTestFile.Make("binary_compressed", 3000)).Replace(sound, bad)));
            Assert.That(Assert.Throws<PointCloudException>(() => ReadPoints.Open(path).Dispose()).IsInputAtFault, Is.True);
        }

        [Test]
        public void Lzf_NoiseRunsAndLongCopies_RoundTrips()
        {
            var random = new Random(3);
            foreach (byte[] bytes in new[]
            {
                new byte[5000],
                Enumerable.Range(0, 30000).Select(i => (byte)random.Next(256)).ToArray(),
                Enumerable.Range(0, 30000).Select(i => (byte)(i / 8000 * 50 + i % 9)).ToArray(),
            })
                Assert.That(Decode(PcdTestFile.Compress(bytes), bytes.Length), Is.EqualTo(bytes));
        }

        static unsafe byte[] Decode(byte[] lzf, int length)
        {
            var output = new byte[length + 264];
            int done = 0, taken = 0;
            fixed (byte* from = lzf)
            fixed (byte* to = output)
                while (done < length)
                {
                    int written = Lzf.Step(from + taken, lzf.Length - taken, to + done, done, out int bytes);
                    Assert.That(written, Is.GreaterThan(0));
                    done += written;
                    taken += bytes;
                }
            Assert.That((done, taken), Is.EqualTo((length, lzf.Length)));
            return output.AsSpan(0, length).ToArray();
        }
    }
}
