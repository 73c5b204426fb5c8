using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using FastPoints.Build;
using FastPoints.Export;
using FastPoints.Las;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Las;
using NUnit.Framework;

namespace FastPoints.Tests.Export
{
    /// <summary>What the numbers of a file mean is the same on the other side of a cloud, or its loss is said.</summary>
    public class MeaningTests
    {
        const string Wkt = "LOCAL_CS[\"site\",UNIT[\"metre\",1]]";

        /// <summary>Projected 2229 in US survey feet, heights 6360 with datum 5103 in the same.</summary>
        static readonly byte[] s_keys = Shorts(1, 1, 0, 6, 1024, 0, 1, 1, 3072, 0, 1, 2229, 3073, 34737, 5, 0, 3077, 34736, 1, 0,
            4096, 0, 1, 6360, 4099, 0, 1, 9003);
        static readonly byte[] s_doubles = BitConverter.GetBytes(1200.0 / 3937);
        static readonly byte[] s_text = Encoding.ASCII.GetBytes("feet|\0");

        TemporaryFolder m_folder;

        [SetUp]
        public void MakeFolder() => m_folder = new TemporaryFolder();

        [TearDown]
        public void RemoveFolder() => m_folder.Dispose();

        static byte[] Shorts(params int[] values) => values.SelectMany(v => BitConverter.GetBytes((ushort)v)).ToArray();

        string Source(string name, int minor, int format, int encoding, Action<LasTestFile> more = null)
        {
            using var file = new LasTestFile { Minor = minor, Format = format, GlobalEncoding = encoding };
            more?.Invoke(file);
            return m_folder.Write(name, file.RandomPoints(200, format).ToBytes());
        }

        static void AddKeys(LasTestFile file) => file.Vlr("LASF_Projection", 34735, s_keys)
            .Vlr("LASF_Projection", 34736, s_doubles).Vlr("LASF_Projection", 34737, s_text);

        static void AddWkt(LasTestFile file) => file.Vlr("LASF_Projection", 2112, Encoding.UTF8.GetBytes(Wkt + "\0"));

        string Convert(PointReader reader, string name = "cloud.fastpoints")
        {
            string target = m_folder.File(name);
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, target, new ConvertSettings(), _ => { }, null));
            return target;
        }

        List<string> Export(PointReader reader, string name = "out.las")
        {
            ExportResult result = null;
            JobCoroutine.RunToEnd(ExportCloud.Run(reader, m_folder.File(name), new ExportSettings(), r => result = r, null));
            return result.Warnings.ToList();
        }

        LasFile RoundTrip(string source, out List<string> warnings)
        {
            string cloud;
            using (var reader = PointReaders.Open(source))
                cloud = Convert(reader);
            using (var stored = StoredReader.Open(cloud))
                warnings = Export(stored);
            using var file = FileSource.Open(m_folder.File("out.las"));
            return LasFile.Read(file);
        }

        static byte[] Payload(LasFile las, int record) =>
            las.Vlrs.Find("LASF_Projection", (ushort)record) is LasVlr vlr ? las.Vlrs.Payload(vlr).Bytes : null;

        [TestCase(2, 1, 0), TestCase(2, 3, 1), TestCase(4, 6, 16), TestCase(4, 7, 17)]
        public void GlobalEncoding_ThroughACloud_IsTheSame(int minor, int format, int encoding)
        {
            Action<LasTestFile> more = AddWkt;
            var las = RoundTrip(Source("a.las", minor, format, encoding, encoding < 16 ? null : more), out var warnings);
            Assert.That(las.Header.GlobalEncoding, Is.EqualTo(encoding));
            Assert.That(warnings, Is.Empty);
        }

        [Test]
        public void GlobalEncoding_OfTiles_IsTheSameInOneFile()
        {
            string a = Source("a.las", 2, 1, 1), b = Source("b.las", 2, 1, 1);
            using (var tiles = PointReaders.Open(new[] { a, b }))
                Assert.That(Export(tiles), Is.Empty);
            using var file = FileSource.Open(m_folder.File("out.las"));
            Assert.That(LasFile.Read(file).Header.GlobalEncoding, Is.EqualTo(1));
        }

        [Test]
        public void GpsTimes_OfTwoKinds_AreOneErrorThatNamesBoth()
        {
            string a = Source("a.las", 2, 1, 1), b = Source("b.las", 4, 6, 0);
            using var tiles = PointReaders.Open(new[] { a, b });
            Assert.That(tiles.Info.Warnings.Any(w => w.Text.Contains("GPS times of two kinds")), Is.True, "to look at, it opens");
            foreach (Action what in new Action[] { () => Convert(tiles), () => Export(tiles), () => Export(tiles, "out.ply") })
                Assert.That(what, Throws.TypeOf<PointCloudException>().With.Message.Contains(a + " has adjusted standard GPS ")
                    .And.Message.Contains(b + " has seconds of the GPS week"));
            Assert.That(File.Exists(m_folder.File("out.las")), Is.False);
        }

        [Test]
        public void GpsTimes_WhereOneFileHasNone_AreThoseOfTheOther()
        {
            using var none = PointReaders.Open(Source("a.las", 2, 0, 0));
            using var some = PointReaders.Open(Source("b.las", 2, 1, 1));
            string target = m_folder.File("cloud.fastpoints");
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { none, some }, target, new ConvertSettings(), _ => { }, null));
            using var stored = StoredReader.Open(target);
            Assert.That(stored.Info.GpsTime.Kind, Is.EqualTo(GpsTimeKind.AdjustedStandard));
        }

        [TestCase(1000, ExpectedResult = 1)]
        [TestCase(1100, ExpectedResult = 0)]
        public int GpsTimes_WithAnOffset_AreKeptOrItsLossIsSaid(int offset)
        {
            var las = RoundTrip(Source("a.las", 5, 6, 65, file => file.TimeOffset = offset), out var warnings);
            Assert.That(warnings, offset == 1000 ? Is.Empty : Has.Exactly(1).Contains("GPS time less 1100 million seconds"));
            return las.Header.GlobalEncoding;
        }

        [TestCase(1, false), TestCase(1, true), TestCase(6, false), TestCase(6, true)]
        public void GeoKeys_ThroughACloud_AreTheSameBytes(int format, bool hasWkt)
        {
            Action<LasTestFile> more = AddKeys;
            if (hasWkt)
                more += AddWkt;
            var las = RoundTrip(Source("a.las", format < 6 ? 2 : 4, format, 0, more), out var warnings);
            Assert.That(new[] { 34735, 34736, 34737 }.Select(id => Payload(las, id)),
                Is.EqualTo(new[] { s_keys, s_doubles, s_text }));
            Assert.That(Payload(las, 2112), Is.EqualTo(hasWkt ? Encoding.UTF8.GetBytes(Wkt + "\0") : null), "no text is made up");
            Assert.That(las.Header.GlobalEncoding, Is.EqualTo(format == 6 && hasWkt ? LasHeader.WktBit : 0));
            Assert.That(warnings, format == 6 && !hasWkt ? Has.Exactly(1).Contains("wants the coordinate system") : Is.Empty);
            Assert.That((las.Info.Crs.Epsg, las.Info.Crs.VerticalEpsg), Is.EqualTo(hasWkt ? (0, 0) : (2229, 6360)));
        }

        [Test]
        public void GeoKeys_LongerThanARecord_AreNotKeptAsTheyAre()
        {
            var las = RoundTrip(Source("a.las", 4, 1, 0, file => file.Evlr("LASF_Projection", 34735, s_keys)
                .Evlr("LASF_Projection", 34736, new byte[70_000])), out _);
            Assert.That((Payload(las, 34736), las.Info.Crs.Epsg), Is.EqualTo(((byte[])null, 2229)));
        }

        [Test]
        public void GpsTimes_OfUnknownKind_AreSaidToBe()
        {
            using var source = new MemoryPointReader(TestBatches.New(5, AttributeType.Float64,
                new PointAttribute(AttributeNames.GpsTime, AttributeType.Float64)), 5);
            Assert.That(Export(source), Has.Exactly(1).Contains("GPS time of unknown kind"));
        }
    }
}
