using System;
using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Laz
{
    // Lies behind the chunks; the first eight bytes of the points say where. Everything in it is held against the file's size; a
    // table that contradicts itself counts as missing. uint version (0), uint chunks, then range-coded for each chunk: its points
    // (if chunks vary), its bytes, each predicted by the one before.
    internal sealed class LazChunkTable
    {
        // Between the offset of the points and the first chunk; they say where the table is.
        public const int TableOffsetSize = 8;
        public const int HeaderBytes = 8;

        // Of a file without points: the table's offset, and the table.
        public const int MinBytes = TableOffsetSize + HeaderBytes;
        const long OffsetAtFileEnd = -1;
        const int MaxEntryBytes = 14; // At most, of two numbers for a chunk, with 15 + 15 bits modelled and 23 raw.

        const int WindowBytes = 64 << 10;
        const int CoderBytes = 16; // To start and to end.

        // With the eight bytes behind it that may say where it is.
        public static long MaxBytes(long chunks) => HeaderBytes + chunks * MaxEntryBytes + CoderBytes + TableOffsetSize;

        readonly RandomAccessFile m_source;
        readonly LazFormat m_format;
        readonly SourceInfo m_info;
        readonly ulong m_pointsClaimed;
        int m_emptyChunks;

        LazChunkTable(RandomAccessFile source, LazFormat format, SourceInfo info, long pointsOffset)
        {
            m_source = source;
            m_format = format;
            m_info = info;
            m_pointsClaimed = info.PointsClaimed;
            FirstChunkOffset = pointsOffset + TableOffsetSize;
        }

        public long FirstChunkOffset { get; }
        public LazChunkList Chunks { get; } = new LazChunkList();

        // Chunks holds what is known, and the rest must be searched for from where the known ones end.
        public bool IsLost { get; private set; }

        public static LazChunkTable Read(RandomAccessFile source, LazFormat format, SourceInfo info, long pointsOffset)
        {
            var table = new LazChunkTable(source, format, info, pointsOffset);
            string problem = table.Read(pointsOffset, out long at);
            if (problem == null)
            {
                table.Check();
                return table;
            }
            table.IsLost = true;
            bool canWalk = format.IsLayered || !format.HasVariableChunks;
            if (canWalk)
                table.Chunks.Clear();
            info.Warn(at, "chunk table: " + problem + (canWalk
                ? ": the chunks are looked for one after the other"
                : ": without it chunks of varying size cannot be told apart; " + NumberText.Of(table.Chunks.Count)
                    + " are known"));
            return table;
        }

        string Read(long pointsOffset, out long at)
        {
            at = pointsOffset;
            if (pointsOffset > m_source.Length - TableOffsetSize)
                return "the file ends before its offset";
            long start = OffsetAt(pointsOffset);
            if (start == OffsetAtFileEnd)
            {
                // A writer that could not seek back wrote the offset at the end of the file.
                at = m_source.Length - TableOffsetSize;
                start = OffsetAt(at);
            }
            if (start == pointsOffset || start == 0)
                return "its offset was never written (" + NumberText.Of(start) + ")";
            if (start < FirstChunkOffset || start > m_source.Length - HeaderBytes)
                return "wanted an offset of " + NumberText.Of(FirstChunkOffset) + " to "
                    + NumberText.Of(m_source.Length - HeaderBytes) + ", got " + NumberText.Of(start);

            at = start;
            var header = m_source.Read(start, HeaderBytes, "chunk table");
            uint version = header.UInt32(0, "chunk table version");
            if (version != 0)
                return "wanted version 0, got " + NumberText.Of(version);
            long count = header.UInt32(4, "number of chunks");
            long room = (start - FirstChunkOffset) / m_format.RecordBytes;
            if (count > room)
                return "claims " + NumberText.Of(count) + " chunks, there is room for " + NumberText.Of(room);
            if (count > int.MaxValue)
                return "claims " + NumberText.Of(count) + " chunks, at most " + NumberText.Of(int.MaxValue) + " are read";
            if (count == 0)
                return m_pointsClaimed == 0 ? null : "claims no chunks, the header claims points";
            return ReadEntries(start, count);
        }

        long OffsetAt(long at) => (long)m_source.Read(at, TableOffsetSize, "chunk table offset").UInt64(0, "chunk table offset");

        unsafe string ReadEntries(long start, long count)
        {
            long at = start + HeaderBytes;
            long endOfTable = Math.Min(m_source.Length, at + count * MaxEntryBytes + CoderBytes);
            var window = new byte[WindowBytes + RangeCoder.PaddingBytes];
            bool isVariable = m_format.HasVariableChunks;
            long offset = FirstChunkOffset;
            ulong pointsLeft = m_pointsClaimed;
            int lastPoints = 0, lastBytes = 0;

            using (var models = new NativeArray<byte>(IntegerModel.BytesOf(32, 2), Allocator.Persistent))
                fixed (byte* first = window)
                {
                    byte* model = (byte*)models.GetUnsafePtr();
                    IntegerModel.Initialize(model, 32, 2);
                    byte* end = first + Fill(window, at, endOfTable);
                    byte* next = first;
                    RangeCoder.StartDecoding(out uint value, out uint length, ref next);
                    for (long i = 0; i < count; i++)
                    {
                        if (end - next < MaxEntryBytes + CoderBytes && at + (end - first) < endOfTable)
                        {
                            at += next - first;
                            end = first + Fill(window, at, endOfTable);
                            next = first;
                        }
                        if (isVariable)
                            lastPoints += IntegerModel.Decode(model, 32, 2, 0, ref value, ref length, ref next);
                        lastBytes += IntegerModel.Decode(model, 32, 2, 1, ref value, ref length, ref next);
                        if (next > end)
                            return "ends within the entry of chunk " + NumberText.Of(i);
                        var chunk = new LazChunk { Offset = offset, Bytes = (uint)lastBytes, Points = (uint)lastPoints };
                        if (!isVariable)
                            chunk.Points = (long)Math.Min(pointsLeft, m_format.ChunkPoints);
                        if (chunk.Bytes > start - offset)
                            return "chunk " + NumberText.Of(i) + " would end at byte " + NumberText.Of(offset + chunk.Bytes)
                                + ", in or behind the table";
                        if (chunk.Bytes < m_format.RecordBytes && chunk.Points > 0)
                            return "chunk " + NumberText.Of(i) + " has " + NumberText.Of(chunk.Bytes)
                                + " bytes, wanted at least a record of "
                                + NumberText.Of(m_format.RecordBytes);
                        if (chunk.Points > LazChunk.MaxPoints(chunk.Bytes))
                            return "chunk " + NumberText.Of(i) + " claims " + NumberText.Of(chunk.Points) + " points in "
                                + NumberText.Of(chunk.Bytes) + " bytes";
                        offset += chunk.Bytes;
                        pointsLeft -= Math.Min(pointsLeft, (ulong)chunk.Points);
                        if (chunk.Points > 0)
                            Chunks.Add(chunk);
                        else if (!isVariable)
                            m_emptyChunks++;
                    }
                    if (offset < start)
                        m_info.Warn(offset, NumberText.Of(start - offset)
                            + " bytes between the last chunk and the chunk table belong to " + "none");
                }
            return null;
        }

        int Fill(byte[] window, long at, long endOfTable)
        {
            int count = (int)Math.Min(WindowBytes, endOfTable - at);
            m_source.Read(at, window, count, "chunk table");
            Array.Clear(window, count, window.Length - count);
            return count;
        }

        void Check()
        {
            ulong sum = (ulong)Chunks.PointCount;
            if (m_emptyChunks > 0)
                m_info.Warn(FirstChunkOffset, "the chunk table has " + NumberText.Of(m_emptyChunks)
                    + " chunks more than the points that the header claims: left out");
            if (sum == m_pointsClaimed)
                return;
            if (m_format.HasVariableChunks)
            {
                m_info.Warn(LasHeader.At.LegacyCount, "the header claims " + NumberText.Of(m_pointsClaimed)
                    + " points, the chunk table " + NumberText.Of(sum) + ": the table is believed");
                return;
            }
            // If all chunks have one size, only the header says how many points the last one has.
            m_info.Warn(LasHeader.At.LegacyCount, "the header claims " + NumberText.Of(m_pointsClaimed)
                + " points, the chunks in the table have room for " + NumberText.Of(sum));
        }

        // From its header on. pointsOfChunk: null if all have the VLR's number of points, but the last.
        public static unsafe byte[] ToBytes(IReadOnlyList<int> bytesOfChunk, IReadOnlyList<int> pointsOfChunk = null)
        {
            var table = new byte[MaxBytes(pointsOfChunk == null ? bytesOfChunk.Count : 2L * bytesOfChunk.Count)];
            LasHeader.Put(table, 4, 4, (ulong)bytesOfChunk.Count);
            using var models = new NativeArray<byte>(IntegerModel.BytesOf(32, 2), Allocator.Persistent);
            byte* model = (byte*)models.GetUnsafePtr();
            IntegerModel.Initialize(model, 32, 2);
            fixed (byte* first = table)
            {
                uint low = 0, length = uint.MaxValue;
                byte* next = first + HeaderBytes;
                for (int i = 0; i < bytesOfChunk.Count; i++)
                {
                    if (pointsOfChunk != null)
                        IntegerModel.Encode(model, 32, 2, 0, pointsOfChunk[i] - (i > 0 ? pointsOfChunk[i - 1] : 0), out _,
                            ref low, ref length, ref next);
                    IntegerModel.Encode(model, 32, 2, 1, bytesOfChunk[i] - (i > 0 ? bytesOfChunk[i - 1] : 0), out _, ref low,
                        ref length, ref next);
                }
                if (bytesOfChunk.Count > 0)
                    RangeCoder.EndEncoding(low, length, ref next);
                Array.Resize(ref table, (int)(next - first));
            }
            return table;
        }
    }
}
