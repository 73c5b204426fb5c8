using System;
using System.Text;
using FastPoints.Tests.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Text
{
    public class PlyAsciiReaderTests
    {
        static PlyTestFile Xyz(int points, string data, params string[] moreProperties)
        {
            var lines = new string[4 + moreProperties.Length];
            lines[0] = "element vertex " + points;
            lines[1] = "property float x";
            lines[2] = "property float y";
            lines[3] = "property float z";
            moreProperties.CopyTo(lines, 4);
            return PlyTestFile.WithHeader("ascii", lines).Text(data).Save();
        }

        [TestCase("1 2 3\n4 5 6\n")]
        [TestCase("1 2 3\r4 5 6\r")]
        [TestCase("1 2 3\r\n4 5 6\r\n")]
        [TestCase("1 2 3\n4 5 6")]
        [TestCase("\n\n  1\t2  3 \r\r\n \t \n  4 5 6\n\n")]
        [TestCase("1 2 3\r4 5 6\n")]
        public void Read_AnyLineEndsAndBlanks_GivesTheLines(string data)
        {
            using var file = Xyz(2, data);
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f, 4f }));
            Assert.That(contents.Column<float>("Z"), Is.EqualTo(new[] { 3f, 6f }));
            Assert.That(contents.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Read_NonFiniteCoordinates_PassThrough()
        {
            using var file = Xyz(2, "nan +inf -inf\n1.#QNAN 1e99 -1e-99\n");
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { float.NaN, float.NaN }));
            Assert.That(contents.Column<float>("Y"), Is.EqualTo(new[] { float.PositiveInfinity, float.PositiveInfinity }));
            Assert.That(contents.Column<float>("Z")[0], Is.EqualTo(float.NegativeInfinity));
        }

        [Test]
        public void Read_ValuesOutOfTheirTypesRange_AreClampedWithOneWarning()
        {
            const string Data = "0 0 0 300 -1 1.9 -5\n0 0 0 -7 40000 1e3 -2147483649\n0 0 0 256 -40000 nan 5.0\n";
            using var file = Xyz(3, Data, "property uchar a", "property short b", "property char c", "property int d");
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Column<byte>("a"), Is.EqualTo(new byte[] { 255, 0, 255 }));
            Assert.That(contents.Column<short>("b"), Is.EqualTo(new short[] { -1, 32767, -32768 }));
            Assert.That(contents.Column<sbyte>("c"), Is.EqualTo(new sbyte[] { 1, 127, 0 }));
            Assert.That(contents.Column<int>("d"), Is.EqualTo(new[] { -5, int.MinValue, 5 }));
            Assert.That(contents.Info.Warnings.Count, Is.EqualTo(1));
            var warning = contents.Warning("cannot hold");
            Assert.That(warning.Text, Does.Contain("(9 in this block"));
            Assert.That(warning.ByteOffset, Is.EqualTo(file.Length - Data.Length + 6));
        }

        [Test]
        public void Read_MoreValuesThanProperties_AreIgnoredWithOneWarning()
        {
            using var file = Xyz(2, "1 2 3 4\n5 6 7 x y\n");
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f, 5f }));
            Assert.That(contents.Warning("2 lines").ByteOffset, Is.EqualTo(file.Length - 18 + 6));
        }

        [TestCase("1 2 3\n4 5\n6 7 8\n", 9, "before the vertex has all")]
        [TestCase("1 2 3\n4 5 zero\n6 7 8\n", 10, "not a number")]
        [TestCase("1 2 3\n4 0x5 6\n6 7 8\n", 8, "not a number")]
        public void Read_BadLine_EndsTheBlockWithAWarning(string data, int at, string message)
        {
            using var file = Xyz(3, data);
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f }));
            Assert.That(contents.Info.Warnings.Count, Is.EqualTo(1));
            Assert.That(contents.Warning(message).ByteOffset, Is.EqualTo(file.Length - data.Length + at));
            Assert.That(contents.Info.Warnings[0].Text, Does.Contain("2 vertices in 1 blocks"));
        }

        [Test]
        public void Read_BadFirstLine_IsRefused()
        {
            using var file = Xyz(2, "a b c\n1 2 3\n");
            var failure = Failures.Of(() => FileContents.OfPly(file.Path), FailureCode.BadInput);
            Assert.That(failure.ByteOffset, Is.EqualTo(file.Length - 12));
        }

        [Test]
        public void Read_BadValueInUnrequestedColumn_IsSkipped()
        {
            using var file = Xyz(2, "1 2 3 what\n4 5 6 ever\n", "property int a");
            Assert.That(FileContents.OfPly(file.Path, "X", "Y", "Z").Points, Is.EqualTo(2));
        }

        [TestCase("-1"), TestCase("1.5"), TestCase("x"), TestCase("4"), TestCase("99999999999999999999")]
        public void Read_BadListLength_EndsTheBlock(string length)
        {
            using var file = Xyz(2, "1 2 3 1 9\n4 5 6 " + length + " 8\n", "property list uchar int l");
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Points, Is.EqualTo(1));
            Assert.That(contents.Info.Warnings.Count, Is.EqualTo(1));
        }

        /// <summary>Over 2 MiB of lines of odd lengths with all kinds of line ends: every block border falls somewhere
        /// else.</summary>
        [TestCase("\n", 0), TestCase("\r", 1), TestCase("\r\n", 2), TestCase("\n\n  \n", 3)]
        public void Read_SeveralBlocks_ReadEachLineOnce(string lineEnd, int shift)
        {
            const int Points = 120000;
            var text = new StringBuilder(new string(' ', shift));
            var random = new Random(3 + shift);
            for (int n = 0; n < Points; n++)
                text.Append(' ', random.Next(3)).Append(n).Append(" 0.25 ").Append(-n).Append(".5").Append(' ', random.Next(4))
                    .Append(lineEnd);
            using var file = Xyz(Points - 5, text.ToString());
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Blocks, Is.GreaterThanOrEqualTo(3));
            Assert.That(contents.Points, Is.EqualTo(Points - 5));
            Assert.That(contents.Info.Warnings, Is.Empty);
            var x = contents.Column<float>("X");
            for (int n = 0; n < x.Length; n++)
                if (x[n] != n)
                    Assert.Fail("line " + n + ": " + x[n]);
        }

        [Test]
        public void Read_LineAtABlockBorder_BelongsToTheBlockItStartsIn([Range(-4, 8)] int shift)
        {
            string fill = new string('\n', PlyAsciiReaderBlockBytes - 6 + shift);
            using var file = Xyz(3, fill + "1 2 3\n4 5 6\n7 8 9\n");
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f, 4f, 7f }));
            Assert.That(contents.Column<float>("Z"), Is.EqualTo(new[] { 3f, 6f, 9f }));
        }

        const int PlyAsciiReaderBlockBytes = 1 << 20;

        [Test]
        public void Read_LineOverABlockBorder_IsReadUpToItsLimit()
        {
            // The line starts one byte before the border and runs on as far as a line may, then one byte farther.
            string fill = new string('\n', PlyAsciiReaderBlockBytes - 1);
            using (var file = Xyz(3, "1 2 3" + fill.Substring(5) + "4 5 6" + new string(' ', 65530) + "\n7 8 9\n"))
                Assert.That(FileContents.OfPly(file.Path).Column<float>("X"), Is.EqualTo(new[] { 1f, 4f, 7f }));
            using (var file = Xyz(3, "1 2 3" + fill.Substring(5) + "4 5 6" + new string(' ', 65540) + "\n7 8 9\n"))
            {
                var contents = FileContents.OfPly(file.Path);
                Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f, 7f }));
                Assert.That(contents.Warning("longer than").ByteOffset, Is.EqualTo(file.Length - 6 - 65546));
            }
        }

        [Test]
        public void Read_NoLineEndWithinTheLimit_IsOneBrokenLine()
        {
            using var file = Xyz(5, new string('7', 3 << 20));
            Failures.Of(() => FileContents.OfPly(file.Path), FailureCode.BadInput, "longer than");
        }

        [Test]
        public void IndexBlocks_LongElementsAroundTheVertices_ReadsOnlyTheVertices()
        {
            var text = new StringBuilder();
            for (int i = 0; i < 150000; i++)
                text.Append("3 0 1 2\n");
            string faces = text.ToString();
            using var file = PlyTestFile.WithHeader("ascii", "element face 150000", "property list uchar int i",
                "element vertex 2",
                "property float x", "property float y", "property float z", "element more 150000", "property list uchar int i");
            file.Text(faces).Text("1 2 3\n4 5 6\n").Text(faces).Save();
            var contents = FileContents.OfPly(file.Path);
            Assert.That(contents.Blocks, Is.EqualTo(1));
            Assert.That(contents.Column<float>("X"), Is.EqualTo(new[] { 1f, 4f }));
        }
    }
}
