using System;
using System.Linq;
using System.Text;
using FastPoints.Tests.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.E57
{
    public class E57ClaimsTests
    {
        const int Count = 20000;

        static E57TestScan Scan(int count = Count) => new E57TestScan(
            E57TestField.Single("cartesianX", Enumerable.Range(0, count).Select(i => (double)i).ToArray()),
            E57TestField.Single("cartesianY", Enumerable.Range(0, count).Select(i => i * 0.5).ToArray()),
            E57TestField.Single("cartesianZ", new double[count]),
            E57TestField.Integer("intensity", 0, 2000, Enumerable.Range(0, count).Select(i => (long)(i % 2000)).ToArray()));

        static PointCloudException Failure(byte[] file)
        {
            var failure = Assert.Throws<PointCloudException>(() => FileContents.OfE57(file));
            Assert.That(failure.IsInputAtFault, Is.True, failure.Message);
            Assert.That(failure.Message.IndexOf('\n'), Is.EqualTo(-1));
            return failure;
        }

        static void CheckPrefix(FileContents contents, int first, int count)
        {
            Assert.That(contents.Points, Is.EqualTo(count));
            Assert.That(contents.Column<float>("X"), Is.EqualTo(Enumerable.Range(first, count).Select(i => (float)i)));
        }

        static byte[] With(byte[] file, long logical, params byte[] bytes)
        {
            for (int i = 0; i < bytes.Length; i++)
                file[E57FileWriter.Physical(logical + i)] = bytes[i];
            E57FileWriter.Seal(file);
            return file;
        }

        [Test]
        public void Read_DamagedPage_LosesItsPointsOnly()
        {
            byte[] file = new E57FileWriter(Scan()).ToArray();
            // Within the first packet: 80 bytes in front, 14 of header, 4,000 of x, then y.
            file[2 * 1024 + 100] ^= 4;
            var contents = FileContents.OfE57(file);
            int first = (2 * 1020 - 94) / 4, end = (3 * 1020 - 94 + 3) / 4;
            Assert.That(contents.Points, Is.EqualTo(Count - (end - first)));
            Assert.That(contents.Column<float>("X"),
                Is.EqualTo(Enumerable.Range(0, Count).Where(i => i < first || i >= end).Select(i => (float)i)));
            Assert.That(contents.HasWarning("the checksum of page 2 is wrong"));
            Assert.That(contents.HasWarning("(" + (end - first) + " so far)"));
            Assert.That(FileContents.OfE57(file, "Y").Points, Is.EqualTo(Count), "y lies in other pages");
        }

        [Test]
        public void Read_DamagedHeaderChecksum_IsReadWithAWarning()
        {
            byte[] file = new E57FileWriter(Scan()).ToArray();
            file[1023] ^= 1;
            var contents = FileContents.OfE57(file, "Y");
            Assert.That(contents.HasWarning("which holds the section's header"));
            Assert.That(contents.HasWarning("which holds a packet's header"));
            Assert.That(contents.Points, Is.EqualTo(Count));
        }

        [Test]
        public void Open_DamagedXml_FailsAndNamesThePage()
        {
            byte[] file = new E57FileWriter(Scan()).ToArray();
            int page = file.Length / 1024 - 1;
            file[page * 1024 + 5] ^= 1;
            Assert.That(Failure(file).Message, Does.Contain("the checksum of page " + page).And.Contain("XML"));
        }

        [TestCase(1), TestCase(1000), TestCase(2048), TestCase(100000)]
        public void Open_TruncatedFile_FailsWithoutItsXml(int bytes)
        {
            byte[] file = new E57FileWriter(Scan()).ToArray();
            Array.Resize(ref file, file.Length - bytes);
            Assert.That(Failure(file).Code, Is.EqualTo(FailureCode.Truncated));
        }

        [Test]
        public void Open_EveryLengthOfASmallFile_Fails()
        {
            byte[] file = new E57FileWriter(Scan(3)).ToArray();
            for (int length = 1; length < file.Length; length += 61)
                Failure(file.Take(length).ToArray());
        }

        [TestCase(24, 0UL, "offset of the XML section")]
        [TestCase(24, 1021UL, "offset of the XML section")]
        [TestCase(24, ulong.MaxValue, "offset of the XML section")]
        [TestCase(24, 1UL << 40, "offset of the XML section")]
        [TestCase(32, 0UL, "length of the XML section")]
        [TestCase(32, ulong.MaxValue, "length of the XML section")]
        [TestCase(32, 30000000UL, "the XML section")]
        [TestCase(32, 100UL, "the XML section, line")]
        [TestCase(40, 512UL, "page size")]
        public void Open_WrongHeader_FailsAndNamesTheField(int at, ulong value, string field)
        {
            byte[] file = With(new E57FileWriter(Scan(3)).ToArray(), at, BitConverter.GetBytes(value));
            Assert.That(Failure(file).Message, Does.Contain(field));
        }

        [Test]
        public void Read_OtherVersionOrLength_IsAWarning()
        {
            byte[] file = With(With(new E57FileWriter(Scan(3)).ToArray(), 8, 2), 16, 99, 99);
            var contents = FileContents.OfE57(file);
            Assert.That(contents.Points, Is.EqualTo(3));
            Assert.That(contents.HasWarning("major version: wanted 1, got 2"));
            Assert.That(contents.HasWarning("length of the file"));
        }

        [TestCase("20001"), TestCase("4000000000000"), TestCase("18446744073709551615")]
        public void Read_TooManyClaimed_GivesTheExistingPoints(string claimed)
        {
            var scan = Scan();
            scan.RecordCount = claimed;
            var contents = FileContents.OfE57(new E57FileWriter(scan).ToArray());
            // The last byte of the 11-bit stream is full: 20,000 * 11 bits are 27,500 bytes.
            CheckPrefix(contents, 0, Count);
            Assert.That(contents.HasWarning("wanted " + claimed + " points, got 20000"));
            Assert.That(contents.Info.PointsClaimed.ToString(), Is.EqualTo(claimed));
        }

        [Test]
        public void Read_FewerClaimed_GivesTheClaimedPoints()
        {
            var scan = Scan();
            scan.RecordCount = "17";
            CheckPrefix(FileContents.OfE57(new E57FileWriter(scan).ToArray()), 0, 17);
        }

        [TestCase("-1"), TestCase("x"), TestCase("99999999999999999999")]
        public void Open_InvalidRecordCount_Fails(string claimed)
        {
            var scan = Scan(3);
            scan.RecordCount = claimed;
            Assert.That(Failure(new E57FileWriter(scan).ToArray()).Message, Does.Contain("scan 1: recordCount"));
        }

        [TestCase("0"), TestCase("46"), TestCase("1020"), TestCase("9223372036854775808"), TestCase("1048576")]
        [TestCase("1024")]
        public void Read_MisplacedSection_LosesThatScan(string offset)
        {
            var lost = Scan(3000);
            lost.FileOffset = offset;
            var contents = FileContents.OfE57(new E57FileWriter(Scan(50), lost).ToArray());
            CheckPrefix(contents, 0, 50);
            Assert.That(contents.HasWarning("scan 2 is left out"));
            Assert.That(Failure(new E57FileWriter(lost).ToArray()).Message, Does.Contain("scan 1"));
        }

        /// <summary>The third packet's header is at 80 + 2 * 13,392.</summary>
        [TestCase(0, new byte[] { 3 }, "unknown kind")]
        [TestCase(2, new byte[] { 0, 0 }, "length")]
        [TestCase(2, new byte[] { 255, 255 }, "do not fill it")]
        [TestCase(2, new byte[] { 3, 0 }, "length")]
        [TestCase(4, new byte[] { 5 }, "bytestream for each field")]
        [TestCase(4, new byte[] { 0, 0 }, "bytestream for each field")]
        [TestCase(6, new byte[] { 255, 255 }, "longer than it is")]
        public void Read_BrokenPacket_GivesThePointsBefore(int at, byte[] bytes, string detail)
        {
            byte[] file = new E57FileWriter(Scan()).ToArray();
            byte[] content = file.Where((v, i) => i % 1024 < 1020).ToArray();
            int packet = 80;
            for (int i = 0; i < 2; i++)
                packet += BitConverter.ToUInt16(content, packet + 2) + 1;
            var contents = FileContents.OfE57(With(file, packet + at, bytes));
            CheckPrefix(contents, 0, 2000);
            Assert.That(contents.HasWarning(detail), string.Join(" | ", contents.Info.Warnings.Select(w => w.Text)));
        }

        [Test]
        public void Read_RestartWithinAValue_GivesThePointsBefore()
        {
            var scan = Scan();
            scan.RecordsPerPacket = 1001;
            byte[] file = new E57FileWriter(scan).ToArray();
            byte[] content = file.Where((v, i) => i % 1024 < 1020).ToArray();
            int packet = 80 + BitConverter.ToUInt16(content, 82) + 1;
            var contents = FileContents.OfE57(With(file, packet + 1, 1));
            CheckPrefix(contents, 0, 1000);
            Assert.That(contents.HasWarning("restarts its bytestreams within a value"));
        }

        [TestCase(0UL), TestCase(40UL), TestCase(ulong.MaxValue)]
        public void Read_WrongSectionLength_GivesTheExistingPoints(ulong length)
        {
            byte[] file = With(new E57FileWriter(Scan()).ToArray(), 48 + 8, BitConverter.GetBytes(length));
            if (length == ulong.MaxValue)
                Assert.That(FileContents.OfE57(file).HasWarning("the file ends before its binary section"));
            else
                Assert.That(Failure(file).Message, Does.Contain("points: wanted 20000, got 0: scan ").And.Contain("at byte "));
        }

        [TestCase(48, new byte[] { 2 }, "section id")]
        [TestCase(64, new byte[] { 255, 255, 255, 255, 255, 255, 255, 255 }, "first packet")]
        [TestCase(64, new byte[] { 0, 0, 0, 0, 0, 0, 0, 0 }, "first packet")]
        public void Open_WrongSectionHeader_Fails(int at, byte[] bytes, string detail) =>
            Assert.That(Failure(With(new E57FileWriter(Scan()).ToArray(), at, bytes)).Message, Does.Contain(detail));

        [TestCase("<cartesianX type=\"Integer\" minimum=\"5\" maximum=\"4\"/>", "above its maximum")]
        [TestCase("<cartesianX type=\"Integer\" minimum=\"1e3\"/>", "minimum: got")]
        [TestCase("<cartesianX type=\"Integer\" maximum=\"9223372036854775808\"/>", "maximum: got")]
        [TestCase("<cartesianX type=\"ScaledInteger\" minimum=\"0\" maximum=\"9\" scale=\"0\"/>", "its scale is 0")]
        [TestCase("<cartesianX type=\"ScaledInteger\" minimum=\"0\" maximum=\"9\" scale=\"NaN\"/>", "must be finite")]
        [TestCase("<cartesianX type=\"ScaledInteger\" minimum=\"0\" maximum=\"9\" offset=\"Infinity\"/>", "must be finite")]
        [TestCase("<cartesianX type=\"Float\" precision=\"half\"/>", "precision: got")]
        [TestCase("<cartesianX type=\"Blob\"/>", "got \"Blob\"")]
        [TestCase("<cartesianX/>", "type: wanted")]
        [TestCase("<cartesianZ type=\"Float\"/>", "twice")]
        [TestCase("<cartesianX type=\"String\"/>", "neither cartesianX")]
        [TestCase("", "neither cartesianX")]
        public void Open_InvalidPrototype_FailsAndNamesTheField(string element, string detail)
        {
            var scan = Scan(3);
            scan.Fields[0].Xml = element;
            Assert.That(Failure(new E57FileWriter(scan).ToArray()).Message, Does.Contain(detail));
        }

        [Test]
        public void Read_ValueAboveItsMaximum_BecomesTheMaximum()
        {
            var scan = Scan(3);
            scan.Fields[3] = E57TestField.Integer("intensity", -4, 95, -4, 100, 123);
            var contents = FileContents.OfE57(new E57FileWriter(scan).ToArray());
            Assert.That(contents.Column<sbyte>("Intensity"), Is.EqualTo(new sbyte[] { -4, 95, 95 }));
            Assert.That(contents.HasWarning("the maximum was taken (2 so far)"));
        }

        [Test]
        public void Read_ClaimedRecordsWithoutBits_AreLimited()
        {
            var fields = new[] { "cartesianX", "cartesianY", "cartesianZ" }
                .Select(name => E57TestField.Scaled(name, 5, 5, 0.5, 1, 5, 5, 5)).ToArray();
            var few = FileContents.OfE57(new E57FileWriter(new E57TestScan(fields)).ToArray());
            Assert.That(few.Column<int>("Y"), Is.EqualTo(new[] { 5, 5, 5 }));
            var many = new E57TestScan(fields) { RecordCount = "1000000000000000000" };
            var contents = FileContents.OfE57(new E57FileWriter(many).ToArray());
            Assert.That(contents.Points, Is.EqualTo(65536));
            Assert.That(contents.HasWarning("its records take no bytes"));
        }

        [Test]
        public void Read_InvalidPose_IsAWarning()
        {
            var scan = Scan(3);
            scan.Xml = E57TestScan.Pose(0, 0, 0, 0, 0, double.NaN, 0);
            var contents = FileContents.OfE57(new E57FileWriter(scan).ToArray());
            CheckPrefix(contents, 0, 3);
            Assert.That(contents.HasWarning("the pose's rotation is no quaternion"));
        }

        static string Repeated(string text, int times) => new StringBuilder().Insert(0, text, times).ToString();

        [Test]
        public void Open_HostileXml_IsRefusedQuickly()
        {
            string Billion(string xml) => xml.Replace("<e57Root",
                "<!DOCTYPE lolz [<!ENTITY a \"lol\"><!ENTITY b \"&a;&a;&a;&a;\">]>\n<e57Root");
            string External(string xml) => xml.Replace("<e57Root", "<!DOCTYPE x SYSTEM \"file:///etc/passwd\">\n<e57Root");
            string Deep(string xml) => xml.Replace("</e57Root>", Repeated("<a>", 100000));
            string Wide(string xml) => xml.Replace("</e57Root>", Repeated("<a/>", 1100000) + "</e57Root>");
            string Attributes(string xml) => xml.Replace("<data3D", "<data3D" +
                string.Concat(Enumerable.Range(0, 200000).Select(i => " a" + i + "=\"\"")));
            string Tag(int tag) => "<b" + string.Concat(Enumerable.Range(tag * 600, 600).Select(i => " a" + i + "=\"\"")) + "/>";
            string ManyAttributes(string xml) =>
                xml.Replace("</e57Root>", string.Concat(Enumerable.Range(0, 2000).Select(Tag)) + "</e57Root>");
            string LongText(string xml) =>
                xml.Replace("</e57Root>", "<a><![CDATA[" + Repeated("<text ", 300000) + "]]></a></e57Root>");
            string Open(string xml) => xml.Replace("</e57Root>", "");
            string Entity(string xml) => xml.Replace("</e57Root>", "<a>&b;</a></e57Root>");
            string Other(string xml) => "<html/>";
            string Nothing(string xml) => " ";
            string Binary(string xml) => "\u0001\u0002<";
            foreach (var edit in new Func<string, string>[]
            {
                Billion, External, Deep, Wide, Attributes, ManyAttributes, LongText, Open, Entity, Other, Nothing, Binary,
            })
            {
                byte[] file = new E57FileWriter(Scan(3)) { EditXml = edit }.ToArray();
                var watch = System.Diagnostics.Stopwatch.StartNew();
                Assert.Throws<PointCloudException>(() => FileContents.OfE57(file), edit.Method.Name);
                Assert.That(watch.Elapsed.TotalSeconds, Is.LessThan(10), edit.Method.Name);
            }
        }

        [Test]
        public void Read_UndeclaredPrefix_IsRead()
        {
            var scan = Scan(3);
            scan.Fields.Add(E57TestField.Integer("own:thing", 0, 7, 1, 2, 7));
            var contents = FileContents.OfE57(new E57FileWriter(scan).ToArray());
            Assert.That(contents.Column<byte>("own:thing"), Is.EqualTo(new byte[] { 1, 2, 7 }));
        }
    }
}
