using System;
using System.Collections.Generic;
using FastPoints.Laz;
using NUnit.Framework;

namespace FastPoints.Tests.Laz
{
    /// <summary>Pointwise chunks have no mark of their end, and with chunks of one size only the header says how many points the
    /// last one has. A header that claims too many, or a file that is cut, must not make points: what is given is what was
    /// written, from the start.</summary>
    public class LazPhantomTests
    {
        const int ChunkPoints = 64;

        /// <summary>A decoder takes no byte for less than eight bits of points: so many alike ones may be missing at the end of a
        /// file whose header lies.</summary>
        const int MaxAlikeMissing = 1200;

        static List<byte[]> Records(int pointFormat, int alike, int count, int seed)
        {
            var records = LazRecords.Make(pointFormat, 0, count, seed);
            for (int i = 1; i < count && alike > 0; i++)
            {
                records[i] = (byte[])records[i - 1].Clone();
                if (alike == 1 || alike == 2 && (i * 7 + seed) % 13 == 0)
                    records[i][0]++;
            }
            return records;
        }

        static (byte[] Got, bool IsTold) Read(byte[] bytes)
        {
            using var file = new TemporaryFile(bytes, ".laz");
            using var reader = LazFileReading.Open(file.Path, 1 << 16);
            var got = LazFileReading.Present(reader, LazFileReading.LayoutOf(file.Path));
            return (got, reader.Info.Warnings.Count > 0);
        }

        static int CommonPoints(byte[] got, List<byte[]> records, int recordBytes, string detail)
        {
            Assert.That(got.Length, Is.LessThanOrEqualTo(records.Count * recordBytes), detail + ": points that nobody wrote");
            for (int i = 0; i < got.Length; i++)
                Assert.That(got[i], Is.EqualTo(records[i / recordBytes][i % recordBytes]), detail + ": point " + i / recordBytes);
            return got.Length / recordBytes;
        }

        static List<byte[]> Split(byte[] points, int recordBytes)
        {
            var records = new List<byte[]>();
            for (int at = 0; at < points.Length; at += recordBytes)
                records.Add(points.AsSpan(at, recordBytes).ToArray());
            return records;
        }

        static LazFileWriter Writer(int seed, LazTableLocation table) => new LazFileWriter
        {
            PointFormat = seed % 6,
            ChunkPoints = new[] { ChunkPoints },
            TableLocation = table,
        };

        [TestCase(LazTableLocation.AtOffset), TestCase(LazTableLocation.AtFileEnd), TestCase(LazTableLocation.Missing)]
        public void Read_HeaderClaimsMoreThanTheLastChunkHas_GivesNoPhantomPoints(LazTableLocation table)
        {
            int exact = 0, files = 0, same = 0, maxMissing = 0;
            for (int seed = 0; seed < 240; seed++)
            {
                int count = 1 + seed * 37 % 150, alike = seed / 12 % 4;
                var writer = Writer(seed, table);
                var records = Records(writer.PointFormat, alike, count, seed);
                int room = (ChunkPoints - count % ChunkPoints) % ChunkPoints;
                if (room == 0)
                    continue;
                writer.Claims = count + 1 + seed % room;
                string detail = table + ", seed " + seed;
                var file = writer.Write(records);
                var (got, isReported) = Read(file);
                if (got.Length > count * writer.RecordBytes)
                {
                    // As many as are claimed, and with them the file would be no other: nobody can tell.
                    Assert.That(writer.Write(Split(got, writer.RecordBytes)), Is.EqualTo(file), detail);
                    same++;
                    continue;
                }
                Assert.That(isReported, Is.True, detail);
                int missing = count - CommonPoints(got, records, writer.RecordBytes, detail);
                maxMissing = Math.Max(maxMissing, missing);
                if (alike == 0)
                    Assert.That(missing, Is.EqualTo(0), detail);
                files++;
                exact += missing == 0 ? 1 : 0;
            }
            TestContext.WriteLine(table + ": " + files + " files, " + exact + " exact, at most " + maxMissing
                + " missing; " + same + " that would be no other with the points claimed");
            Assert.That(exact, Is.GreaterThan(files / 2));
        }

        [Test]
        public void Read_OneStreamWhoseHeaderClaimsMore_GivesNoPhantomPoints([Values(0, 1, 2, 3)] int alike)
        {
            for (int seed = 0; seed < 12; seed++)
            {
                var writer = Writer(seed, LazTableLocation.AtOffset);
                writer.ChunkPoints = new int[0];
                var records = Records(writer.PointFormat, alike, 8000 / (1 + seed), seed);
                writer.Claims = 4000000000;
                string detail = "alike " + alike + ", seed " + seed;
                var (got, isReported) = Read(writer.Write(records));
                Assert.That(isReported, Is.True, detail);
                int missing = records.Count - CommonPoints(got, records, writer.RecordBytes, detail);
                TestContext.WriteLine(detail + ": " + missing + " of " + records.Count + " missing");
                Assert.That(missing, Is.LessThanOrEqualTo(alike == 0 ? 0 : MaxAlikeMissing), detail);
            }
        }

        [Test]
        public void Read_TruncatedAnywhere_GivesPointsBeforeAndReportsIt([Values(LazTableLocation.AtOffset,
            LazTableLocation.Missing)] LazTableLocation table)
        {
            for (int seed = 0; seed < 120; seed++)
            {
                var writer = Writer(seed, table);
                var records = Records(writer.PointFormat, seed / 12 % 4, 150, seed);
                var whole = writer.Write(records);
                long first = writer.Chunks[0].Offset + writer.RecordBytes + 4;
                var cut = new byte[first + seed * 31 % (whole.Length - first - 1)];
                Array.Copy(whole, cut, cut.Length);
                string detail = table + ", seed " + seed;
                var (got, isReported) = Read(cut);
                int common = CommonPoints(got, records, writer.RecordBytes, detail);
                Assert.That(isReported || common == records.Count, Is.True, detail);
                foreach (var (offset, bytes) in writer.Chunks)
                    if (offset + bytes <= cut.Length)
                        Assert.That(common, Is.GreaterThanOrEqualTo(Math.Min(records.Count, ChunkPoints)), detail);
            }
        }

        [Test]
        public void Read_ZerosOrTheTableAfterTheLastChunk_AreNotReadAsPoints([Values] bool areZeros)
        {
            for (int seed = 0; seed < 24; seed++)
            {
                var writer = Writer(seed, LazTableLocation.AtOffset);
                var records = Records(writer.PointFormat, 0, 2 * ChunkPoints, seed);
                writer.Claims = 10000;
                var bytes = writer.Write(records);
                long tableAt = writer.Chunks[1].Offset + writer.Chunks[1].Bytes;
                // A table that is where nobody says, or that was never written.
                BitConverter.GetBytes(0L).CopyTo(bytes, writer.Chunks[0].Offset - LazChunkTable.TableOffsetSize);
                if (areZeros)
                {
                    Array.Resize(ref bytes, (int)tableAt);
                    Array.Resize(ref bytes, (int)tableAt + 5000);
                }
                var (got, isReported) = Read(bytes);
                Assert.That(isReported, Is.True, "seed " + seed);
                Assert.That(CommonPoints(got, records, writer.RecordBytes, "seed " + seed),
                    Is.EqualTo(records.Count), "seed " + seed);
            }
        }
    }
}
