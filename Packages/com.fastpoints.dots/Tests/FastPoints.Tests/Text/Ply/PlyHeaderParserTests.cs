using System.Text;
using FastPoints.Text;
using NUnit.Framework;

namespace FastPoints.Tests.Text
{
    public class PlyHeaderParserTests
    {
        static PlyHeader Parse(string text)
        {
            byte[] bytes = Encoding.ASCII.GetBytes(text);
            return PlyHeaderParser.Parse("a.ply", bytes, bytes.Length, true);
        }

        static PointCloudException Failure(string text) => Assert.Throws<PointCloudException>(() => Parse(text));

        const string Usual = "ply\nformat ascii 1.0\ncomment one  two\nobj_info three\nelement vertex 5\n" +
                             "property float x\nproperty list uchar int more\nelement face 7\nend_header\n";

        [Test]
        public void Parse_UsualHeader_GivesItsDeclarations()
        {
            var header = Parse(Usual + "0");
            Assert.That(header.Encoding, Is.EqualTo(PlyEncoding.Ascii));
            Assert.That(header.Version, Is.EqualTo("1.0"));
            Assert.That(header.DataOffset, Is.EqualTo(Usual.Length));
            Assert.That(header.VertexIndex, Is.EqualTo(0));
            Assert.That(header.Elements.Count, Is.EqualTo(2));
            Assert.That(header.Elements[0].Count, Is.EqualTo(5));
            Assert.That(header.Elements[0].Properties[0].Name, Is.EqualTo("x"));
            Assert.That(header.Elements[0].Properties[1].IsList, Is.True);
            Assert.That(header.Elements[0].Properties[1].CountType, Is.EqualTo(FastPoints.AttributeType.UInt8));
            Assert.That(header.Elements[0].FixedBytes, Is.EqualTo(-1));
            Assert.That(header.Comments[0].Key, Is.EqualTo("comment"));
            Assert.That(header.Comments[0].Value, Is.EqualTo("one  two"));
            Assert.That(header.Comments[1].Value, Is.EqualTo("three"));
        }

        [TestCase("\n"), TestCase("\r"), TestCase("\r\n")]
        public void Parse_AnyLineEnd_FindsTheData(string end)
        {
            string text = Usual.Replace("\n", end);
            Assert.That(Parse(text + "\x1\x2").DataOffset, Is.EqualTo(text.Length));
        }

        [Test]
        public void Parse_BareCrAndDataThatStartsWithLf_LeavesTheLfToTheData()
        {
            string text = Usual.Replace("\n", "\r");
            Assert.That(Parse(text + "\n\x2").DataOffset, Is.EqualTo(text.Length));
        }

        [Test]
        public void Parse_LfLinesButCrLfAtTheEnd_TakesBoth()
        {
            string text = Usual.TrimEnd('\n') + "\r\n";
            Assert.That(Parse(text + "\x1").DataOffset, Is.EqualTo(text.Length));
        }

        [Test]
        public void Parse_LfLinesAndLfAtTheEnd_LeavesNextByteToTheData() =>
            Assert.That(Parse(Usual + "\r\n").DataOffset, Is.EqualTo(Usual.Length));

        [Test]
        public void Parse_TabsRepeatedAndTrailingBlanks_AreSeparators()
        {
            const string Text = "ply \n\tformat   ascii 1.0\t\n\n element\tvertex\t\t3 \nproperty   float\t x \nend_header  \n";
            var header = Parse(Text + "1");
            Assert.That(header.Elements[0].Count, Is.EqualTo(3));
            Assert.That(header.Elements[0].Properties[0].Name, Is.EqualTo("x"));
            Assert.That(header.DataOffset, Is.EqualTo(Text.Length));
        }

        [Test]
        public void Parse_EndHeaderAtTheFilesEnd_NeedsNoLineEnd() =>
            Assert.That(Parse("ply\nformat ascii 1.0\nend_header").DataOffset, Is.EqualTo(31));

        [Test]
        public void Parse_IncompleteHeader_RequestsMoreBytes()
        {
            byte[] bytes = Encoding.ASCII.GetBytes(Usual);
            for (int length = 4; length < bytes.Length; length++)
                Assert.That(PlyHeaderParser.Parse("a.ply", bytes, length, false), Is.Null);
        }

        [Test]
        public void Parse_CountBeyond64Bits_IsTheLargest()
        {
            var header = Parse("ply\nformat ascii 1.0\nelement vertex 99999999999999999999999\nend_header\n");
            Assert.That(header.Elements[0].Count, Is.EqualTo(ulong.MaxValue));
        }

        [TestCase("", 0)]
        [TestCase("PLY\nformat ascii 1.0\nend_header\n", 0)]
        [TestCase("plywood\n", 0)]
        [TestCase("ply\nformat ascii 1.0\nelement vertex -5\nend_header\n", 21)]
        [TestCase("ply\nformat ascii 1.0\nelement vertex many\nend_header\n", 21)]
        [TestCase("ply\nformat ascii 1.0\nelement vertex\nend_header\n", 21)]
        [TestCase("ply\nformat ascii 1.0\nproperty float x\nend_header\n", 21)]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 1\nproperty float\nend_header\n", 38)]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 1\nproperty list int x\nend_header\n", 38)]
        [TestCase("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\nend_header\n", 38)]
        [TestCase("ply\nformat utf8 1.0\nend_header\n", 4)]
        [TestCase("ply\nelemnt vertex 1\nend_header\n", 4)]
        [TestCase("ply\nelement vertex 1\nend_header\n", 32)]
        public void Parse_BadLine_NamesItsByte(string text, int offset)
        {
            var failure = Failure(text);
            Assert.That(failure.Code, Is.EqualTo(FailureCode.BadInput));
            Assert.That(failure.ByteOffset, Is.EqualTo(offset));
        }

        [Test]
        public void Parse_UnknownType_IsUnsupportedAndNamed()
        {
            var failure = Failure("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n");
            Assert.That(failure.Code, Is.EqualTo(FailureCode.Unsupported));
            Assert.That(failure.ByteOffset, Is.EqualTo(38));
            Assert.That(failure.Message, Does.Contain("\"half\""));
        }

        [Test]
        public void Parse_NoEndHeader_IsTruncated() =>
            Assert.That(Failure("ply\nformat ascii 1.0\nelement vertex 1").Code, Is.EqualTo(FailureCode.Truncated));

        [Test]
        public void Parse_ControlCharacters_DoNotReachTheMessage()
        {
            string message = Failure("ply\n\x1b[31m\nend_header\n").Message;
            Assert.That(message, Does.Not.Contain("\x1b"));
        }

        [Test]
        public void Parse_TooManyProperties_AreRefused()
        {
            var text = new StringBuilder("ply\nformat ascii 1.0\nelement vertex 1\n");
            for (int i = 0; i <= PlyHeaderParser.MaxDeclarations; i++)
                text.Append("property float p").Append(i).Append('\n');
            Assert.That(Failure(text + "end_header\n").Message, Does.Contain("at most"));
        }
    }
}
