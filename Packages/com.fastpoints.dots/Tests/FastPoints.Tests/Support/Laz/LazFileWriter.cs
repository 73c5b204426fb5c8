using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Las;
using FastPoints.Laz;
using Unity.Mathematics;

namespace FastPoints.Tests
{
    public enum LazTableLocation
    {
        AtOffset,

        /// <summary>The offset is -1, and the true one the last 8 bytes of the file.</summary>
        AtFileEnd,

        Missing,
    }

    public sealed class LazFileWriter
    {
        public int PointFormat;

        /// <summary>Of the items: 2 for point formats 0 to 5, 3 or 4 above.</summary>
        public int ItemVersion = 2;

        public int ExtraBytes;

        /// <summary>Points of each chunk; one number for all, or one a chunk. Empty: one chunk without a table (compressor
        /// 1).</summary>
        public int[] ChunkPoints = { 50000 };

        public bool HasVariableChunks;
        public LazTableLocation TableLocation = LazTableLocation.AtOffset;
        public bool IsUncompressed;

        /// <summary>Points that the header claims; -1 for the truth.</summary>
        public long Claims = -1;

        /// <summary>A whole VLR in front of the LASzip one, or null.</summary>
        public byte[] FirstVlr;

        public double3 Scale = new double3(0.01, 0.01, 0.01);
        public List<(long Offset, int Bytes)> Chunks { get; } = new List<(long, int)>();
        public int RecordBytes => LasPointFormat.Of(PointFormat).RecordBytes + ExtraBytes;

        internal LazItem[] Items() => LazItems.Of(PointFormat, ItemVersion, ExtraBytes);

        public byte[] Write(IReadOnlyList<byte[]> records)
        {
            var items = Items();
            var file = new BinaryWriter(new MemoryStream());
            var vlr = Vlr(items);
            int firstBytes = FirstVlr?.Length ?? 0;
            Chunks.Clear();
            int minor = PointFormat >= 6 ? 4 : 2;
            long claims = Claims >= 0 ? Claims : records.Count;
            var header = new LasHeader
            {
                VersionMinor = minor,
                PointFormat = PointFormat,
                IsCompressed = true,
                RecordBytes = RecordBytes,
                HeaderBytes = LasHeader.BytesOf(minor),
                PointsOffset = (uint)(LasHeader.BytesOf(minor) + firstBytes + vlr.Length),
                VlrCount = FirstVlr == null ? 1u : 2u,
                LegacyCount = PointFormat >= 6 ? 0 : (uint)claims,
                Count64 = minor >= 4 ? (ulong)claims : 0,
                Scale = Scale,
                Min = new double3(-1e9, -1e9, -1e9),
                Max = new double3(1e9, 1e9, 1e9),
                SystemIdentifier = "",
                GeneratingSoftware = "FastPoints tests",
            };
            file.Write(header.ToBytes());
            if (FirstVlr != null)
                file.Write(FirstVlr);
            file.Write(vlr);
            WritePoints(file, items, records);
            return ((MemoryStream)file.BaseStream).ToArray();
        }

        void WritePoints(BinaryWriter file, LazItem[] items, IReadOnlyList<byte[]> records)
        {
            if (IsUncompressed)
            {
                foreach (var record in records)
                    file.Write(record);
                return;
            }
            if (ChunkPoints.Length == 0)
            {
                file.Write(LazEncoder.Chunk(items, records));
                return;
            }
            long tableOffsetAt = file.BaseStream.Position;
            file.Write(TableLocation == LazTableLocation.Missing ? tableOffsetAt : -1L);
            var bytes = new List<int>();
            var points = new List<int>();
            for (int first = 0; first < records.Count;)
            {
                int count = Math.Min(ChunkPoints[Math.Min(points.Count, ChunkPoints.Length - 1)], records.Count - first);
                var chunk = LazEncoder.Chunk(items, Part(records, first, count));
                Chunks.Add((file.BaseStream.Position, chunk.Length));
                file.Write(chunk);
                bytes.Add(chunk.Length);
                points.Add(count);
                first += count;
            }
            if (TableLocation == LazTableLocation.Missing)
                return;
            long table = file.BaseStream.Position;
            file.Write(LazChunkTable.ToBytes(bytes, HasVariableChunks ? points : null));
            if (TableLocation == LazTableLocation.AtFileEnd)
            {
                file.Write(table);
                return;
            }
            file.BaseStream.Position = tableOffsetAt;
            file.Write(table);
        }

        byte[] Vlr(LazItem[] items) => LazItems.Vlr(items,
            IsUncompressed ? LazCompressor.None : ChunkPoints.Length == 0 ? LazCompressor.Pointwise
                : PointFormat >= 6 ? LazCompressor.LayeredChunked : LazCompressor.PointwiseChunked,
            HasVariableChunks ? LazFormat.VariableChunkPoints : ChunkPoints.Length == 0 ? 0 : (uint)ChunkPoints[0]);

        static List<byte[]> Part(IReadOnlyList<byte[]> records, int first, int count)
        {
            var part = new List<byte[]>(count);
            for (int i = 0; i < count; i++)
                part.Add(records[first + i]);
            return part;
        }
    }
}
