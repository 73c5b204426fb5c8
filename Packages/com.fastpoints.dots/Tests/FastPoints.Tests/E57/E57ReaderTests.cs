using System;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;
using static FastPoints.Tests.E57.E57TestScans;

namespace FastPoints.Tests.E57
{
    [Category("Smoke")]
    public class E57ReaderTests
    {
        [Test]
        public void Read_ScaledIntegers_GivesThemExactlyInAnyPacking([Values] E57Packing packing,
            [Values(10, 1000, 7777)] int piece)
        {
            const int Count = 70001;
            var scan = Grid(Count, 0.001, 5000.5);
            scan.Fields.Add(E57TestField.Integer("flag", 0, 1, RandomLongs(Count, 0, 1, 9)));
            scan.Packing = packing;
            scan.RecordsPerPacket = packing == E57Packing.OneByOne ? piece * 4 : piece;
            scan.HasIgnored = true;
            var contents = FileContents.OfE57(File(scan));

            Assert.That(contents.Points, Is.EqualTo(Count));
            Assert.That(contents.Blocks, Is.EqualTo(3));
            Assert.That(contents.Info.Warnings, Is.Empty);
            Assert.That(contents.Column<int>("X"), Is.EqualTo(scan.Fields[0].Integers.Select(v => (int)v)));
            Assert.That(contents.Column<int>("Y"), Is.EqualTo(scan.Fields[1].Integers.Select(v => (int)v)));
            Assert.That(contents.Column<int>("Z"), Is.All.EqualTo(7));
            Assert.That(contents.Column<byte>("flag"), Is.EqualTo(scan.Fields[3].Integers.Select(v => (byte)v)));
            Assert.That(contents.Info.Transform.Scale.x, Is.EqualTo(0.001));
            Assert.That(contents.Info.Transform.Offset.z, Is.EqualTo(5000.5));
        }

        [Test]
        public void Read_IntegersOfEveryWidth_RoundTrip()
        {
            const int Count = 300;
            var scan = Floats(Count);
            for (int bits = 1; bits <= 64; bits++)
            {
                long maximum = bits == 64 ? long.MaxValue : bits == 63 ? long.MaxValue - 5 : (1L << bits) - 6;
                long minimum = bits == 64 ? long.MinValue : bits < 4 ? maximum - (1L << bits) + 1 : -5;
                scan.Fields.Add(E57TestField.Integer("w" + bits, minimum, maximum, RandomLongs(Count, minimum, maximum, bits)));
            }
            scan.RecordsPerPacket = 37;
            var contents = FileContents.OfE57(File(scan));
            for (int bits = 1; bits <= 64; bits++)
            {
                var field = scan.Fields[2 + bits];
                Assert.That(field.Bits, Is.EqualTo(bits));
                Assert.That(Integers(contents, field.Name), Is.EqualTo(field.Integers), field.Name);
            }
        }

        [Test]
        public void Read_Floats_GivesTheirBits()
        {
            var scan = Floats(5000);
            scan.Fields[0].Reals[17] = double.NaN;
            scan.Fields[0].Reals[18] = double.PositiveInfinity;
            scan.Fields.Add(E57TestField.Double("ext:quality", Reals(5000, 0.1, 1e-9)));
            var contents = FileContents.OfE57(File(scan));
            Assert.That(contents.Column<float>("X"), Is.EqualTo(scan.Fields[0].Reals.Select(v => (float)v)));
            Assert.That(contents.Column<double>("ext:quality"), Is.EqualTo(scan.Fields[3].Reals));
            Assert.That(contents.HasFact("floats, as stored"));
        }

        [Test]
        public void Read_SubsetOrRange_MatchesTheWhole()
        {
            const int Count = 100000;
            var scan = Grid(Count);
            scan.Fields.Add(E57TestField.Integer("colorRed", 0, 255, RandomLongs(Count, 0, 255, 5)));
            scan.Fields.Add(E57TestField.Single("intensity", Reals(Count, 0, 0.5)));
            scan.RecordsPerPacket = 3001;
            byte[] file = File(scan);
            var whole = FileContents.OfE57(file);
            foreach (string name in new[] { "X", "Red", "Intensity" })
                Assert.That(FileContents.OfE57(file, name).Bytes(name), Is.EqualTo(whole.Bytes(name)));

            int[] x = whole.Column<int>("X");
            var random = new Random(4);
            using var path = new TemporaryFile(file, ".e57");
            using var reader = PointReaders.Open(path.Path);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            using var read = reader.CreateRead(reader.Info.Schema.Select("X", "Red"), 5000, Allocator.Persistent);
            for (int i = 0; i < 40; i++)
            {
                int block = random.Next(reader.BlockCount);
                int first = random.Next(reader.PointsInBlock(block));
                int count = Math.Min(random.Next(5000), reader.PointsInBlock(block) - first);
                read.Begin(new BlockRange(block, first, count));
                read.Complete();
                Assert.That(read.Points.Count, Is.EqualTo(count));
                Assert.That(read.Points.Column<int>("X").GetSubArray(0, count).ToArray(),
                    Is.EqualTo(x.Skip((int)read.FirstPoint).Take(count)));
            }
        }

        [Test]
        public void Read_ManyBlocksAtOnce_GivesTheSame()
        {
            byte[] file = File(Grid(200000), Grid(50000, seed: 40));
            var whole = FileContents.OfE57(file);
            using var path = new TemporaryFile(file, ".e57");
            using var reader = PointReaders.Open(path.Path);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            int[] x = whole.Column<int>("X");
            var reads = new BlockRead[reader.BlockCount];
            for (int i = 0; i < reads.Length; i++)
            {
                reads[i] = reader.CreateRead(reader.Info.Schema, reader.MaxPointsPerBlock, Allocator.Persistent);
                reads[i].Begin(new BlockRange(i, 0, reader.PointsInBlock(i)));
            }
            for (int i = reads.Length - 1; i >= 0; i--)
            {
                reads[i].Complete();
                Assert.That(reads[i].Points.Column<int>("X").GetSubArray(0, reads[i].Points.Count).ToArray(),
                    Is.EqualTo(x.Skip((int)reads[i].FirstPoint).Take(reads[i].Points.Count)));
                reads[i].Dispose();
            }
        }

        [Test]
        public void Read_PosedScan_IsTransformedInDouble()
        {
            // A quarter turn about z: x becomes y, y becomes -x.
            double h = Math.Sqrt(0.5);
            var scan = Floats(100);
            scan.Xml = E57TestScan.Pose(h, 0, 0, h, 500000, 5000000, 100);
            scan.Fields.Add(E57TestField.Single("nor:normalX", Reals(100, 1, 0)));
            scan.Fields.Add(E57TestField.Single("nor:normalY", Reals(100, 0, 0)));
            scan.Fields.Add(E57TestField.Single("nor:normalZ", Reals(100, 0, 0)));
            var contents = FileContents.OfE57(File(scan));
            double[] x = contents.Column<double>("X"), y = contents.Column<double>("Y"), z = contents.Column<double>("Z");
            for (int i = 0; i < 100; i++)
            {
                Assert.That(x[i], Is.EqualTo(500000 - scan.Fields[1].Reals[i]).Within(1e-8));
                Assert.That(y[i], Is.EqualTo(5000000 + scan.Fields[0].Reals[i]).Within(1e-8));
                Assert.That(z[i], Is.EqualTo(100 + scan.Fields[2].Reals[i]).Within(1e-12));
            }
            Assert.That(contents.Column<float>("NormalX"), Is.All.EqualTo(0).Within(1e-6));
            Assert.That(contents.Column<float>("NormalY"), Is.All.EqualTo(1).Within(1e-6));
            Assert.That(FileContents.OfE57(File(scan), "NormalY").Column<float>("NormalY"), Is.All.EqualTo(1).Within(1e-6));
            Assert.That(FileContents.OfE57(File(scan), "Z").Column<double>("Z"), Is.EqualTo(z));
        }

        [Test]
        public void Read_FieldsOfLas_HaveTheirUsualNames()
        {
            var scan = Floats(100);
            scan.Fields.Add(E57TestField.Integer("las:pointSourceId", 0, 7, Enumerable.Repeat(7L, 100).ToArray()));
            scan.Fields.Add(E57TestField.Integer("classification", 0, 31, Enumerable.Repeat(2L, 100).ToArray()));
            Assert.That(FileContents.OfE57(File(scan)).Info.Schema.Select(a => a.Name), Is.EqualTo(new[]
                { "X", "Y", "Z", "PointSourceId", "Classification" }));
        }

        [Test]
        public void Read_SphericalScan_BecomesCartesian()
        {
            var scan = new E57TestScan(
                E57TestField.Double("sphericalRange", 2, 2, 3, 10),
                E57TestField.Double("sphericalAzimuth", 0, Math.PI / 2, 0, 0.5),
                E57TestField.Scaled("sphericalElevation", -10, 10, Math.PI / 20, 0, 0, 0, 10, 2),
                E57TestField.Integer("sphericalInvalidState", 0, 2, 0, 0, 0, 2));
            var contents = FileContents.OfE57(File(scan));
            Assert.That(contents.Points, Is.EqualTo(3));
            Assert.That(contents.Column<double>("X"), Is.EqualTo(new[] { 2, 0, 0.0 }).Within(1e-12));
            Assert.That(contents.Column<double>("Y"), Is.EqualTo(new[] { 0, 2, 0.0 }).Within(1e-12));
            Assert.That(contents.Column<double>("Z"), Is.EqualTo(new[] { 0, 0, 3.0 }).Within(1e-12));
            Assert.That(contents.HasWarning("marks as invalid are left out (1 so far)"));
            Assert.That(contents.Info.Schema.Has("sphericalRange"), Is.False);
        }

        [Test]
        public void Read_SphericalBesideCartesian_IsKept()
        {
            var scan = Floats(3);
            scan.Fields.Add(E57TestField.Double("sphericalRange", 1, 2, 3));
            var contents = FileContents.OfE57(File(scan));
            Assert.That(contents.Column<double>("sphericalRange"), Is.EqualTo(new[] { 1.0, 2, 3 }));
        }

        [Test]
        public void Read_InvalidPoints_AreSkippedAndCounted()
        {
            const int Count = 50000;
            var scan = Grid(Count);
            long[] states = Longs(Count, i => i % 5 == 3 ? i % 2 + 1 : 0);
            scan.Fields.Insert(0, E57TestField.Integer("cartesianInvalidState", 0, 2, states));
            scan.Fields.Add(E57TestField.Double("timeStamp", Reals(Count, 0, 1)));
            var contents = FileContents.OfE57(File(scan));
            Assert.That(contents.Points, Is.EqualTo(Count - Count / 5));
            Assert.That(contents.PointsInBlocks, Is.EqualTo(Count));
            Assert.That(contents.HasWarning("(" + Count / 5 + " so far)"));
            Assert.That(contents.Info.PointsMarkedInvalid, Is.EqualTo(Count / 5), "each once, however it is read");
            Assert.That(contents.Column<double>("timeStamp"), Is.EqualTo(Reals(Count, 0, 1).Where((v, i) => i % 5 != 3)));
            Assert.That(contents.Column<int>("X"),
                Is.EqualTo(scan.Fields[1].Integers.Where((v, i) => i % 5 != 3).Select(v => (int)v)));
        }

        [Test]
        public void Read_TooManyFields_SkipsSome()
        {
            var scans = Enumerable.Range(0, 4).Select(s => Floats(2)).ToArray();
            for (int i = 0; i < 400; i++)
                scans[i / 100].Fields.Add(E57TestField.Integer("f" + i, 0, 9, i % 10, 1));
            var contents = FileContents.OfE57(File(scans));
            Assert.That(contents.Info.Schema.Count, Is.EqualTo(3 + 250 + 1));
            Assert.That(contents.HasWarning("150 fields are left out"));
            Assert.That(contents.Info.Schema.Has("f249"));
        }

        [Test]
        public void Read_RangeBeyondInt32_IsShiftedAndStillExact()
        {
            long high = 3_000_000_000;
            var scan = Grid(4);
            scan.Fields[0] = E57TestField.Scaled("cartesianX", high, high + 100, 0.01, 0, high, high + 1, high + 99, high + 100);
            var contents = FileContents.OfE57(File(scan));
            int[] x = contents.Column<int>("X");
            Assert.That(x.Select(v => v - x[0]), Is.EqualTo(new[] { 0, 1, 99, 100 }));
            Assert.That(x[0] * contents.Info.Transform.Scale.x + contents.Info.Transform.Offset.x, Is.EqualTo(3e7).Within(1e-8));
        }

        [Test]
        public void Read_RangeOf64Bits_IsExact()
        {
            long[] values = { long.MinValue, -1, 0, 123456789012345678, long.MaxValue };
            var scan = Floats(5);
            scan.Fields[0] = E57TestField.Scaled("cartesianX", 0, 0, 1e-4, -3, values);
            scan.Fields[0].HasLimits = false;
            scan.Fields[1] = E57TestField.Scaled("cartesianY", -5000000000, 5000000000, 1e-4, 0,
                -5000000000, 1, 2, 3, 5000000000);
            scan.Fields[2] = E57TestField.Integer("cartesianZ", 0, 3, 0, 1, 2, 3, 3);
            var contents = FileContents.OfE57(File(scan));
            Assert.That(contents.Column<long>("X"), Is.EqualTo(values));
            Assert.That(contents.Column<long>("Y"), Is.EqualTo(scan.Fields[1].Integers));
            Assert.That(contents.Column<int>("Z"), Is.EqualTo(new[] { 0, 1, 2, 3, 3 }));
            Assert.That(contents.Info.Transform.Offset.x, Is.EqualTo(-3));
        }

        [Test]
        public void Read_ReturnIndex_CountsFromOne()
        {
            var scan = Floats(3);
            scan.Fields.Add(E57TestField.Integer("returnIndex", 0, 2, 0, 1, 2));
            scan.Fields.Add(E57TestField.Integer("returnCount", 1, 3, 3, 3, 3));
            var contents = FileContents.OfE57(File(scan));
            Assert.That(contents.Column<byte>("ReturnNumber"), Is.EqualTo(new byte[] { 1, 2, 3 }));
            Assert.That(contents.Column<byte>("NumberOfReturns"), Is.EqualTo(new byte[] { 3, 3, 3 }));
        }

        static E57TestScan Colored(string limits, params E57TestField[] colors)
        {
            var scan = Floats(3);
            scan.Xml = limits;
            scan.Fields.AddRange(colors);
            return scan;
        }

        static E57TestField[] IntegerColors(long maximum, params long[] values) => new[]
        {
            E57TestField.Integer("colorRed", 0, maximum, values), E57TestField.Integer("colorGreen", 0, maximum, values),
            E57TestField.Integer("colorBlue", 0, maximum, values),
        };

        static string ColorLimits(double min, double max)
        {
            string xml = "<colorLimits type=\"Structure\">";
            foreach (string color in new[] { "Red", "Green", "Blue" })
                xml += "<color" + color + "Minimum type=\"Float\">" + min + "</color" + color + "Minimum><color" + color +
                    "Maximum type=\"Float\">" + max + "</color" + color + "Maximum>";
            return xml + "</colorLimits>";
        }

        [Test]
        public void Read_BytesAsColors_AreBytes([Values("", "0 255", "17 203")] string limits)
        {
            string xml = limits == "" ? "" : ColorLimits(double.Parse(limits.Split(' ')[0]), double.Parse(limits.Split(' ')[1]));
            var contents = FileContents.OfE57(File(Colored(xml, IntegerColors(255, 17, 100, 203))));
            Assert.That(contents.Column<byte>("Red"), Is.EqualTo(new byte[] { 17, 100, 203 }));
        }

        [Test]
        public void Read_TwelveBitColors_AreScaledTo16()
        {
            var contents = FileContents.OfE57(File(Colored("", IntegerColors(4095, 0, 2048, 4095))));
            Assert.That(contents.Column<ushort>("Red"), Is.EqualTo(new ushort[] { 0, 32776, 65535 }));
            Assert.That(contents.HasFact("scaled to 0 to 65,535"));
        }

        [Test]
        public void Read_FloatColors_AreNormalizedOrScaled()
        {
            E57TestField[] Of(params double[] values) => new[]
            {
                E57TestField.Single("colorRed", values), E57TestField.Single("colorGreen", values),
                E57TestField.Single("colorBlue", values),
            };
            var shares = FileContents.OfE57(File(Colored(ColorLimits(0, 1), Of(0, 0.5, 1))));
            Assert.That(shares.Column<float>("Red"), Is.EqualTo(new[] { 0, 0.5f, 1 }));
            var bytes = FileContents.OfE57(File(Colored(ColorLimits(0, 255), Of(0, double.NaN, 255))));
            Assert.That(bytes.Column<ushort>("Blue"), Is.EqualTo(new ushort[] { 0, 0, 65535 }));
        }

        [Test]
        public void Read_Strings_AreSkippedWithAWarning()
        {
            var scan = Floats(40);
            scan.Fields.Insert(1, new E57TestField { Name = "label", Type = "String", Integers = new long[40] });
            var contents = FileContents.OfE57(File(scan));
            Assert.That(contents.Column<float>("Z"), Is.EqualTo(scan.Fields[3].Reals.Select(v => (float)v)));
            Assert.That(contents.HasFact("label: String (left out)"));
        }

        [Test]
        public void Read_FieldNamedLikeAnAttribute_IsSkippedWithAWarning()
        {
            var scan = Floats(2);
            scan.Fields.Add(E57TestField.Integer("X", 0, 9, 1, 2));
            scan.Fields.Add(E57TestField.Integer("intensity", 0, 9, 1, 2));
            scan.Fields.Add(E57TestField.Integer("Intensity", 0, 9, 3, 4));
            var contents = FileContents.OfE57(File(scan));
            Assert.That(contents.Column<byte>("Intensity"), Is.EqualTo(new byte[] { 1, 2 }));
            Assert.That(contents.HasWarning("field Intensity is left out"));
            Assert.That(contents.HasWarning("field X is left out"));
        }

        [Test]
        public void Read_RestartAtTheStart_ChangesNothing()
        {
            var scan = Grid(5000);
            scan.HasRestartFlag = true;
            Assert.That(FileContents.OfE57(File(scan)).Points, Is.EqualTo(5000));
        }

        [Test]
        public void Open_NoPoints_IsAnEmptyCloud()
        {
            var empty = Floats(0);
            empty.FileOffset = "0";
            Assert.That(FileContents.OfE57(File(empty)).Points, Is.EqualTo(0));
            Assert.That(FileContents.OfE57(File()).Points, Is.EqualTo(0));
        }

        [Test]
        public void Info_ReportsScansPosesSensorsAndImages()
        {
            var scan = Floats(7);
            scan.Xml = "<name type=\"String\">hall &amp; yard</name><sensorVendor type=\"String\">Maker</sensorVendor>" +
                "<acquisitionStart type=\"Structure\"><dateTimeValue type=\"Float\">1000000000.5</dateTimeValue>" +
                "</acquisitionStart>" + E57TestScan.Pose(1, 0, 0, 0, 10, 20, 30) +
                "<cartesianBounds type=\"Structure\"><xMinimum type=\"Float\">0</xMinimum>" +
                "<xMaximum type=\"Float\">1.5</xMaximum><yMinimum type=\"Float\">-3</yMinimum>" +
                "<yMaximum type=\"Float\">0</yMaximum>" +
                "<zMinimum type=\"Float\">0.25</zMinimum><zMaximum type=\"Float\">1</zMaximum></cartesianBounds>";
            var writer = new E57FileWriter(scan)
            {
                RootXml = "<coordinateMetadata type=\"String\"><![CDATA[PROJCS[\"here\",UNIT[\"metre\",1]," +
                    "AUTHORITY[\"EPSG\",\"25832\"]]]]></coordinateMetadata><images2D type=\"Vector\">" +
                    "<vectorChild type=\"Structure\"><name type=\"String\">panorama</name></vectorChild></images2D>",
            };
            var contents = FileContents.OfE57(writer.ToArray());
            foreach (string part in new[]
            {
                "scan 1: hall & yard, 7 points", "sensorVendor: Maker", "acquisitionStart: 2011-09-14 01:46:40 GPS time",
                "pose: translation 10, 20, 30", "images (left out): 1", "image 1: panorama", "field: cartesianX: Float single",
            })
                Assert.That(contents.HasFact(part), part + " in " + string.Join(" | ", contents.Info.Facts));
            Assert.That(contents.Info.Crs.Epsg, Is.EqualTo(25832));
            Assert.That(contents.Info.HasBoundsClaimed);
            Assert.That(contents.Info.BoundsClaimed.Max.x, Is.EqualTo(11.5));
            Assert.That(contents.Info.PointsClaimed, Is.EqualTo(7));
        }

        /// <summary>PDAL's file, by CloudCompare and libE57Format; the points are those that PDAL's tests expect.</summary>
        [Test]
        public void Read_FileByLibE57Format_HasItsPoints()
        {
            var contents = FileContents.OfE57(TestData.SampleOrIgnore("broken/A4.e57"));
            Assert.That(contents.Column<float>("X"),
                Is.EqualTo(new[] { -44.300098f, -44.506901f, -44.4487f, -44.9522f }).Within(1e-5));
            Assert.That(contents.Column<float>("Y").Take(2), Is.EqualTo(new[] { -1.1321f, -0.886f }).Within(1e-6));
            Assert.That(contents.Column<float>("Z").Take(2), Is.EqualTo(new[] { 0.3358f, 0.3286f }).Within(1e-6));
            Assert.That(contents.Column<byte>("Green"), Is.All.EqualTo(255));
            Assert.That(contents.Column<byte>("Red"), Is.All.EqualTo(0));
            Assert.That(contents.Info.Warnings, Is.Empty);
        }
    }
}
