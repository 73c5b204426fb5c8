using System;
using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Reading;

namespace FastPoints.Laz
{
    // The chunks as far as they are known, and the blocks that they are read in: a chunk, or a part of one that is too long.
    sealed class LazBlocks
    {
        public const long MaxLayeredChunkBytes = 1L << 29; // A slot holds a layered chunk whole.
        const int MinLongChunkPoints = 1 << 16; // A block has at least this many points, however long its records are.
        const int MaxBlockBytes = 32 << 20; // A slot holds its columns, whatever a file claims.

        readonly List<LazBlock> m_blocks = new List<LazBlock>();
        readonly HashSet<int> m_reportedBlocks = new HashSet<int>();
        readonly Dictionary<int, long> m_endOfChunk = new Dictionary<int, long>();
        bool m_areChunksBlocks;
        long m_maxInputBytes = -1;

        public LazBlocks(LasFile las, LazFormat format, RandomAccessFile source, int longChunkPoints)
        {
            LongChunkPoints = Math.Min(longChunkPoints, Math.Max(MinLongChunkPoints, MaxBlockBytes / las.Header.RecordBytes));
            Las = las;
            Format = format;
            Source = source;
            File = new SourceHandle(las.Info.Path);
        }

        public LasFile Las { get; }
        public LazFormat Format { get; }

        public RandomAccessFile Source { get; } // For what lies between the points.

        public SourceHandle File { get; }
        public SourceInfo Info => Las.Info;

        public int LongChunkPoints { get; } // Chunks with more points become several blocks.

        public LazChunkList Chunks { get; set; } = new LazChunkList();
        public List<LazCheckpoint> Checkpoints { get; } = new List<LazCheckpoint>();
        public int Count => m_areChunksBlocks ? Chunks.Count : m_blocks.Count;
        public int MaxPoints { get; private set; }
        public long PointCount => Count == 0 ? 0 : FirstPointOf(Count - 1) + PointsOf(Count - 1);

        public LazBlock this[int block]
        {
            get
            {
                if ((uint)block >= (uint)Count)
                    throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + Count + " blocks");
                if (!m_areChunksBlocks)
                    return m_blocks[block];
                var chunk = Chunks[block];
                return new LazBlock
                {
                    Chunk = block,
                    FirstPoint = Chunks.FirstPointOf(block),
                    Points = (int)chunk.Points,
                    EndOffset = chunk.Offset + chunk.Bytes,
                    IsToEnd = true,
                    Checkpoint = -1,
                };
            }
        }

        public long FirstPointOf(int block) => m_areChunksBlocks ? Chunks.FirstPointOf(block) : this[block].FirstPoint;

        public int PointsOf(int block) => m_areChunksBlocks ? (int)Chunks.PointsOf(block) : this[block].Points;

        public LazChunk ChunkOf(LazBlock block) => Chunks[block.Chunk];

        public LazCheckpoint CheckpointOf(LazBlock block) => block.Checkpoint < 0 ? null : Checkpoints[block.Checkpoint];

        // The chunk's points end before this one: later blocks are not tried, since each would decode the chunk from its start.
        public void MarkEndOfChunk(LazBlock block, long point) => m_endOfChunk[block.Chunk] = Math.Min(point, EndOfChunk(block));

        public long EndOfChunk(LazBlock block) =>
            m_endOfChunk.TryGetValue(block.Chunk, out long end) ? end : Chunks[block.Chunk].Points;

        public long MaxInputBytes()
        {
            // For millions of blocks this takes longer than reading some of them.
            if (m_maxInputBytes >= 0)
                return m_maxInputBytes;
            if (m_areChunksBlocks)
                return m_maxInputBytes = Math.Min(Chunks.MaxBytes, MaxInputBytes(Chunks.MaxPoints));
            long max = 0;
            foreach (var block in m_blocks)
            {
                var checkpoint = CheckpointOf(block);
                long start = checkpoint?.FileOffset ?? Chunks[block.Chunk].Offset;
                long before = block.FirstInChunk - (checkpoint?.Point ?? 0);
                max = Math.Max(max, Math.Min(block.EndOffset - start, MaxInputBytes(before + block.Points)));
            }
            return m_maxInputBytes = max;
        }

        // At most, of this many points: no more is read, however long the chunk claims to be.
        public long MaxInputBytes(long points) => Format.IsLayered
            ? LazLayer.MaxInputBytes(Format.Layers, Format.RecordBytes, points)
            : PointwiseChunk.MaxInputBytes(Format.Items, Format.RecordBytes, points);

        // What a range takes of a remote file: where a chunk's layers are is only known when it is here.
        public FilePiece PieceOf(BlockRange range)
        {
            var block = this[range.Block];
            var checkpoint = CheckpointOf(block);
            long start = checkpoint?.FileOffset ?? Chunks[block.Chunk].Offset, bytes = block.EndOffset - start;
            if (!Format.IsLayered)
                bytes = Math.Min(bytes,
                    MaxInputBytes(block.FirstInChunk - (checkpoint?.Point ?? 0) + range.First + range.Count));
            return new FilePiece { Path = Info.Path, OffsetBytes = start, LengthBytes = bytes };
        }

        public void WarnBroken(BlockRange range, DecodeResult result)
        {
            if (!m_reportedBlocks.Add(range.Block))
                return;
            string chunk = "chunk " + NumberText.Of(this[range.Block].Chunk);
            Info.Warn(result.ErrorOffset, result.Error == LazError.EndMismatch
                ? chunk + " does not end where its stream does: some of its points are not what was written"
                : result.Error == LazError.TrailingBytes
                ? chunk + " has bytes behind its last point: the file is cut or claims too few points, or some of them are not "
                    + "what was written"
                : result.Error == LazError.NotAChunk
                ? chunk + ": wanted " + NumberText.Of(range.Count) + " points, got bytes that are no chunk's"
                : chunk + ": wanted " + NumberText.Of(range.Count) + " points, got " + NumberText.Of(result.Points)
                    + ": the others are not in the file");
        }

        // Each chunk is a block if none is too long for that: millions of them then take no memory.
        public bool TryUseChunks()
        {
            m_areChunksBlocks = Chunks.AreContiguous && Chunks.MaxPoints <= LongChunkPoints;
            if (m_areChunksBlocks)
                MaxPoints = (int)Chunks.MaxPoints;
            return m_areChunksBlocks;
        }

        public void AddChunk(int chunk)
        {
            var added = Chunks[chunk];
            for (long part = 0; part < added.Points; part += LongChunkPoints)
                Add(chunk, part, Math.Min(LongChunkPoints, added.Points - part), added.Offset + added.Bytes,
                    part + LongChunkPoints >= added.Points, -1);
        }

        public void Add(int chunk, long firstInChunk, long points, long end, bool isToEnd, int checkpoint)
        {
            if (points <= 0)
                return;
            m_blocks.Add(new LazBlock
            {
                Chunk = chunk,
                FirstInChunk = firstInChunk,
                FirstPoint = PointCount,
                Points = (int)points,
                EndOffset = end,
                IsToEnd = isToEnd,
                Checkpoint = checkpoint,
            });
            MaxPoints = Math.Max(MaxPoints, (int)points);
            m_maxInputBytes = -1;
        }

        public void Clear()
        {
            m_blocks.Clear();
            m_areChunksBlocks = false;
            MaxPoints = 0;
            m_maxInputBytes = -1;
        }

        public void DropCheckpoints()
        {
            foreach (var checkpoint in Checkpoints)
                checkpoint.Dispose();
            Checkpoints.Clear();
        }

        // Against the first points of some chunks, which are stored uncompressed.
        public void CheckBounds()
        {
            var offsets = new List<long>();
            if (Chunks.Count > 0)
                foreach (int chunk in new[] { 0, Chunks.Count / 2, Chunks.Count - 1 })
                    offsets.Add(Chunks[chunk].Offset);
            LasClaims.CheckBounds(Las.Header, Source, offsets, Info);
        }
    }

    struct LazBlock
    {
        public int Chunk;
        public long FirstInChunk; // Counted from the chunk's start.

        public long FirstPoint;
        public int Points;
        public long EndOffset; // The chunk's end, except for parts of one.

        public bool IsToEnd;
        public int Checkpoint; // From which it is decoded, or -1 for the chunk's start.
    }
}
