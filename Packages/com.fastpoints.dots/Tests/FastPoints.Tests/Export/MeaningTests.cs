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
using FastPoints.Store;
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
            return result.Warnings.Concat(result.Losses.Select(loss => loss.ToString())).ToList();
        }

        LasFile RoundTrip(string source, out List<string> warnings)
        {
            string cloud;
            using (var reader = PointReaders.Open(source))
                cloud = Convert(reader);
            using (var stored = ConvertedReader.Open(cloud))
                warnings = Export(stored);
            using var file = RandomAccessFile.Open(m_folder.File("out.las"));
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
            using var file = RandomAccessFile.Open(m_folder.File("out.las"));
            Assert.That(LasFile.Read(file).Header.GlobalEncoding, Is.EqualTo(1));
        }

        [Test]
        public void GpsTimes_OfTwoKinds_AreOneErrorThatNamesBoth()
        {
            string a = Source("a.las", 2, 1, 1), b = Source("b.las", 4, 6, 0);
            using var tiles = PointReaders.Open(new[] { a, b });
            Assert.That(tiles.Info.Warnings.Any(w => w.Text.Contains("GPS times of two kinds")), Is.True, "to look at, it opens");
            foreach (Action what in new Action[] { () => Convert(tiles), () => Export(tiles), () => Export(tiles, "out.ply") })
                Assert.That(() => what(),
                    Throws.TypeOf<PointCloudException>().With.Message.Contains(a + " has adjusted standard GPS ")
                    .And.Message.Contains(b + " has seconds of the GPS week"));
            Assert.That(File.Exists(m_folder.File("out.las")), Is.False);
        }

        [Test]
        public void GpsTimes_OneFileWithout_TakesTheOthers()
        {
            using var none = PointReaders.Open(Source("a.las", 2, 0, 0));
            using var some = PointReaders.Open(Source("b.las", 2, 1, 1));
            string target = m_folder.File("cloud.fastpoints");
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { none, some }, target, new ConvertSettings(), _ => { }, null));
            using var stored = ConvertedReader.Open(target);
            Assert.That(stored.Info.GpsTime.Kind, Is.EqualTo(GpsTimeKind.AdjustedStandard));
        }

        [Test]
        public void GpsTimes_WithAnOffset_AreKept()
        {
            var las = RoundTrip(Source("a.las", 5, 6, 65, file => file.TimeOffset = 1100), out var warnings);
            Assert.That(((int)las.Header.GlobalEncoding, (int)las.Header.TimeOffset), Is.EqualTo((65, 1100)));
            Assert.That(warnings, Is.Empty);
        }

        [TestCase(1000, ExpectedResult = 1)]
        [TestCase(1100, ExpectedResult = 0)]
        public int GpsTimes_WithAnOffsetAndNoHeaderToKeep_AreStandardOrItsLossIsSaid(int offset)
        {
            string cloud;
            using (var reader = PointReaders.Open(Source("a.las", 5, 6, 65, file => file.TimeOffset = offset)))
                cloud = Convert(reader);
            File.Delete(Path.Combine(cloud, StoreFormat.RecordsName));
            using (var stored = ConvertedReader.Open(cloud))
                Assert.That(Export(stored), offset == 1000 ? Is.Empty
                    : Has.Exactly(1).Contains("GPS time less 1100 million seconds"));
            using var file = RandomAccessFile.Open(m_folder.File("out.las"));
            return LasFile.Read(file).Header.GlobalEncoding;
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
            Assert.That(las.Header.GlobalEncoding, Is.Zero, "as it was");
            Assert.That(warnings, format == 6 && !hasWkt ? Has.Exactly(1).Contains("which point format 6 wants") : Is.Empty);
            Assert.That((las.Info.Crs.Epsg, las.Info.Crs.VerticalEpsg), Is.EqualTo(hasWkt ? (0, 0) : (2229, 6360)));
        }

        [Test]
        public void GeoKeys_LongerThanARecord_FollowThePoints()
        {
            var las = RoundTrip(Source("a.las", 4, 1, 0, file => file.Evlr("LASF_Projection", 34735, s_keys)
                .Evlr("LASF_Projection", 34736, new byte[70_000])), out _);
            Assert.That((Payload(las, 34736).Length, las.Info.Crs.Epsg), Is.EqualTo((70_000, 2229)));
        }

        /// <summary>One description of extra bytes.</summary>
        static byte[] Described(int type, int options, string name, string description, double scale = 0)
        {
            var entry = new byte[192];
            (entry[2], entry[3]) = ((byte)type, (byte)options);
            Encoding.ASCII.GetBytes(name).CopyTo(entry, 4);
            BitConverter.GetBytes(-9999.0).CopyTo(entry, 40);
            BitConverter.GetBytes(scale).CopyTo(entry, 112);
            Encoding.ASCII.GetBytes(description).CopyTo(entry, 160);
            return entry;
        }

        /// <summary>Extra bytes of each kind, two that nothing describes; records of others before and, in LAS 1.4, behind the
        /// points.</summary>
        byte[] Full(int minor, int format, int encoding = 0, string other = "of another")
        {
            using var file = new LasTestFile { Minor = minor, Format = format, GlobalEncoding = encoding, ExtraBytes = 13 };
            file.Vlr("LASF_Spec", 4, Described(0, 3, "blob", "untyped").Concat(Described(23, 0, "vec", "a vector"))
                .Concat(Described(4, 8 | 1, "temp", "degrees", 0.1)).ToArray());
            AddKeys(file);
            file.Vlr("someone", 77, Encoding.ASCII.GetBytes(other)).Vlr("LASF_Spec", 3, new byte[] { 1, 2, 3 });
            if (minor >= 4)
                file.Evlr("someone", 78, new byte[70_000]).Evlr("LASF_Spec", 0, new byte[] { 5 });
            var bytes = file.RandomPoints(300, format).ToBytes();
            bytes[4] = 17;
            for (int i = 0; i < 16; i++)
                bytes[8 + i] = (byte)(i + 1);
            return bytes;
        }

        static List<byte[]> Records(string path, Func<LasVlr, bool> isWanted = null)
        {
            using var file = RandomAccessFile.Open(path);
            return LasFile.Read(file).Vlrs.Records.Where(v => isWanted == null || isWanted(v)).Select(v => file.Read(v.Offset,
                (int)(v.DataOffset + v.DataBytes - v.Offset), "record").Bytes).ToList();
        }

        static List<string> Points(string path)
        {
            using var file = RandomAccessFile.Open(path);
            var header = LasHeader.Read(file);
            var points = new List<string>();
            for (long i = 0; i < (long)header.PointsClaimed; i++)
                points.Add(BitConverter.ToString(file.Read(header.PointsOffset + i * header.RecordBytes, header.RecordBytes,
                    "point").Bytes));
            points.Sort(StringComparer.Ordinal);
            return points;
        }

        /// <summary>Bytes of the header that a file with the same points has again: all but the software's name, where what
        /// begins, that there are waveforms, and counts by return and bounds, which are random here. -0 is 0.</summary>
        static byte[] Header(string path)
        {
            var bytes = File.ReadAllBytes(path);
            Array.Resize(ref bytes, Math.Min(227, (int)BitConverter.ToUInt16(bytes, 94)));
            bytes[LasHeader.At.GlobalEncoding] &= 255 - LasHeader.WaveformBits;
            for (int at = 155; at < 179; at += 8)
                BitConverter.GetBytes(BitConverter.ToDouble(bytes, at) + 0.0).CopyTo(bytes, at);
            return bytes.Where((_, i) => (i < 58 || i >= 90) && (i < 96 || i >= 100) && (i < 111 || i >= 131) &&
                i < 179).ToArray();
        }

        [TestCase(1, 0), TestCase(2, 1), TestCase(2, 3), TestCase(4, 1), TestCase(4, 6), TestCase(4, 7), TestCase(4, 8)]
        [TestCase(5, 6)]
        public void Records_ExportedThroughACloud_AreTheSameBytes(int minor, int format)
        {
            string source = m_folder.Write("a.las", Full(minor, format, minor >= 4 ? 8 + 1 : 1));
            RoundTrip(source, out var losses);
            string output = m_folder.File("out.las");
            Assert.That(Records(output), Is.EqualTo(Records(source)));
            Assert.That(Points(output), Is.EqualTo(Points(source)));
            Assert.That(Header(output), Is.EqualTo(Header(source)));
            Assert.That(losses, format < 6 ? Is.Empty : Has.Exactly(1).Contains("wants"));
        }

        [Test]
        public void RecordsOfTiles_WhereTheyAreEqual_AreKeptAndTheOthersAreNamed()
        {
            string a = m_folder.Write("a.las", Full(2, 3)), b = m_folder.Write("b.las", Full(2, 3, 0, "of yet another"));
            string cloud;
            using (var tiles = PointReaders.Open(new[] { a, b }))
            {
                cloud = Convert(tiles);
                Assert.That(tiles.Info.Losses.Select(l => l.ToString()), Has.Exactly(1).Contains("someone/77: lost"));
                Assert.That(Export(tiles, "tiles.las"), Has.Exactly(1).Contains("someone/77: lost"));
            }
            using (var stored = ConvertedReader.Open(cloud))
                Assert.That(Export(stored), Is.Empty);
            foreach (string output in new[] { "out.las", "tiles.las" })
                Assert.That(Records(m_folder.File(output)), Is.EqualTo(Records(a, v => v.RecordId != 77)));
        }

        [Test]
        public void Waveforms_OfACloud_AreReportedLostOnce()
        {
            using var reader = PointReaders.Open(Source("a.las", 3, 4, 2));
            Convert(reader);
            Assert.That(reader.Info.Losses.Select(l => l.ToString()), Has.Exactly(1).Contains("waveform packets"));
        }

        [Test]
        public void CoordinateSystems_ThatDiffer_AreKeptWithTheirSources()
        {
            string a = Source("a.las", 2, 1, 1, AddKeys), b = Source("b.las", 2, 1, 1, AddWkt);
            using var tiles = PointReaders.Open(new[] { a, b });
            Assert.That(tiles.Info.Warnings.Select(w => w.Text), Has.Exactly(1).Contains("2229").And.Exactly(1).Contains("site"));
            using var stored = ConvertedReader.Open(Convert(tiles));
            var sources = StoredSources.Read(stored.Info.Path);
            Assert.That(sources.Select(s => s.Crs.Epsg), Is.EqualTo(new[] { 2229, 0 }));
            Assert.That(sources[0].Crs.GeoKeys, Is.EqualTo(new[] { s_keys, s_doubles, s_text }));
            Assert.That(sources[1].Crs.Wkt, Is.EqualTo(Wkt));
        }

        const string PlyText = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 1\nproperty float x\nproperty float y\n" +
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n3 0 0 0\n";

        const string PtxText = "1\n2\n1 2 3\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n1 1 1 0.5\n2 2 2 0.5\n";

        const string PcdText = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 2\n" +
            "VIEWPOINT 1 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n";

        [TestCase("a.ply", PlyText, "element face", "comments", "by hand")]
        [TestCase("a.ptx", PtxText, "the scans' grids", "the scans' matrices", "shift 5, 6, 7")]
        [TestCase("a.pcd", PcdText, "the scan's grid", "the viewpoint", "1 0 0 1 0 0 0")]
        public void Export_DataBesidePoints_IsAFactOrANamedLoss(string name, string text, string lost, string told, string fact)
        {
            string cloud;
            using (var reader = PointReaders.Open(m_folder.Write(name, Encoding.ASCII.GetBytes(text))))
            {
                cloud = Convert(reader);
                Assert.That(reader.Info.Losses.Select(l => l.What), Is.EqualTo(new[] { lost }));
            }
            using var stored = ConvertedReader.Open(cloud);
            Assert.That(stored.Info.Facts.Select(f => f.Value), Has.Some.Contains(fact));
            foreach (string output in new[] { "out.las", "out.ply" })
                Assert.That(Export(stored, output), Has.Exactly(1).Contains(told + ": lost"));
        }

        [Test]
        public void Export_HeaderSystemAndTimesToPly_AreNamedLosses()
        {
            using var reader = PointReaders.Open(Source("a.las", 2, 1, 1, AddKeys));
            using var stored = ConvertedReader.Open(Convert(reader));
            foreach (var source in new[] { reader, stored })
                Assert.That(Export(source, "out.ply"), Has.Exactly(1).Contains("header and records of LAS files: lost")
                    .And.Exactly(1).Contains("the definition of the coordinate system: lost").And.Exactly(1).Contains(
                    "the kind of GPS times (adjusted standard GPS time): lost"));
        }

        [Test]
        public void Records_ThatAreDamaged_LoseNoPoint()
        {
            string cloud;
            using (var reader = PointReaders.Open(Source("a.las", 2, 1, 1, AddKeys)))
                cloud = Convert(reader);
            File.WriteAllText(Path.Combine(cloud, StoreFormat.RecordsName), "nothing");
            using var stored = ConvertedReader.Open(cloud);
            Assert.That(Export(stored), Has.Exactly(1).Contains("header and records of LAS files: lost"));
            using var file = RandomAccessFile.Open(m_folder.File("out.las"));
            Assert.That(LasFile.Read(file).Header.PointsClaimed, Is.EqualTo(200));
        }

        /// <summary>Files of PDAL, LAStools, libLAS, rlas and others.</summary>
        [Test]
        public void Samples_ThroughACloud_MatchTheirDirectExport([Values("las", "laz", "copc")] string kind)
        {
            if (TestData.Samples == null)
                Assert.Ignore("no samples: set FASTPOINTS_DATA");
            var problems = new List<string>();
            int compared = 0;
            foreach (string sample in Directory.GetFiles(Path.Combine(TestData.Samples, kind), "*.la?").Where(f =>
                new FileInfo(f).Length < 200_000).OrderBy(f => f, StringComparer.Ordinal))
                try
                {
                    using (var reader = PointReaders.Open(sample))
                        Export(reader, "direct.las");
                    RoundTrip(sample, out _);
                    string direct = m_folder.File("direct.las"), output = m_folder.File("out.las");
                    compared++;
                    foreach (var (what, isSame) in new[]
                    {
                        ("records", Records(direct, v => !v.IsWaveform).SequenceEqual(Records(output), new BytesComparer())),
                        ("points", Points(direct).SequenceEqual(Points(output))),
                        ("header", Header(direct).SequenceEqual(Header(output))),
                    })
                        if (!isSame)
                            problems.Add(Path.GetFileName(sample) + ": " + what);
                }
                catch (PointCloudException e)
                {
                    problems.Add(Path.GetFileName(sample) + ": " + e.Message);
                }
            Assert.That(problems, Is.Empty);
            Assert.That(compared, Is.GreaterThan(1));
        }

        sealed class BytesComparer : IEqualityComparer<byte[]>
        {
            public bool Equals(byte[] a, byte[] b) => a.SequenceEqual(b);
            public int GetHashCode(byte[] bytes) => bytes.Length;
        }

        [Test]
        public void GpsTimes_OfUnknownKind_AreNamedUnknown()
        {
            using var source = new MemoryPointReader(TestBatches.New(5, AttributeType.Float64,
                new PointAttribute(AttributeNames.GpsTime, AttributeType.Float64)), 5);
            Assert.That(Export(source), Has.Exactly(1).Contains("GPS time of unknown kind"));
        }
    }
}
