using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Las;
using FastPoints.Reading;

namespace FastPoints.Laz
{
    /// <summary>The chunks of a LAZ file as far as they are known, and the blocks that they are read in: a chunk, or a part of
    /// one that is too long.</summary>
    sealed class LazBlocks
    {
        /// <summary>Compressed bytes of a layered chunk, which a slot holds whole.</summary>
        public const long MaxLayeredChunkBytes = 1L << 29;

        /// <summary>A block has at least this many points, however long its records are.</summary>
        const int MinLongChunkPoints = 1 << 16;

        /// <summary>Limit for the records of a block: a slot holds its columns, whatever a file claims.</summary>
        const int MaxBlockBytes = 32 << 20;

        readonly List<LazBlock> m_blocks = new List<LazBlock>();
        readonly HashSet<int> m_reportedBlocks = new HashSet<int>();
        readonly Dictionary<int, long> m_endOfChunk = new Dictionary<int, long>();

        /// <summary>Whether each chunk is one block, so that no list of blocks is needed.</summary>
        bool m_areChunksBlocks;
        long m_maxInputBytes = -1;

        public LazBlocks(LasFile las, LazFormat format, FileSource source, int longChunkPoints)
        {
            LongChunkPoints = Math.Min(longChunkPoints, Math.Max(MinLongChunkPoints, MaxBlockBytes / las.Header.RecordBytes));
            Las = las;
            Format = format;
            Source = source;
            File = new SourceHandle(las.Info.Path);
        }

        public LasFile Las { get; }

        public LazFormat Format { get; }

        /// <summary>The file for what lies between the points.</summary>
        public FileSource Source { get; }

        /// <summary>The same file for the points.</summary>
        public SourceHandle File { get; }

        public SourceInfo Info => Las.Info;

        /// <summary>Chunks with more points become several blocks.</summary>
        public int LongChunkPoints { get; }

        public LazChunkList Chunks { get; set; } = new LazChunkList();

        /// <summary>Copies of the decoder's state, from which blocks within long chunks are decoded.</summary>
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

        /// <summary>The checkpoint from which a block is decoded, if not from its chunk's start.</summary>
        public LazCheckpoint CheckpointOf(LazBlock block) => block.Checkpoint < 0 ? null : Checkpoints[block.Checkpoint];

        /// <summary>Records that a chunk gave its last point before <paramref name="point"/>, counted in it: later blocks are not
        /// tried, since each would decode the chunk from its start.</summary>
        public void EndChunk(LazBlock block, long point) => m_endOfChunk[block.Chunk] = Math.Min(point, EndOfChunk(block));

        /// <summary>The most points that a chunk can have, as far as is known.</summary>
        public long EndOfChunk(LazBlock block) =>
            m_endOfChunk.TryGetValue(block.Chunk, out long end) ? end : Chunks[block.Chunk].Points;

        /// <summary>Input bytes of the largest known block, for a slot that takes any.</summary>
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

        /// <summary>The most bytes that this many points of a chunk take: no more is read, however long the chunk claims to
        /// be.</summary>
        public long MaxInputBytes(long points) => Format.IsLayered
            ? LazLayer.MaxInputBytes(Format.Layers, Format.RecordBytes, points)
            : PointwiseChunk.MaxInputBytes(Format.Items, Format.RecordBytes, points);

        /// <summary>Warns about a block that gave fewer points than it has, or did not end where it should, once for each
        /// block.</summary>
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
                : result.Error == LazError.NoChunk
                ? chunk + ": wanted " + NumberText.Of(range.Count) + " points, got bytes that are no chunk's"
                : chunk + ": wanted " + NumberText.Of(range.Count) + " points, got " + NumberText.Of(result.Points)
                    + ": the others are not in the file");
        }

        /// <summary>Uses each chunk as a block if none is too long for that: millions of them then take no memory.</summary>
        public bool TryTakeChunks()
        {
            m_areChunksBlocks = Chunks.AreInRow && Chunks.MaxPoints <= LongChunkPoints;
            if (m_areChunksBlocks)
                MaxPoints = (int)Chunks.MaxPoints;
            return m_areChunksBlocks;
        }

        /// <summary>Adds a chunk that starts without a checkpoint, as one block or several.</summary>
        public void AddChunk(int chunk)
        {
            var of = Chunks[chunk];
            for (long part = 0; part < of.Points; part += LongChunkPoints)
                Add(chunk, part, Math.Min(LongChunkPoints, of.Points - part), of.Offset + of.Bytes,
                    part + LongChunkPoints >= of.Points, -1);
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

        /// <summary>Removes the blocks, to add others of the same chunks.</summary>
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

        /// <summary>Checks the claimed bounds against the first points of some chunks, which are stored uncompressed.</summary>
        public void CheckBounds()
        {
            var offsets = new List<long>();
            if (Chunks.Count > 0)
                foreach (int chunk in new[] { 0, Chunks.Count / 2, Chunks.Count - 1 })
                    offsets.Add(Chunks[chunk].Offset);
            LasClaims.CheckBounds(Las.Header, Source, offsets, Info);
        }
    }

    /// <summary>A block of a LAZ file: a chunk, or a part of one that is too long.</summary>
    struct LazBlock
    {
        public int Chunk;

        /// <summary>First point, counted from the chunk's start.</summary>
        public long FirstInChunk;

        /// <summary>Index of its first point in the whole source.</summary>
        public long FirstPoint;

        public int Points;

        /// <summary>Offset of its end in the file: the chunk's end, except for parts of one.</summary>
        public long EndOffset;

        /// <summary>Whether it takes the chunk to its end.</summary>
        public bool IsToEnd;

        /// <summary>Index of the checkpoint from which it is decoded, or -1 for the chunk's start.</summary>
        public int Checkpoint;
    }
}
