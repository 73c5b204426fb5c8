using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using FastPoints.Sources;
using FastPoints.Tests.Las;
using FastPoints.Tests.Text;

namespace FastPoints.Tests
{
    public sealed class FormatFixture
    {
        public string Format { get; private set; }
        public string Name { get; private set; }

        Action<string> m_write; // Writes an own cloud into a folder; null for a sample.

        string m_main;
        string m_sample; // Below the samples: a file, or an index whose folder is the cloud; null for an own one.
        bool m_isFolder;

        /// <summary>Done to a damaged file now and then, so that the damage gets past a checksum; or null.</summary>
        public Action<byte[]> Seal { get; private set; }

        public string[] Words { get; private set; } // For damage; null for what stands in most texts.

        public bool IsSample => m_sample != null;

        public override string ToString() => Format + "_" + Name;

        static readonly int[] s_minorOfPointFormat = { 0, 1, 2, 2, 3, 3, 4, 4, 4, 5, 5 };

        static readonly string[] s_plyWords =
        {
            "0", "-1", "4", "99999999999999999999", "18446744073709551615", "4294967296", "nan", "list", "vertex", "face",
            "float", "uint64", "char", "ascii", "binary_big_endian", "end_header", "property", "element", "\r", "\n", " ", "",
        };

        static readonly string[] s_e57Words =
        {
            "0", "-1", "1", "64", "255", "9223372036854775807", "-9223372036854775808", "18446744073709551615", "4294967296",
            "nan", "1e308", "Integer", "ScaledInteger", "Float", "String", "Structure", "single", "fileOffset", "recordCount",
            "minimum", "<", ">", "/>", "\"", "&", "]]>", "<a>", "cartesianX", "sphericalRange", "vectorChild", "",
        };

        public static IReadOnlyList<FormatFixture> All { get; } = Enumerable.Range(0, s_minorOfPointFormat.Length)
            .Select(format => Own("LAS", "PointFormat" + format, () => Las(s_minorOfPointFormat[format], format)))
            .Concat(OwnLaz()).Concat(new[]
        {
            Own("COPC", "TwoLevelsAPage", () => new CopcFileWriter { LevelsPerPage = 2, MaxNodePoints = 30 }
                .Write(LazRecords.Make(7, 0, 400, 5))),
            Own("PLY", "Ascii", () => Ply("ascii", false), null, s_plyWords),
            Own("PLY", "AsciiLists", () => Ply("ascii", true), null, s_plyWords),
            Own("PLY", "LittleEndian", () => Ply("binary_little_endian", false), null, s_plyWords),
            Own("PLY", "LittleEndianLists", () => Ply("binary_little_endian", true), null, s_plyWords),
            Own("PLY", "BigEndian", () => Ply("binary_big_endian", false), null, s_plyWords),
            Own("PLY", "BigEndianLists", () => Ply("binary_big_endian", true), null, s_plyWords),
            Own("PCD", "Ascii", () => PcdTestFile.Make("ascii", 40)),
            Own("PCD", "Binary", () => PcdTestFile.Make("binary", 40)),
            Own("PCD", "Compressed", () => PcdTestFile.Make("binary_compressed", 400)),
            Own("PTX", "TwoScans", () => Encoding.ASCII.GetBytes(PtxTestFile.Scan(8, 10) + PtxTestFile.Scan(3, 20, 7))),
            Own("XYZ", "Blanks", () => Text("", ' ')),
            Own("XYZ", "Commas", () => Text("x,y,z,i,r,g,b\n", ',')),
            Own("XYZ", "Semicolons", () => Text("# a scan\n", ';')),
            Own("PTS", "Count", () => Text("200\n", ' ')),
            Own("E57", "Cartesian", () => E57(false), E57FileWriter.Seal, s_e57Words),
            Own("E57", "Spherical", () => E57(true), E57FileWriter.Seal, s_e57Words),
            OwnTree("EPT", "Binary", "ept.json", folder => Ept(folder, EptDataType.Binary)),
            OwnTree("EPT", "Laszip", "ept.json", folder => Ept(folder, EptDataType.Laszip)),
            OwnTree("Potree", "V14", "cloud.js", folder => Potree1(folder, "1.4")),
            OwnTree("Potree", "V17", "cloud.js", folder => Potree1(folder, "1.7")),
            OwnTree("Potree", "V18", "cloud.js", folder => Potree1(folder, "1.8")),
            OwnTree("Potree", "V2Default", "metadata.json", folder => Potree2(folder, false)),
            OwnTree("Potree", "V2Brotli", "metadata.json", folder => Potree2(folder, true)),
            Sample("LAS", "las/extrabytes.las"),
            Sample("LAS", "las/1.0_0.las"),
            Sample("LAS", "las/1_4_w_evlr.las"),
            Sample("LAS", "las/pdrf9-1.5.las"),
            Sample("LAS", "las/interesting.las"),
            Sample("LAS", "broken/bad-geotiff-keys.las"),
            Sample("LAZ", "laz/simple-laszip-compressor-version-1.2r0.laz"),
            Sample("LAZ", "laz/pdrf4-1.3.laz"),
            Sample("LAZ", "laz/pdrf9-1.5.laz"),
            Sample("LAZ", "laz/extra.laz"),
            Sample("COPC", "copc/simple_with_page.copc.laz"),
            Sample("COPC", "copc/example.copc.laz"),
            Sample("PLY", "ply/platonic_shelf_big_endian.ply"),
            Sample("EPT", "ept/bcbf/ept.json", true),
            Sample("EPT", "ept/1.2-with-color/ept.json", true),
            Sample("Potree", "potree/v2-autzen-brotli/metadata.json", true),
            Sample("Potree", "potree/lion_takanawa/cloud.js", true),
            Sample("Potree", "potree/lion_takanawa_laz/cloud.js", true),
            Sample("Potree", "potree/v2-mixedconifer-default/metadata.json", true),
        }).ToArray();

        public string Write(string folder)
        {
            if (m_sample == null)
            {
                m_write(folder);
                return Path.Combine(folder, m_main);
            }
            string from = TestData.SampleOrIgnore(m_sample), root = Path.GetDirectoryName(from);
            Copy(root, m_isFolder ? Directory.GetFiles(root, "*", SearchOption.AllDirectories) : new[] { from }, folder);
            return Path.Combine(folder, Path.GetFileName(from));
        }

        static void Copy(string root, IEnumerable<string> files, string folder)
        {
            foreach (string file in files)
            {
                string to = Path.Combine(folder, file.Substring(root.Length + 1));
                Directory.CreateDirectory(Path.GetDirectoryName(to));
                File.WriteAllBytes(to, File.ReadAllBytes(file));
            }
        }

        static FormatFixture Own(string format, string name, Func<byte[]> make, Action<byte[]> seal = null,
            string[] words = null) => new FormatFixture
            {
                Format = format,
                Name = name,
                m_write = folder => File.WriteAllBytes(Path.Combine(folder, "cloud"), make()),
                m_main = "cloud",
                Seal = seal,
                Words = words,
            };

        static FormatFixture OwnTree(string format, string name, string main, Action<string> write) =>
            new FormatFixture { Format = format, Name = name, m_write = write, m_main = main };

        static FormatFixture Sample(string format, string path, bool isFolder = false) => new FormatFixture
        {
            Format = format,
            Name = path.Replace('/', '_').Replace('.', '_'),
            m_sample = path,
            m_isFolder = isFolder,
        };

        static byte[] Las(int minor, int pointFormat)
        {
            using var file = new LasTestFile { Minor = minor, Format = pointFormat, ExtraBytes = 7, Padding = 2 };
            byte[] keys = LasTestFile.Shorts(1, 1, 0, 3, 3072, 0, 1, 32633, 3073, 34737, 4, 0, 3077, 34736, 1, 0);
            file.Vlr("LASF_Projection", 34735, keys)
                .Vlr("LASF_Projection", 34736, BitConverter.GetBytes(0.3))
                .Vlr("LASF_Projection", 34737, Encoding.ASCII.GetBytes("abc|"));
            var extra = new byte[2 * 192];
            (extra[2], extra[3], extra[4], extra[112]) = (3, 8, (byte)'a', 1);
            (extra[192 + 2], extra[192 + 4]) = (15, (byte)'b');
            file.Vlr("LASF_Spec", 4, extra);
            if (minor >= 4)
                file.Evlr("u", 1, new byte[9])
                    .Evlr("LASF_Projection", 2112, Encoding.ASCII.GetBytes("PROJCS[\"x\",UNIT[\"m\",1],ID[\"EPSG\",1]]"));
            return file.RandomPoints(40, pointFormat).ToBytes();
        }

        static IEnumerable<FormatFixture> OwnLaz()
        {
            foreach (int format in new[] { 0, 1, 3, 5 })
                yield return Own("LAZ", "FirstVersion" + format, () => LazFileReading.FirstVersion("format" + format));
            yield return Own("LAZ", "OneStream", () => LazFileReading.FirstVersion("one-stream"));
            foreach (int format in new[] { 0, 1, 3, 5, 6, 7, 8, 10 })
                for (int kind = 0; kind < 4; kind++)
                {
                    bool isVariable = kind == 3; // Such chunks can't be found without their table.
                    var table = isVariable ? LazTableLocation.AtOffset : (LazTableLocation)kind;
                    yield return Own("LAZ", "PointFormat" + format + (isVariable ? "Variable" : table.ToString()),
                        () => Laz(format, table, isVariable));
                }
        }

        static byte[] Laz(int pointFormat, LazTableLocation table, bool isVariable) => new LazFileWriter
        {
            PointFormat = pointFormat,
            ItemVersion = pointFormat < 6 ? 2 : isVariable ? 4 : 3,
            ExtraBytes = 2,
            HasVariableChunks = isVariable,
            ChunkPoints = new[] { 40 },
            TableLocation = table,
        }.Write(LazRecords.Make(pointFormat, 2, 100, pointFormat));

        static byte[] Ply(string format, bool hasLists)
        {
            var file = PlyTestFile.WithHeader(format, "comment seed", "element face 2", "property list uchar int i",
                "element vertex 6",
                "property float x", "property double y", "property short z", "property uchar red",
                hasLists ? "property list ushort char l" : "property int l", "element edge 1", "property int a");
            bool isBig = format == "binary_big_endian";
            if (format == "ascii")
            {
                file.Text("2 5 6\n0\n");
                for (int i = 0; i < 6; i++)
                    file.Text(i + ".5 " + i + "e-3 " + -i + " 200 " + (hasLists ? "2 1 1\n" : "7\n"));
                return file.Text("5\n").ToArray();
            }
            file.Values(isBig, (byte)2, 5, 6, (byte)0);
            for (int i = 0; i < 6; i++)
            {
                file.Values(isBig, i + 0.5f, i * 1e-3, (short)-i, (byte)200);
                if (hasLists)
                    file.Values(isBig, (ushort)2, (sbyte)1, (sbyte)1);
                else
                    file.Values(isBig, 7);
            }
            return file.Values(isBig, 5).ToArray();
        }

        static byte[] Text(string head, char separator)
        {
            var text = new StringBuilder(head);
            for (int i = 0; i < 200; i++)
                text.Append(string.Join(separator.ToString(), new[] { 500000 + i + ".125", "-" + i + "e-2", i % 7 + ".5",
                    (i * 300).ToString(), (i % 256).ToString(), "0", "255" })).Append(i % 5 == 0 ? "\r\n" : "\n");
            return Encoding.ASCII.GetBytes(text.ToString());
        }

        static void Ept(string folder, EptDataType type)
        {
            var records = LazRecords.Make(0, 0, 300, 3);
            var rest = new[] { ("Rest", "unsigned", 8) };
            using var ept = new EptFolder(type, records,
                type == EptDataType.Binary ? rest : new (string, string, int)[0], 0, 60, 1);
            Copy(ept.Path, Directory.GetFiles(ept.Path, "*", SearchOption.AllDirectories), folder);
        }

        static void Potree1(string folder, string version)
        {
            using var tree = new TemporaryFolder();
            new Potree1Writer { Version = version, StepSize = 1 }.Write(tree, new PotreeTestCloud(60, 2, 4));
            Copy(tree.Path, Directory.GetFiles(tree.Path, "*", SearchOption.AllDirectories), folder);
        }

        static void Potree2(string folder, bool isBrotli)
        {
            using var tree = new TemporaryFolder();
            new Potree2Writer { IsBrotli = isBrotli, StepSize = 1 }.Write(tree, new PotreeTestCloud(60, 2, 5));
            Copy(tree.Path, Directory.GetFiles(tree.Path, "*", SearchOption.AllDirectories), folder);
        }

        static byte[] E57(bool isSpherical)
        {
            double[] reals = Enumerable.Range(0, 900).Select(i => i * 0.25).ToArray();
            long[] longs = Enumerable.Range(0, 900).Select(i => (long)i % 100).ToArray();
            var first = new E57TestScan(
                E57TestField.Scaled("cartesianX", 0, 1000, 0.01, 5, longs),
                E57TestField.Scaled("cartesianY", -7, 100, 0.01, 0, longs),
                E57TestField.Scaled("cartesianZ", 0, 99, 0.01, 0, longs), E57TestField.Integer("colorRed", 0, 255, longs),
                E57TestField.Integer("cartesianInvalidState", 0, 2, longs.Select(v => v == 50 ? 2L : 0).ToArray()))
            {
                Packing = E57Packing.Ragged,
                RecordsPerPacket = 200,
                HasIgnored = true,
                Xml = E57TestScan.Pose(1, 0, 0, 0, 1, 2, 3),
            };
            string[] names = isSpherical ? new[] { "sphericalRange", "sphericalAzimuth", "sphericalElevation" }
                : new[] { "cartesianX", "cartesianY", "cartesianZ" };
            var second = new E57TestScan(E57TestField.Single(names[0], reals), E57TestField.Double(names[1], reals),
                E57TestField.Single(names[2], reals), E57TestField.Integer("returnIndex", 0, 99, longs))
            {
                RecordsPerPacket = 111,
                Xml = E57TestScan.Pose(0.5, 0.5, 0.5, 0.5, 100, 200, 300),
            };
            return new E57FileWriter(first, second).ToArray();
        }
    }
}
