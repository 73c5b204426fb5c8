using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.IO.LowLevel.Unsafe;

namespace FastPoints.Files
{
    /// <summary>A file whose points lie in LAZ chunks, wherever these are listed: in a chunk table (<see cref="LazReader"/>) or
    /// in the hierarchy of an octree (<see cref="CopcReader"/>). A block is a chunk, or a part of one that is too long; any of
    /// them can be decoded on its own, and its first points without the rest.</summary>
    internal abstract class LazChunkReader : PointReader
    {
        /// <summary>Chunks up to this size are one block, unless their records are long.</summary>
        public const int MaxBlockPoints = 1 << 20;

        /// <summary>Compressed bytes of a layered chunk, which a slot holds whole.</summary>
        public const long MaxLayeredChunkBytes = 1L << 29;

        /// <summary>A block has at least this many points, however long its records are.</summary>
        const int LeastLongChunkPoints = 1 << 16;

        /// <summary>Limit for the records of a block: a slot holds its columns, whatever a file claims.</summary>
        const int MaxBlockBytes = 32 << 20;

        readonly LasFile m_las;
        readonly List<LazBlock> m_blocks = new List<LazBlock>();

        /// <summary>Whether each chunk is one block, so that no list of blocks is needed.</summary>
        bool m_areChunksBlocks;
        long m_maxInputBytes = -1;
        readonly HashSet<int> m_toldBlocks = new HashSet<int>();
        readonly Dictionary<int, long> m_endOfChunk = new Dictionary<int, long>();
        FileHandle m_file;
        bool m_isOpen;
        int m_maxPointsPerBlock;

        private protected LazChunkReader(LasFile las, LazFormat format, FileSource source, int longChunkPoints)
        {
            int ofBytes = Math.Max(LeastLongChunkPoints, MaxBlockBytes / las.Header.RecordBytes);
            LongChunkPoints = Math.Min(longChunkPoints, ofBytes);
            m_las = las;
            Source = source;
            Format = format;
            Info = las.Info;
        }

        public LasHeader Header => m_las.Header;

        public LasVlrTable Vlrs => m_las.Vlrs;

        public LazFormat Format { get; }

        public override int BlockCount => m_areChunksBlocks ? Chunks.Count : m_blocks.Count;

        public override int MaxPointsPerBlock => m_maxPointsPerBlock;

        internal LasRecordLayout Layout => m_las.Layout;

        internal ref readonly FileHandle File
        {
            get
            {
                OpenFile();
                return ref m_file;
            }
        }

        /// <summary>Chunks with more points become several blocks.</summary>
        internal int LongChunkPoints { get; }

        private protected FileSource Source { get; }

        private protected LazChunkList Chunks { get; set; } = new LazChunkList();

        public override long FirstPointOfBlock(int block) =>
            m_areChunksBlocks ? Chunks.FirstPointOf(block) : Block(block).FirstPoint;

        public override int PointsInBlock(int block) => m_areChunksBlocks ? (int)Chunks.PointsOf(block) : Block(block).Points;

        public override string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = Chunks[Block(block).Chunk].Offset;
            return Info.Path;
        }

        /// <summary>Estimates by the block's share of its chunk; unwanted layers are not deducted.</summary>
        public override long BytesOfRange(BlockRange range)
        {
            var block = Block(range.Block);
            var chunk = Chunks[block.Chunk];
            long ofBlock = (long)(chunk.Bytes * (block.Points / (double)Math.Max(1, chunk.Points)));
            return Math.Min(chunk.Bytes, (long)(ofBlock * ((range.First + range.Count) / (double)Math.Max(1, block.Points))));
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new LazBlockRead(this, wanted, capacity, allocator);

        internal LazBlock Block(int block)
        {
            if ((uint)block >= (uint)BlockCount)
                throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + BlockCount + " blocks");
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

        /// <summary>
        /// Records that a chunk gave its last point before <paramref name="point"/>, counted in it: later blocks are not tried,
        /// since each would decode the chunk from its start.
        /// </summary>
        internal void EndChunk(LazBlock block, long point) => m_endOfChunk[block.Chunk] = Math.Min(point, EndOfChunk(block));

        /// <summary>The most points that a chunk can have, as far as is known.</summary>
        internal long EndOfChunk(LazBlock block) =>
            m_endOfChunk.TryGetValue(block.Chunk, out long end) ? end : Chunks[block.Chunk].Points;

        internal LazChunk ChunkOf(LazBlock block) => Chunks[block.Chunk];

        /// <summary>The checkpoint from which a block is decoded, if not from its chunk's start.</summary>
        internal virtual LazCheckpoint CheckpointOf(LazBlock block) => null;

        /// <summary>Input bytes of the largest known block, for a slot that takes any.</summary>
        internal long MaxInputBytes()
        {
            // For millions of blocks this takes longer than reading some of them.
            if (m_maxInputBytes >= 0)
                return m_maxInputBytes;
            if (m_areChunksBlocks)
                return m_maxInputBytes = Math.Min(Chunks.MaxBytes, MaxInputBytes(Chunks.MaxPoints));
            long most = 0;
            foreach (var block in m_blocks)
            {
                var checkpoint = CheckpointOf(block);
                long start = checkpoint?.FileOffset ?? Chunks[block.Chunk].Offset;
                long before = block.FirstInChunk - (checkpoint?.Point ?? 0);
                most = Math.Max(most, Math.Min(block.EndOffset - start, MaxInputBytes(before + block.Points)));
            }
            return m_maxInputBytes = most;
        }

        /// <summary>The most bytes that this many points of a chunk take: no more is read, however long the chunk claims to
        /// be.</summary>
        internal long MaxInputBytes(long points) => Format.IsLayered
            ? LazLayer.MaxInputBytes(Format.Layers, Format.RecordBytes, points)
            : PointwiseChunk.MaxInputBytes(Format.Items, Format.RecordBytes, points);

        /// <summary>Warns about a block that gave fewer points than it has, or did not end where it should, once for each
        /// block.</summary>
        internal void WarnBroken(BlockRange range, DecodeResult result)
        {
            if (!m_toldBlocks.Add(range.Block))
                return;
            string chunk = "chunk " + NumberText.Of(Block(range.Block).Chunk);
            Info.Warn(result.ErrorOffset, result.Error == LazError.EndMismatch
                ? chunk + " does not end where its stream does: some of its points are not what was written"
                : result.Error == LazError.GoesOn
                ? chunk + " has bytes behind its last point: the file is cut or claims too few points, or some of them are not "
                    + "what was written"
                : result.Error == LazError.NoChunk
                ? chunk + ": wanted " + NumberText.Of(range.Count) + " points, got bytes that are no chunk's"
                : chunk + ": wanted " + NumberText.Of(range.Count) + " points, got " + NumberText.Of(result.Points)
                    + ": the others are not in the file");
        }

        void OpenFile()
        {
            if (m_isOpen)
                return;
            m_file = AsyncReadManager.OpenFileAsync(Path.GetFullPath(Info.Path));
            m_isOpen = true;
        }

        public override void CloseFile()
        {
            if (!m_isOpen)
                return;
            m_isOpen = false;
            Source.Dispose();
            m_file.Close().Complete();
        }

        /// <summary>Uses each chunk as a block if none is too long for that: millions of them then take no memory.</summary>
        private protected bool TryTakeChunksAsBlocks()
        {
            m_areChunksBlocks = Chunks.AreInRow && Chunks.MaxPoints <= LongChunkPoints;
            if (m_areChunksBlocks)
                m_maxPointsPerBlock = (int)Chunks.MaxPoints;
            return m_areChunksBlocks;
        }

        /// <summary>Adds a chunk that starts without a checkpoint, as one block or several.</summary>
        private protected void AddBlocksOf(int chunk)
        {
            var of = Chunks[chunk];
            for (long part = 0; part < of.Points; part += LongChunkPoints)
                AddBlock(chunk, part, Math.Min(LongChunkPoints, of.Points - part), of.Offset + of.Bytes,
                    part + LongChunkPoints >= of.Points, -1);
        }

        /// <summary>Removes the blocks, to add others of the same chunks.</summary>
        private protected void ClearBlocks()
        {
            m_blocks.Clear();
            m_areChunksBlocks = false;
            m_maxPointsPerBlock = 0;
            m_maxInputBytes = -1;
        }

        private protected void AddBlock(int chunk, long firstInChunk, long points, long end, bool isToEnd, int checkpoint)
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
            m_maxPointsPerBlock = Math.Max(m_maxPointsPerBlock, (int)points);
            m_maxInputBytes = -1;
        }

        /// <summary>Checks the claimed bounds against the first points of some chunks, which are stored uncompressed.</summary>
        private protected void CheckBounds()
        {
            var offsets = new List<long>();
            if (Chunks.Count > 0)
            {
                offsets.Add(Chunks[0].Offset);
                offsets.Add(Chunks[Chunks.Count / 2].Offset);
                offsets.Add(Chunks[Chunks.Count - 1].Offset);
            }
            LasClaims.CheckBounds(Header, Source, offsets, Info);
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
