using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>
    /// Reads LAZ: what LASzip 1.x to 3.x write, pointwise or in layers, point formats 0 to 10. Blocks are the file's chunks; any
    /// of them decodes on its own, and the first points of one without the rest of it.
    /// </summary>
    /// <remarks>
    /// A chunk of more than <see cref="MaxBlockPoints"/> points becomes several blocks. Of a pointwise one each block starts
    /// from a checkpoint, a copy of the decoder's state there, which <see cref="FindBlocks"/> takes by decoding the chunk once;
    /// of a layered one a block decodes the chunk from its start (no writer makes such chunks unasked).
    /// </remarks>
    public sealed class LazReader : PointReader
    {
        /// <summary>Chunks up to this are one block, unless their records are long.</summary>
        public const int MaxBlockPoints = 1 << 20;

        /// <summary>No record is so long that fewer points make a block.</summary>
        const int LeastLongChunkPoints = 1 << 16;

        /// <summary>Records of a block: a slot holds its columns, whatever a file claims.</summary>
        const int MaxBlockBytes = 32 << 20;

        /// <summary>Compressed bytes of a layered chunk, which a slot holds whole.</summary>
        public const long MaxLayeredChunkBytes = 1L << 29;

        readonly LasFile m_las;
        readonly FileSource m_source;
        readonly List<LazChunk> m_chunks = new List<LazChunk>();
        readonly List<LazBlock> m_blocks = new List<LazBlock>();
        readonly List<LazCheckpoint> m_checkpoints = new List<LazCheckpoint>();
        readonly HashSet<int> m_toldBlocks = new HashSet<int>();
        readonly int m_longChunkPoints;
        readonly bool m_isTableLost;
        readonly FileHandle m_file;
        bool m_isOpen;
        bool m_areBlocksKnown;
        int m_maxPointsPerBlock;

        LazReader(LasFile las, LazFormat format, FileSource source, int longChunkPoints)
        {
            int ofBytes = Math.Max(LeastLongChunkPoints, MaxBlockBytes / las.Header.RecordBytes);
            m_longChunkPoints = Math.Min(longChunkPoints, ofBytes);
            m_las = las;
            m_source = source;
            Format = format;
            Info = las.Info;
            m_isTableLost = FindChunks();
            m_areBlocksKnown = !m_isTableLost && !HasLongPointwiseChunk();
            if (m_areBlocksKnown)
                MakeBlocks(null);
            m_file = AsyncReadManager.OpenFileAsync(Path.GetFullPath(Info.Path));
            m_isOpen = true;
        }

        /// <summary>Reads the header, the LASzip VLR and the chunk table. Warnings are in <see
        /// cref="PointReader.Info"/>.</summary>
        /// <param name="longChunkPoints">Points up to which a chunk is one block.</param>
        /// <exception cref="PointCloudException">The points cannot be told apart, or are coded in a way that is not
        /// known.</exception>
        public static PointReader Open(LasFile las, FileSource source, int longChunkPoints = MaxBlockPoints)
        {
            var format = LazFormat.Read(las);
            las.Info.Fact("LASzip version", format.WriterVersion);
            las.Info.Fact("LASzip compressor", format.Compressor.ToString());
            las.Info.Fact("LASzip chunk points", format.Compressor == LazCompressor.Pointwise ? "none"
                : format.HasVariableChunks ? "variable" : format.ChunkPoints.ToString(CultureInfo.InvariantCulture));
            var items = new List<string>();
            foreach (var item in format.Items)
                items.Add(item.Type + " v" + item.Version.ToString(CultureInfo.InvariantCulture));
            las.Info.Fact("LASzip items", string.Join(", ", items));
            return format.Compressor == LazCompressor.None
                ? LasReader.OpenUncompressed(las, source)
                : new LazReader(las, format, source, longChunkPoints);
        }

        public LasHeader Header => m_las.Header;

        public LasVlrTable Vlrs => m_las.Vlrs;

        public LazFormat Format { get; }

        public override bool BlocksAreKnown => m_areBlocksKnown;

        public override int BlockCount => m_blocks.Count;

        public override int MaxPointsPerBlock => m_maxPointsPerBlock;

        internal LasRecordLayout Layout => m_las.Layout;

        internal ref readonly FileHandle File => ref m_file;

        /// <summary>Chunks of more points become several blocks.</summary>
        internal int LongChunkPoints => m_longChunkPoints;

        public override long FirstPointOfBlock(int block) => Block(block).FirstPoint;

        public override int PointsInBlock(int block) => Block(block).Points;

        /// <summary>An estimate by the block's share; unwanted layers are not taken off.</summary>
        public override long BytesOfRange(BlockRange range)
        {
            var block = Block(range.Block);
            var chunk = m_chunks[block.Chunk];
            long ofBlock = (long)(chunk.Bytes * (block.Points / (double)Math.Max(1, chunk.Points)));
            return Math.Min(chunk.Bytes, (long)(ofBlock * ((range.First + range.Count) / (double)Math.Max(1, block.Points))));
        }

        public override IEnumerator<JobHandle> FindBlocks()
        {
            if (m_areBlocksKnown)
                yield break;
            var walk = new LazWalk(this, m_source, m_checkpoints);
            var steps = walk.Run(m_chunks, m_isTableLost);
            try
            {
                while (steps.MoveNext())
                    yield return steps.Current;
            }
            finally
            {
                steps.Dispose();
                m_source.Dispose();
            }
            MakeBlocks(walk);
            m_source.Dispose();
            m_areBlocksKnown = true;
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new LazBlockRead(this, wanted, capacity, allocator);

        internal LazBlock Block(int block)
        {
            if ((uint)block >= (uint)m_blocks.Count)
                throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + m_blocks.Count + " blocks");
            return m_blocks[block];
        }

        internal LazChunk ChunkOf(LazBlock block) => m_chunks[block.Chunk];

        internal LazCheckpoint CheckpointOf(LazBlock block) => block.Checkpoint < 0 ? null : m_checkpoints[block.Checkpoint];

        /// <summary>Input of the largest block, for a slot that takes any.</summary>
        internal long MaxInputBytes()
        {
            long most = 0;
            foreach (var block in m_blocks)
            {
                long start = block.Checkpoint < 0 ? m_chunks[block.Chunk].Offset : m_checkpoints[block.Checkpoint].FileOffset;
                long before = block.FirstInChunk - (block.Checkpoint < 0 ? 0 : m_checkpoints[block.Checkpoint].Point);
                most = Math.Max(most, Math.Min(block.EndOffset - start, MaxInputBytes(before + block.Points)));
            }
            return most;
        }

        /// <summary>Bytes that so many points of a chunk take at most: all that is read of one, however long it says it
        /// is.</summary>
        internal long MaxInputBytes(long points) => Format.IsLayered
            ? LazLayer.MaxInputBytes(Format.Layers, Format.RecordBytes, points)
            : PointwiseChunk.MaxInputBytes(Format.Items, Format.RecordBytes, points);

        /// <summary>A warning for a block that gave fewer points than it has, or did not end where it should; once a
        /// block.</summary>
        internal void TellBroken(BlockRange range, DecodeResult result)
        {
            if (!m_toldBlocks.Add(range.Block))
                return;
            string chunk = "chunk " + Text(Block(range.Block).Chunk);
            Info.Warn(result.ErrorOffset, result.Error == LazError.EndMismatch
                ? chunk + " does not end where its stream does: some of its points are not what was written"
                : chunk + ": wanted " + Text(range.Count) + " points, got " + Text(result.Points)
                    + ": the others are not in the file");
        }

        public override void Dispose()
        {
            if (!m_isOpen)
                return;
            m_isOpen = false;
            m_source.Dispose();
            m_file.Close().Complete();
        }

        /// <returns>Whether the table that says where they are is lost.</returns>
        bool FindChunks()
        {
            long start = Header.PointsOffset;
            bool isLost = false;
            if (Format.Compressor == LazCompressor.Pointwise)
            {
                long bytes = Math.Max(0, m_source.Length - start);
                if (bytes >= Info.RecordBytes && Info.PointsClaimed > 0)
                    m_chunks.Add(new LazChunk
                    {
                        Offset = start,
                        Bytes = bytes,
                        Points = (long)Math.Min(Info.PointsClaimed, (ulong)LazChunk.MaxPoints(bytes)),
                    });
            }
            else if (Info.PointsClaimed > 0 || m_source.Length > start + LazChunkTable.LeastBytes)
            {
                var table = LazChunkTable.Read(m_source, Format, Info, start);
                m_chunks.AddRange(table.Chunks);
                isLost = table.IsLost && (Format.IsLayered || !Format.HasVariableChunks);
            }
            foreach (var chunk in m_chunks)
                if (Format.IsLayered && chunk.Bytes > MaxLayeredChunkBytes)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, Info.Path, chunk.Offset, "bytes of a layered chunk",
                        "at most " + Text(MaxLayeredChunkBytes), chunk.Bytes);
            if (m_chunks.Count == 0 && !isLost && Info.PointsClaimed > 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, start, "the header claims "
                    + Info.PointsClaimed.ToString(CultureInfo.InvariantCulture) + " points, the file holds none");
            return isLost;
        }

        bool HasLongPointwiseChunk()
        {
            foreach (var chunk in m_chunks)
                if (!Format.IsLayered && chunk.Points > m_longChunkPoints)
                    return true;
            return false;
        }

        void MakeBlocks(LazWalk walk)
        {
            long first = 0;
            for (int c = 0; c < m_chunks.Count; c++)
            {
                var chunk = m_chunks[c];
                int parts = m_blocks.Count;
                if (chunk.Points <= m_longChunkPoints)
                    AddBlock(c, 0, chunk.Points, chunk.Offset + chunk.Bytes, true, -1, ref first);
                else if (Format.IsLayered)
                    for (long part = 0; part < chunk.Points; part += m_longChunkPoints)
                        AddBlock(c, part, Math.Min(m_longChunkPoints, chunk.Points - part), chunk.Offset + chunk.Bytes,
                            part + m_longChunkPoints >= chunk.Points, -1, ref first);
                else
                    AddPartsByCheckpoints(c, walk.CheckpointsOf(c), ref first);
                for (int i = parts; i < m_blocks.Count; i++)
                    m_maxPointsPerBlock = Math.Max(m_maxPointsPerBlock, m_blocks[i].Points);
            }
            Info.PointsReadable = first;
            CheckBounds();
        }

        /// <summary>Blocks between the checkpoints of a long chunk; those that lost their state start from an earlier
        /// one.</summary>
        void AddPartsByCheckpoints(int c, BlockRange checkpoints, ref long first)
        {
            var chunk = m_chunks[c];
            int withState = -1;
            long at = 0, end;
            for (int i = 0; i <= checkpoints.Count; i++, at = end)
            {
                bool isLast = i == checkpoints.Count;
                int next = checkpoints.First + i;
                end = isLast ? chunk.Points : m_checkpoints[next].Point;
                AddBlock(c, at, end - at, isLast ? chunk.Offset + chunk.Bytes : m_checkpoints[next].FileOffset, isLast, withState,
                    ref first);
                if (!isLast && m_checkpoints[next].HasState)
                    withState = next;
            }
        }

        void AddBlock(int chunk, long firstInChunk, long points, long end, bool isToEnd, int checkpoint, ref long first)
        {
            if (points <= 0)
                return;
            m_blocks.Add(new LazBlock
            {
                Chunk = chunk,
                FirstInChunk = firstInChunk,
                FirstPoint = first,
                Points = (int)points,
                EndOffset = end,
                IsToEnd = isToEnd,
                Checkpoint = checkpoint,
            });
            first += points;
        }

        /// <summary>Holds the claimed bounds against the first points of some chunks, which are stored as they are.</summary>
        void CheckBounds()
        {
            var offsets = new List<long>();
            if (m_chunks.Count > 0)
            {
                offsets.Add(m_chunks[0].Offset);
                offsets.Add(m_chunks[m_chunks.Count / 2].Offset);
                offsets.Add(m_chunks[m_chunks.Count - 1].Offset);
            }
            LasClaims.CheckBounds(Header, m_source, offsets, Info);
        }

        static string Text(long number) => number.ToString(CultureInfo.InvariantCulture);
    }
}
