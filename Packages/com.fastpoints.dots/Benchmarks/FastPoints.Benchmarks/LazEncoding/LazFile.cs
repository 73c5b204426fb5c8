using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using FastPoints.Base;
using FastPoints.Files;

namespace FastPoints.LazEncoding
{
    /// <summary>A LAZ file from a LAS file: chunks of 50,000 points, pointwise (items of version 2) for point formats 0 to 5,
    /// layered (version 3) above; every header field and VLR as it is. For demonstration clouds and tests: correct, not
    /// quick.</summary>
    public static class LazFile
    {
        public const int ChunkPoints = 50000;

        const int OffsetAt = 96, VlrCountAt = 100, PointFormatAt = 104, EvlrAt = 235;
        const byte CompressedBit = 0x80;

        /// <param name="lasPath">A sound LAS file without compression and waveforms.</param>
        /// <param name="laz">Gets the file; can seek.</param>
        /// <exception cref="PointCloudException">The source is none.</exception>
        public static void Write(string lasPath, Stream laz, StageProgress progress, CancellationToken cancellation)
        {
            long points;
            int recordBytes, pointFormat;
            using (var reader = PointReaders.Open(lasPath))
            {
                var las = reader as LasReader ?? throw new PointCloudException(FailureCode.Unsupported, lasPath, -1,
                    "wanted a LAS file without compression, got " + reader.Info.Format);
                points = reader.PointCount;
                recordBytes = reader.Info.RecordBytes;
                pointFormat = reader.Info.PointFormat;
            }
            var items = LazItems.Of(pointFormat, pointFormat < 6 ? 2 : 3,
                recordBytes - LasPointFormat.Of(pointFormat).RecordBytes);
            var vlr = LazItems.Vlr(items, pointFormat < 6 ? LazCompressor.PointwiseChunked : LazCompressor.LayeredChunked,
                ChunkPoints);
            using var source = new FileStream(lasPath, FileMode.Open, FileAccess.Read, FileShare.Read, 1 << 20);
            var first = new byte[OffsetAt + 4];
            ReadExactly(source, first, first.Length, lasPath);
            long pointsAt = BitConverter.ToUInt32(first, OffsetAt), pointsEnd = pointsAt + points * recordBytes;
            var head = new byte[pointsAt];
            source.Position = 0;
            ReadExactly(source, head, head.Length, lasPath);
            BitConverter.GetBytes((uint)(pointsAt + vlr.Length)).CopyTo(head, OffsetAt);
            BitConverter.GetBytes(BitConverter.ToUInt32(head, VlrCountAt) + 1).CopyTo(head, VlrCountAt);
            head[PointFormatAt] |= CompressedBit;
            laz.Write(head, 0, head.Length);
            laz.Write(vlr, 0, vlr.Length);

            long tableOffsetAt = laz.Position;
            laz.Write(BitConverter.GetBytes(-1L), 0, 8);
            WriteTable(laz, tableOffsetAt, WriteChunks(source, laz, items, points, recordBytes, lasPath, progress, cancellation));
            bool hasEvlrs = head.Length >= EvlrAt + 8 && head[25] >= 4 && BitConverter.ToInt64(head, EvlrAt) >= pointsEnd;
            if (!hasEvlrs)
                return;
            long evlrsAt = laz.Position + BitConverter.ToInt64(head, EvlrAt) - pointsEnd;
            source.Position = pointsEnd;
            source.CopyTo(laz);
            laz.Position = EvlrAt;
            laz.Write(BitConverter.GetBytes(evlrsAt), 0, 8);
            laz.Position = laz.Length;
        }

        static List<int> WriteChunks(Stream source, Stream laz, LazItem[] items, long points, int recordBytes, string path,
            StageProgress progress, CancellationToken cancellation)
        {
            var bytesOfChunk = new List<int>();
            var records = new List<byte[]>();
            for (long done = 0; done < points; done += records.Count)
            {
                cancellation.ThrowIfCancellationRequested();
                int count = (int)Math.Min(ChunkPoints, points - done);
                while (records.Count < count)
                    records.Add(new byte[recordBytes]);
                records.RemoveRange(count, records.Count - count);
                foreach (var record in records)
                    ReadExactly(source, record, recordBytes, path);
                var chunk = LazEncoder.Chunk(items, records);
                laz.Write(chunk, 0, chunk.Length);
                bytesOfChunk.Add(chunk.Length);
                progress?.Report((done + count) / (double)points, done + count, (done + count) * recordBytes);
            }
            return bytesOfChunk;
        }

        static void WriteTable(Stream laz, long tableOffsetAt, List<int> bytesOfChunk)
        {
            long tableAt = laz.Position;
            var table = LazEncoder.Table(bytesOfChunk, null);
            laz.Write(table, 0, table.Length);
            long end = laz.Position;
            laz.Position = tableOffsetAt;
            laz.Write(BitConverter.GetBytes(tableAt), 0, 8);
            laz.Position = end;
        }

        static void ReadExactly(Stream stream, byte[] bytes, int count, string path)
        {
            for (int got = 0; got < count;)
            {
                int read = stream.Read(bytes, got, count - got);
                if (read == 0)
                    throw new PointCloudException(FailureCode.ReadFailed, path, stream.Position, "the file became shorter");
                got += read;
            }
        }
    }
}
