using System;
using System.Linq;
using System.Text;
using FastPoints.Las;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Las
{
    public class LasExtraBytesTests
    {
        static readonly AttributeType[] s_types =
        {
            AttributeType.UInt8, AttributeType.Int8, AttributeType.UInt16, AttributeType.Int16, AttributeType.UInt32,
            AttributeType.Int32, AttributeType.UInt64, AttributeType.Int64, AttributeType.Float32, AttributeType.Float64,
        };

        [Test]
        public void Schema_EachDataType_HasItsComponents([Range(1, 30)] int type)
        {
            var scalar = s_types[(type - 1) % 10];
            int components = 1 + (type - 1) / 10;
            using var file = new LasTestFile { Minor = 4, Format = 6, ExtraBytes = components * scalar.SizeOf() }.RandomPoints(20)
                .Vlr("LASF_Spec", 4, Entry(type, 0, "Thing"));
            file.Save();
            using var reader = PointReaders.Open(file.Path);
            var extra = Extra(reader);
            Assert.That(extra.Select(attribute => attribute.Type), Is.All.EqualTo(scalar));
            Assert.That(extra.Select(attribute => attribute.Name), Is.EqualTo(components == 1 ? new[] { "Thing" }
                : components == 2 ? new[] { "Thing[0]", "Thing[1]" } : new[] { "Thing[0]", "Thing[1]", "Thing[2]" }));
            Assert.That(reader.Info.Warnings, Is.Empty);

            int size = scalar.SizeOf();
            ReadPoints.EachBlock(reader, new PointSchema(extra), read =>
            {
                for (int c = 0; c < components; c++)
                    for (int i = 0; i < 20; i++)
                        for (int b = 0; b < size; b++)
                            Assert.That(read.Points.Bytes[read.Points.Column(c).OffsetBytes + i * size + b],
                                Is.EqualTo(file.Points[i * file.RecordBytes + 30 + c * size + b]));
            });
        }

        [Test]
        public void Schema_ScaleAndOffset_ApplyIfTheOptionsAreSet()
        {
            using var file = new LasTestFile { Minor = 4, Format = 6, ExtraBytes = 6 }.RandomPoints(3)
                .Vlr("LASF_Spec", 4, Entry(3, 8 | 16, "Both", 0.5, 100).Concat(Entry(3, 8, "Scaled", 0.25, 7))
                    .Concat(Entry(4, 0, "Plain", 3, 4)).ToArray());
            file.Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(Extra(reader), Is.EqualTo(new[]
            {
                new PointAttribute("Both", AttributeType.UInt16, 0.5, 100),
                new PointAttribute("Scaled", AttributeType.UInt16, 0.25),
                new PointAttribute("Plain", AttributeType.Int16),
            }));
        }

        [Test]
        public void Schema_ScaleZeroOrNaN_IsOneWithAWarning()
        {
            using var file = new LasTestFile { Minor = 4, Format = 6, ExtraBytes = 2 }.RandomPoints(3)
                .Vlr("LASF_Spec", 4, Entry(1, 8, "Zero", 0).Concat(Entry(1, 16, "None", 1, double.NaN)).ToArray());
            file.Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(Extra(reader).Select(attribute => attribute.Scale), Is.All.EqualTo(1.0));
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(2));
        }

        [Test]
        public void Schema_UndescribedBytes_AreSingleColumns()
        {
            using var file = new LasTestFile { Format = 3, ExtraBytes = 5 }.RandomPoints(3);
            file.Vlr("LASF_Spec", 4, Entry(0, 2, "Opaque")).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(Extra(reader).Select(attribute => attribute.Name), Is.EqualTo(new[]
            {
                "Opaque[0]", "Opaque[1]", "ExtraBytes[0]", "ExtraBytes[1]", "ExtraBytes[2]",
            }));
            Assert.That(ReadPoints.Column<byte>(reader, "ExtraBytes[2]")[1], Is.EqualTo(file.Points[2 * 39 - 1]));
        }

        [Test]
        public void Schema_DuplicateNames_AreNumbered()
        {
            using var file = new LasTestFile { Format = 3, ExtraBytes = 3 }.RandomPoints(3)
                .Vlr("LASF_Spec", 4, Entry(1, 0, "Intensity").Concat(Entry(1, 0, "Twice"))
                    .Concat(Entry(1, 0, "Twice")).ToArray());
            file.Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(Extra(reader).Select(attribute => attribute.Name),
                Is.EqualTo(new[] { "Intensity (2)", "Twice", "Twice (2)" }));
            Assert.That(ReadPoints.Column<byte>(reader, "Twice (2)")[0], Is.EqualTo(file.Points[36]));
        }

        [TestCase(31, 3), TestCase(255, 3), TestCase(10, 3), TestCase(30, 23)]
        public void Schema_InvalidDescription_GivesSingleBytes(int type, int bytes)
        {
            using var file = new LasTestFile { Format = 3, ExtraBytes = bytes }.RandomPoints(3)
                .Vlr("LASF_Spec", 4, Entry(type, 0, "Bad"));
            file.Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(Extra(reader).Length, Is.EqualTo(bytes));
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(1));
        }

        [Test]
        public void Read_LargestRecord_StaysWithinABlocksBytes()
        {
            using var file = new LasTestFile { ExtraBytes = 65535 - 20 }.RandomPoints(100).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.Schema.Count, Is.EqualTo(15 + 65515));
            Assert.That((long)reader.MaxPointsPerBlock * reader.Info.RecordBytes, Is.LessThanOrEqualTo(4 << 20));
            Assert.That(reader.PointCount, Is.EqualTo(100));
            var last = ReadPoints.Column<byte>(reader, "ExtraBytes[65514]");
            Assert.That(last[99], Is.EqualTo(file.Points[file.Points.Length - 1]));
        }

        static PointAttribute[] Extra(PointReader reader)
        {
            int standard = LasPointFormat.Of(reader.Info.PointFormat).Fields.Count;
            return reader.Info.Schema.Skip(standard).ToArray();
        }

        static byte[] Entry(int type, int options, string name, double scale = 0, double offset = 0)
        {
            var entry = new byte[192];
            entry[2] = (byte)type;
            entry[3] = (byte)options;
            Encoding.ASCII.GetBytes(name).CopyTo(entry, 4);
            BitConverter.GetBytes(scale).CopyTo(entry, 112);
            BitConverter.GetBytes(offset).CopyTo(entry, 136);
            return entry;
        }
    }
}
