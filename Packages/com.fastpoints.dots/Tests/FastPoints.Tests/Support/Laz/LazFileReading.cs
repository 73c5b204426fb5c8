using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Tests
{
    /// <summary>Reads LAS and LAZ back into records, through columns: every bit of a record is in one.</summary>
    public static unsafe class LazFileReading
    {
        /// <summary>A file with items as LASzip 1.x wrote them, which nothing writes any more.</summary>
        public static byte[] FirstVersion(string name)
        {
            if (TestData.PackageRoot == null)
                Assert.Ignore("the package's sources are not here");
            return File.ReadAllBytes(TestData.PackageRoot + "/Tests/FastPoints.Tests/Laz/FirstVersion/" + name + ".laz.bytes");
        }

        public static PointReader Open(string path, int longChunkPoints = LazReader.MaxBlockPoints)
        {
            using var source = RandomAccessFile.Open(path);
            var las = LasFile.Read(source);
            var reader = las.Header.IsCompressed ? LazReader.Open(las, source, longChunkPoints) : PointReaders.Open(path);
            ReadPoints.IndexBlocks(reader);
            return reader;
        }

        internal static byte[] Records(PointReader reader, LasRecordLayout layout, int slots = 3)
        {
            var records = new byte[reader.PointCount * layout.RecordBytes];
            long got = Read(reader, layout, ReadPoints.WholeBlocks(reader), reader.Info.Schema, slots, records);
            if (got != reader.PointCount)
                Array.Resize(ref records, (int)got * layout.RecordBytes);
            return records;
        }

        internal static long Read(PointReader reader, LasRecordLayout layout, IReadOnlyList<BlockRange> ranges,
            PointSchema wanted, int slots, byte[] records)
        {
            long points = 0;
            ReadPoints.InTurns(reader, wanted, ranges, slots, read =>
            {
                points += read.Points.Count;
                Pack(read, layout, records, read.FirstPoint);
            });
            return points;
        }

        internal static byte[] Present(PointReader reader, LasRecordLayout layout)
        {
            var records = new byte[reader.PointCount * layout.RecordBytes];
            int done = 0;
            ReadPoints.EachBlock(reader, reader.Info.Schema, read =>
            {
                Pack(read, layout, records, done);
                done += read.Points.Count;
            });
            Array.Resize(ref records, done * layout.RecordBytes);
            return records;
        }

        static void Pack(BlockRead read, LasRecordLayout layout, byte[] records, long firstPoint)
        {
            if (read.Points.Count == 0)
                return;
            var copies = FieldCopyPlan.Make(layout.Fields, read.Points);
            fixed (byte* first = records)
            fixed (FieldCopy* plan = copies)
                PointRecords.FromColumns((byte*)read.Points.Bytes.GetUnsafeReadOnlyPtr(), 0, read.Points.Count,
                    new FieldCopies(plan, copies.Length), first + firstPoint * layout.RecordBytes, layout.RecordBytes);
        }

        internal static LasRecordLayout LayoutOf(string path)
        {
            using var source = RandomAccessFile.Open(path);
            return LasFile.Read(source).Layout;
        }

        /// <summary>The records of an uncompressed LAS file, which may be packed with gzip.</summary>
        public static byte[] Truth(string path)
        {
            var bytes = path.EndsWith(".gz", StringComparison.Ordinal) ? Unzip(path) : File.ReadAllBytes(path);
            int record = RecordFields.UInt16(bytes, LasHeader.At.RecordBytes);
            uint legacy = BitConverter.ToUInt32(bytes, LasHeader.At.LegacyCount);
            bool isLegacy = legacy != 0 || bytes[LasHeader.At.VersionMinor] < 4;
            long count = isLegacy ? legacy : RecordFields.Int64(bytes, LasHeader.At.Count64);
            var records = new byte[count * record];
            Array.Copy(bytes, RecordFields.Int32(bytes, LasHeader.At.PointsOffset), records, 0, records.Length);
            return records;
        }

        static byte[] Unzip(string path)
        {
            using var zip = new GZipStream(File.OpenRead(path), CompressionMode.Decompress);
            var bytes = new MemoryStream();
            zip.CopyTo(bytes);
            return bytes.ToArray();
        }

        /// <returns>Where two runs of records first differ, in words; null if they do not.</returns>
        public static string Difference(byte[] got, byte[] wanted, int recordBytes)
        {
            if (got.Length != wanted.Length)
                return "got " + got.Length / recordBytes + " points, wanted " + wanted.Length / recordBytes;
            for (int i = 0; i < got.Length; i++)
                if (got[i] != wanted[i])
                    return "point " + i / recordBytes + ", byte " + i % recordBytes + ": got " + got[i] + ", wanted " + wanted[i];
            return null;
        }
    }
}
