using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Tests.Laz
{
    [Category("Smoke")]
    public class LazReaderTests
    {
        static IEnumerable<int[]> FormatsAndVersions()
        {
            for (int format = 0; format <= 10; format++)
                for (int version = format < 6 ? 2 : 3; version <= (format < 6 ? 2 : 4); version++)
                    yield return new[] { format, version };
        }

        [TestCaseSource(nameof(FormatsAndVersions))]
        public void Read_EachFormatAndVersion_GivesEveryByte(int[] formatAndVersion)
        {
            var writer = new LazFileWriter
            {
                PointFormat = formatAndVersion[0],
                ItemVersion = formatAndVersion[1],
                ExtraBytes = 3,
                ChunkPoints = new[] { 700 },
            };
            Check(writer, LazRecords.Make(writer.PointFormat, 3, 2000, 11 + formatAndVersion[0]), 0);
        }

        [TestCase(2), TestCase(7)]
        public void Read_ChunksOfAnySize_GivesEveryByte(int format)
        {
            var writer = new LazFileWriter { PointFormat = format, ItemVersion = format < 6 ? 2 : 3, HasVariableChunks = true };
            writer.ChunkPoints = new[] { 1, 1, 2, 7, 300, 1, 511, 512, 513 };
            Check(writer, LazRecords.Make(format, 0, 1500, 3), 0);
        }

        [TestCase(1, LazTableLocation.AtFileEnd), TestCase(8, LazTableLocation.AtFileEnd)]
        [TestCase(3, LazTableLocation.Missing), TestCase(6, LazTableLocation.Missing)]
        public void Read_TableElsewhereOrLost_GivesEveryByte(int format, LazTableLocation location)
        {
            var writer = new LazFileWriter
            {
                PointFormat = format,
                ItemVersion = format < 6 ? 2 : 4,
                ChunkPoints = new[] { 400 },
                TableLocation = location,
            };
            Check(writer, LazRecords.Make(format, 0, 1500, 5), location == LazTableLocation.Missing ? 1 : 0);
        }

        [Test]
        public void Read_VariableLayeredChunksWithoutTable_GivesEveryByte()
        {
            var writer = new LazFileWriter
            {
                PointFormat = 7,
                ItemVersion = 3,
                ChunkPoints = new[] { 100, 3, 700, 1 },
                HasVariableChunks = true,
                TableLocation = LazTableLocation.Missing,
            };
            Check(writer, LazRecords.Make(7, 0, 803, 5), 1);
        }

        [Test]
        public void Open_VariablePointwiseChunksWithoutTable_ReportsIt()
        {
            var writer = new LazFileWriter
            {
                PointFormat = 1,
                ChunkPoints = new[] { 100, 3, 700 },
                HasVariableChunks = true,
                TableLocation = LazTableLocation.Missing,
            };
            using var file = new TemporaryFile(writer.Write(LazRecords.Make(1, 0, 803, 5)), ".laz");
            Assert.That(() => LazFileReading.Open(file.Path),
                Throws.TypeOf<PointCloudException>().With.Property("Code").EqualTo(FailureCode.Truncated));
        }

        [Test]
        public void Read_OneStreamWithoutChunks_GivesEveryByte()
        {
            var writer = new LazFileWriter { PointFormat = 3, ExtraBytes = 2, ChunkPoints = new int[0] };
            Check(writer, LazRecords.Make(3, 2, 2500, 9), 0);
        }

        [TestCase(0), TestCase(1), TestCase(2), TestCase(3), TestCase(4), TestCase(5), TestCase(3, "one-stream")]
        public void Read_FirstVersionOfItems_GivesEveryByte(int format, string name = null) =>
            Check(LazFileReading.FirstVersion(name ?? "format" + format), typeof(LazReader),
                LazRecords.Make(format, 3, 800, 11 + format), 0);

        [TestCase(3, 0), TestCase(3, 5000), TestCase(7, 5000)]
        public void Read_LongChunk_IsSeveralBlocksInAnyOrder(int format, int chunkPoints)
        {
            var records = LazRecords.Make(format, 1, 5000, 21);
            var writer = new LazFileWriter { PointFormat = format, ItemVersion = format < 6 ? 2 : 3, ExtraBytes = 1 };
            writer.ChunkPoints = chunkPoints == 0 ? new int[0] : new[] { chunkPoints };
            using var file = new TemporaryFile(writer.Write(records), ".laz");
            using var reader = LazFileReading.Open(file.Path, 1000);
            Assert.That(reader.BlockCount, Is.GreaterThanOrEqualTo(5));
            Assert.That(reader.MaxPointsPerBlock, Is.LessThanOrEqualTo(1000));
            var ranges = new List<BlockRange>();
            for (int block = reader.BlockCount - 1; block >= 0; block--)
            {
                int half = reader.PointsInBlock(block) / 2;
                ranges.Add(new BlockRange(block, half, reader.PointsInBlock(block) - half));
                ranges.Add(new BlockRange(block, 0, half));
            }
            var got = new byte[5000 * writer.RecordBytes];
            LazFileReading.Read(reader, LazFileReading.LayoutOf(file.Path), ranges, reader.Info.Schema, 3, got);
            Assert.That(LazFileReading.Difference(got, Flat(records), writer.RecordBytes), Is.Null);
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [TestCase(3, 1), TestCase(10, 1), TestCase(3, 97), TestCase(10, 97)]
        public void Read_RangesOfAnyLength_MatchTheWhole(int format, int length)
        {
            int count = length == 1 ? 150 : 1200;
            var records = LazRecords.Make(format, 2, count, 31);
            var writer = new LazFileWriter
            {
                PointFormat = format,
                ItemVersion = format < 6 ? 2 : 4,
                ExtraBytes = 2,
                ChunkPoints = new[] { count / 3 },
            };
            using var file = new TemporaryFile(writer.Write(records), ".laz");
            using var reader = LazFileReading.Open(file.Path);
            var ranges = new List<BlockRange>();
            for (int block = 0; block < reader.BlockCount; block++)
                for (int first = 0; first < reader.PointsInBlock(block); first += length)
                    ranges.Add(new BlockRange(block, first, Math.Min(length, reader.PointsInBlock(block) - first)));
            var got = new byte[count * writer.RecordBytes];
            LazFileReading.Read(reader, LazFileReading.LayoutOf(file.Path), ranges, reader.Info.Schema, 4, got);
            Assert.That(LazFileReading.Difference(got, Flat(records), writer.RecordBytes), Is.Null);
        }

        [TestCase(5), TestCase(10)]
        public void Read_AnySelection_MatchesTheWhole(int format)
        {
            var records = LazRecords.Make(format, 3, 3000, 41);
            var writer = new LazFileWriter
            {
                PointFormat = format,
                ItemVersion = format < 6 ? 2 : 3,
                ExtraBytes = 3,
                ChunkPoints = new[] { 2000 },
            };
            using var file = new TemporaryFile(writer.Write(records), ".laz");
            using var reader = LazFileReading.Open(file.Path);
            var layout = LazFileReading.LayoutOf(file.Path);
            var whole = new BlockRange(0, 0, 2000);
            for (int i = 0; i < reader.Info.Schema.Count; i++)
            {
                // Two attributes at a time, far apart.
                var other = reader.Info.Schema[(i * 7 + 3) % reader.Info.Schema.Count].Name;
                var wanted = reader.Info.Schema.Select(reader.Info.Schema[i].Name, other);
                var got = Flat(records);
                var fields = layout.Fields.Where(field => wanted.Has(field.Name)).ToList();
                foreach (var field in fields)
                    for (int point = 0; point < 2000; point++)
                        for (int b = 0; b < field.Type.SizeOf(); b++)
                            got[point * writer.RecordBytes + field.ByteOffset + b] ^= 255;
                // Other bits of a byte that a bit field shares were flipped as well: flip them back.
                foreach (var field in fields.Where(field => field.IsBits).GroupBy(field => field.ByteOffset))
                {
                    int mask = field.Sum(bits => ((1 << bits.BitWidth) - 1) << bits.BitShift);
                    int flips = field.Count();
                    for (int point = 0; point < 2000; point++)
                    {
                        int at = point * writer.RecordBytes + field.Key;
                        byte now = (byte)(flips % 2 == 1 ? got[at] ^ 255 : got[at]);
                        got[at] = (byte)(now ^ mask);
                    }
                }
                LazFileReading.Read(reader, layout, new[] { whole, new BlockRange(1, 0, 500) }, wanted, 2, got);
                Assert.That(LazFileReading.Difference(got, Flat(records), writer.RecordBytes), Is.Null, wanted.ToString());
            }
        }

        [TestCase(1), TestCase(4)]
        public void Read_AnyNumberOfWorkers_IsTheSame(int workers)
        {
            var writer = new LazFileWriter { PointFormat = 8, ItemVersion = 3, ChunkPoints = new[] { 200 } };
            using (new WorkerCount(workers))
                Check(writer, LazRecords.Make(8, 0, 2000, 51), 0, workers);
        }

        [TestCase(1), TestCase(8)]
        public void Read_CompressorNone_GivesThePlainRecords(int format)
        {
            var writer = new LazFileWriter { PointFormat = format, ItemVersion = format < 6 ? 2 : 3, IsUncompressed = true };
            Check(writer, LazRecords.Make(format, 0, 500, 15), 0);
        }

        [Test]
        public void Read_NoiseInAChunk_IsReportedAndTheOthersAreComplete()
        {
            var records = LazRecords.Make(3, 0, 900, 16);
            var writer = new LazFileWriter { PointFormat = 3, ChunkPoints = new[] { 300 } };
            var bytes = writer.Write(records);
            int middle = (BitConverter.ToInt32(bytes, LasHeader.At.PointsOffset) + bytes.Length) / 2;
            for (int i = 0; i < 20; i++)
                bytes[middle + i] ^= 0x55;
            using var file = new TemporaryFile(bytes, ".laz");
            using var reader = LazFileReading.Open(file.Path);
            var got = new byte[900 * writer.RecordBytes];
            var ranges = new[] { new BlockRange(0, 0, 300), new BlockRange(1, 0, 300), new BlockRange(2, 0, 300) };
            LazFileReading.Read(reader, LazFileReading.LayoutOf(file.Path), ranges, reader.Info.Schema, 3, got);
            var wanted = Flat(records);
            int chunk = 300 * writer.RecordBytes;
            Assert.That(got.Take(chunk), Is.EqualTo(wanted.Take(chunk)));
            Assert.That(got.Skip(2 * chunk), Is.EqualTo(wanted.Skip(2 * chunk)));
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(1));
            Assert.That(reader.Info.Warnings[0].Text, Does.StartWith("chunk 1"));
        }

        [Test]
        public void Open_NoPoints_IsAnEmptyCloud()
        {
            foreach (int format in new[] { 0, 6 })
            {
                var writer = new LazFileWriter { PointFormat = format, ItemVersion = format < 6 ? 2 : 3 };
                using var file = new TemporaryFile(writer.Write(new List<byte[]>()), ".laz");
                using var reader = LazFileReading.Open(file.Path);
                Assert.That(reader.PointCount, Is.EqualTo(0));
                Assert.That(reader.BlockCount, Is.EqualTo(0));
                Assert.That(reader.Info.PointsReadable, Is.EqualTo(0));
            }
        }

        [TestCase(2), TestCase(6)]
        public void Read_TruncatedFile_GivesItsPointsAndReportsIt(int format)
        {
            var records = LazRecords.Make(format, 0, 2000, 61);
            var writer = new LazFileWriter { PointFormat = format, ItemVersion = format < 6 ? 2 : 3 };
            writer.ChunkPoints = new[] { 500 };
            var bytes = writer.Write(records);
            Array.Resize(ref bytes, bytes.Length * 6 / 10);
            using var file = new TemporaryFile(bytes, ".laz");
            using var reader = LazFileReading.Open(file.Path);
            var got = LazFileReading.Records(reader, LazFileReading.LayoutOf(file.Path));
            int count = got.Length / writer.RecordBytes;
            Assert.That(count, Is.InRange(1000, 1400), "whole chunks, and of a pointwise one the points before the cut");
            var wanted = Flat(records);
            Array.Resize(ref wanted, got.Length);
            Assert.That(LazFileReading.Difference(got, wanted, writer.RecordBytes), Is.Null);
            Assert.That(reader.Info.Warnings, Is.Not.Empty);
        }

        [Test]
        public void Read_HeaderClaimsMore_GivesNoPhantomPoints()
        {
            var records = LazRecords.Make(6, 0, 1200, 71);
            var writer = new LazFileWriter { PointFormat = 6, ItemVersion = 3, ChunkPoints = new[] { 500 }, Claims = 1400 };
            using var file = new TemporaryFile(writer.Write(records), ".laz");
            using var reader = LazFileReading.Open(file.Path);
            var got = LazFileReading.Records(reader, LazFileReading.LayoutOf(file.Path));
            Assert.That(LazFileReading.Difference(got, Flat(records), writer.RecordBytes), Is.Null);
            Assert.That(reader.Info.Warnings, Is.Not.Empty);
        }

        [Test]
        public void Read_TruncatedLongChunk_IsNotReadBeyondItsEnd()
        {
            var writer = new LazFileWriter { PointFormat = 6, ItemVersion = 3 };
            var bytes = writer.Write(LazRecords.Make(6, 0, 1000, 5));
            Array.Resize(ref bytes, (int)writer.Chunks[0].Offset + writer.Chunks[0].Bytes / 2);
            using var file = new TemporaryFile(bytes, ".laz");
            using var reader = LazFileReading.Open(file.Path, 100);
            using var read = reader.CreateRead(reader.Info.Schema, 100, Allocator.Persistent);
            Assert.That(reader.BlockCount, Is.EqualTo(10));
            read.Begin(new BlockRange(8, 0, 100));
            read.Complete();
            Assert.That(read.Points.Count, Is.EqualTo(0));
            read.Begin(new BlockRange(9, 0, 100));
            Assert.That(read.Decoded, Is.EqualTo(default(JobHandle)), "each block would cost the chunk from its start");
            read.Complete();
            Assert.That(read.Points.Count, Is.EqualTo(0));
        }

        [Test]
        public void CreateRead_MissingAttribute_IsRefused()
        {
            var writer = new LazFileWriter { PointFormat = 6, ItemVersion = 3 };
            using var file = new TemporaryFile(writer.Write(LazRecords.Make(6, 0, 10, 1)), ".laz");
            using var reader = LazFileReading.Open(file.Path);
            var wanted = new PointSchema(new[] { new PointAttribute(AttributeNames.Red, AttributeType.UInt16) });
            Assert.That(() => reader.CreateRead(wanted, 10, Allocator.Persistent), Throws.ArgumentException);
        }

        static void Check(LazFileWriter writer, List<byte[]> records, int warnings, int slots = 3) =>
            Check(writer.Write(records), writer.IsUncompressed ? typeof(LasReader) : typeof(LazReader), records, warnings, slots);

        static void Check(byte[] bytes, Type type, List<byte[]> records, int warnings, int slots = 3)
        {
            using var file = new TemporaryFile(bytes, ".laz");
            using var reader = LazFileReading.Open(file.Path);
            Assert.That(reader.Info.Format, Is.EqualTo("LAZ"));
            Assert.That(reader, Is.TypeOf(type));
            Assert.That(reader.PointCount, Is.EqualTo(records.Count));
            Assert.That(reader.Info.PointsReadable, Is.EqualTo(records.Count));
            var got = LazFileReading.Records(reader, LazFileReading.LayoutOf(file.Path), slots);
            Assert.That(LazFileReading.Difference(got, Flat(records), records[0].Length), Is.Null);
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(warnings),
                string.Join("\n", reader.Info.Warnings.Select(warning => warning.ToString())));
        }

        static byte[] Flat(List<byte[]> records) => records.SelectMany(record => record).ToArray();
    }
}
