using System;
using System.Collections.Generic;
using FastPoints.Base;

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
    internal sealed class LazReader : LazChunkReader
    {
        const int MaxPrefixPoints = 1 << 18;

        readonly List<LazCheckpoint> m_checkpoints = new List<LazCheckpoint>();
        readonly bool m_isTableLost;
        bool m_areBlocksKnown;

        LazReader(LasFile las, LazFormat format, FileSource source, int longChunkPoints)
            : base(las, format, source, longChunkPoints)
        {
            m_isTableLost = FindChunks();
            m_areBlocksKnown = !m_isTableLost && !HasLongPointwiseChunk();
            if (m_areBlocksKnown)
                MakeBlocks(null);
        }

        /// <summary>Reads the header, the LASzip VLR and the chunk table. Warnings are in <see
        /// cref="PointReader.Info"/>.</summary>
        /// <param name="longChunkPoints">Points up to which a chunk is one block.</param>
        /// <exception cref="PointCloudException">The points cannot be told apart, or are coded in a way that is not
        /// known.</exception>
        public static PointReader Open(LasFile las, FileSource source, int longChunkPoints = MaxBlockPoints)
        {
            var format = LazFormat.Read(las);
            format.AddFacts(las.Info);
            return format.Compressor == LazCompressor.None
                ? LasReader.OpenUncompressed(las, source)
                : new LazReader(las, format, source, longChunkPoints);
        }

        /// <summary>Byte of the file at which the chunk begins that a block is of.</summary>
        public long OffsetOfBlock(int block) => ChunkOf(Block(block)).Offset;

        public override bool BlocksAreKnown => m_areBlocksKnown;

        /// <summary>Not those of layered files, whose chunks say how long they are: all are soon found.</summary>
        public override bool HasPrefixes => !m_areBlocksKnown && !Format.IsLayered;

        /// <summary>Points of a long chunk's beginning, which takes no checkpoint; the first chunks of a file without a table are
        /// found up to as many: about 50 ms of decoding.</summary>
        internal int PrefixPoints => Math.Min(LongChunkPoints, MaxPrefixPoints);

        public override IEnumerator<Work> FindPrefixes()
        {
            if (!HasPrefixes)
                yield break;
            Forget();
            if (m_isTableLost)
            {
                yield return Work.Of(new LazWalk(this, Source, m_checkpoints).WalkPrefix(Chunks));
                Source.Dispose();
            }
            for (int c = 0; c < Chunks.Count; c++)
            {
                bool isLong = Chunks[c].Points > LongChunkPoints;
                AddBlock(c, 0, isLong ? PrefixPoints : Chunks[c].Points, Chunks[c].Offset + Chunks[c].Bytes, !isLong, -1);
            }
        }

        public override IEnumerator<Work> FindBlocks()
        {
            if (m_areBlocksKnown)
                yield break;
            Forget();
            var walk = new LazWalk(this, Source, m_checkpoints);
            try
            {
                yield return Work.Of(walk.Run(Chunks, m_isTableLost));
            }
            finally
            {
                Source.Dispose();
            }
            MakeBlocks(walk);
            Source.Dispose();
            m_areBlocksKnown = true;
        }

        /// <summary>Drops what an earlier look at the file's beginning, or one that was cancelled, has found.</summary>
        void Forget()
        {
            ClearBlocks();
            DropCheckpoints();
            if (m_isTableLost)
                Chunks.Clear();
        }

        public override void DisposeUnread() => DropCheckpoints();

        void DropCheckpoints()
        {
            foreach (var checkpoint in m_checkpoints)
                checkpoint.Dispose();
            m_checkpoints.Clear();
        }

        internal override LazCheckpoint CheckpointOf(LazBlock block) =>
            block.Checkpoint < 0 ? null : m_checkpoints[block.Checkpoint];

        /// <returns>Whether the table that says where they are is lost.</returns>
        bool FindChunks()
        {
            long start = Header.PointsOffset;
            bool isLost = false;
            if (Format.Compressor == LazCompressor.Pointwise)
            {
                long bytes = Math.Max(0, Source.Length - start);
                if (bytes >= Info.RecordBytes && Info.PointsClaimed > 0)
                    Chunks.Add(new LazChunk
                    {
                        Offset = start,
                        Bytes = bytes,
                        Points = (long)Math.Min(Info.PointsClaimed, (ulong)LazChunk.MaxPoints(bytes)),
                    });
            }
            else if (Info.PointsClaimed > 0 || Source.Length > start + LazChunkTable.LeastBytes)
            {
                var table = LazChunkTable.Read(Source, Format, Info, start);
                Chunks = table.Chunks;
                isLost = table.IsLost && (Format.IsLayered || !Format.HasVariableChunks);
            }
            for (int c = 0; Format.IsLayered && Chunks.MaxBytes > MaxLayeredChunkBytes && c < Chunks.Count; c++)
                if (Chunks[c].Bytes > MaxLayeredChunkBytes)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, Info.Path, Chunks[c].Offset, "bytes of a layered chunk",
                        "at most " + NumberText.Of(MaxLayeredChunkBytes), Chunks[c].Bytes);
            if (Chunks.Count == 0 && !isLost && Info.PointsClaimed > 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, start, "the header claims "
                    + NumberText.Of(Info.PointsClaimed) + " points, the file holds none");
            return isLost;
        }

        bool HasLongPointwiseChunk() => !Format.IsLayered && Chunks.MaxPoints > LongChunkPoints;

        void MakeBlocks(LazWalk walk)
        {
            bool areChunks = TryTakeChunksAsBlocks();
            for (int c = 0; c < Chunks.Count && !areChunks; c++)
                if (Format.IsLayered || Chunks[c].Points <= LongChunkPoints)
                    AddBlocksOf(c);
                else
                    AddPartsByCheckpoints(c, walk.CheckpointsOf(c));
            Info.PointsReadable = PointCount;
            CheckBounds();
        }

        /// <summary>Blocks between the checkpoints of a long chunk; those that lost their state start from an earlier
        /// one.</summary>
        void AddPartsByCheckpoints(int c, BlockRange checkpoints)
        {
            var chunk = Chunks[c];
            int withState = -1;
            long at = 0, end;
            for (int i = 0; i <= checkpoints.Count; i++, at = end)
            {
                bool isLast = i == checkpoints.Count;
                int next = checkpoints.First + i;
                end = isLast ? chunk.Points : m_checkpoints[next].Point;
                long endOffset = isLast ? chunk.Offset + chunk.Bytes : m_checkpoints[next].FileOffset;
                AddBlock(c, at, end - at, endOffset, isLast, withState);
                if (!isLast && m_checkpoints[next].HasState)
                    withState = next;
            }
        }
    }
}
