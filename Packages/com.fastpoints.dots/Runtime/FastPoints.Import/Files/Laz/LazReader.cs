using System;
using System.Collections.Generic;
using FastPoints.Base;

namespace FastPoints.Files
{
    /// <summary>Reads LAZ: what LASzip 1.x to 3.x write, pointwise or in layers, point formats 0 to 10. Blocks are the file's
    /// chunks; any of them can be decoded on its own, and its first points without the rest.</summary>
    /// <remarks>A chunk of more than <c>MaxBlockPoints</c> points becomes several blocks. In a pointwise chunk each block
    /// starts from a checkpoint, a copy of the decoder's state there, which <see cref="FindBlocks"/> takes by decoding the chunk
    /// once. In a layered chunk each block decodes from the chunk's start (no writer makes such long chunks by
    /// default).</remarks>
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

        /// <summary>Reads the header, the LASzip VLR and the chunk table. Warnings are in
        /// <see cref="PointReader.Info"/>.</summary>
        /// <param name="longChunkPoints">The most points of a chunk that is one block.</param>
        /// <exception cref="PointCloudException">The points cannot be located, or are coded in an unknown way.</exception>
        public static PointReader Open(LasFile las, FileSource source, int longChunkPoints = MaxBlockPoints)
        {
            var format = LazFormat.Read(las);
            format.AddFacts(las.Info);
            return format.Compressor == LazCompressor.None
                ? LasReader.OpenUncompressed(las, source)
                : new LazReader(las, format, source, longChunkPoints);
        }

        /// <summary>Offset in the file of the chunk that a block belongs to.</summary>
        public long OffsetOfBlock(int block) => ChunkOf(Block(block)).Offset;

        public override bool BlocksAreKnown => m_areBlocksKnown;

        /// <summary>False for layered files, whose chunks say how long they are: all are found quickly.</summary>
        public override bool HasPrefixes => !m_areBlocksKnown && !Format.IsLayered;

        /// <summary>Points in the prefix of a long chunk, which takes no checkpoint. Without a table, the first chunks are
        /// searched up to as many points: about 50 ms of decoding.</summary>
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

        /// <summary>Drops what an earlier or cancelled search has found.</summary>
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
                    throw PointCloudException.Wanted(FailureCode.Unsupported, Info.Path, Chunks[c].Offset,
                        "bytes of a layered chunk", "at most " + NumberText.Of(MaxLayeredChunkBytes), Chunks[c].Bytes);
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

        /// <summary>Adds the blocks between the checkpoints of a long chunk; those whose checkpoint lost its state start from an
        /// earlier one.</summary>
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
