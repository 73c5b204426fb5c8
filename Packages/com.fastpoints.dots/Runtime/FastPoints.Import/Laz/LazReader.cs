using System;
using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Laz
{
    // What LASzip 1.x to 3.x write, pointwise or in layers, point formats 0 to 10. A chunk of more than MaxBlockPoints points
    // becomes several blocks. In a pointwise chunk each block starts from a checkpoint, a copy of the decoder's state there,
    // which IndexBlocks takes by decoding the chunk once. In a layered chunk each block decodes from the chunk's start (no writer
    // makes such long chunks by default).
    internal sealed class LazReader : LazChunkReader, IPrefixSource
    {
        LazChunkList Chunks => Blocks.Chunks;

        RandomAccessFile Source => Blocks.Source;

        readonly bool m_isTableLost;
        bool m_areBlocksKnown;

        LazReader(LazBlocks blocks) : base(blocks)
        {
            m_isTableLost = FindChunks();
            m_areBlocksKnown = !m_isTableLost && (Format.IsLayered || Chunks.MaxPoints <= Blocks.LongChunkPoints);
            if (m_areBlocksKnown)
                MakeBlocks(null);
        }

        public static PointReader Open(LasFile las, RandomAccessFile source, int longChunkPoints = MaxBlockPoints)
        {
            var format = LazFormat.Read(las);
            format.AddFacts(las.Info);
            return format.Compressor == LazCompressor.None
                ? LasReader.OpenUncompressed(las, source)
                : new LazReader(new LazBlocks(las, format, source, longChunkPoints));
        }

        public override bool BlocksAreKnown => m_areBlocksKnown;

        // False for layered files, whose chunks say how long they are: all are found quickly.
        public bool HasPrefixes => !m_areBlocksKnown && !Format.IsLayered;

        public PointEstimate EstimatedPoints => new PointEstimate(Info.PointsClaimed, 0);

        // The beginning of the file, however many prefixes are wanted.
        public IEnumerator<JobStep> FindPrefixes(int count)
        {
            if (!HasPrefixes)
                yield break;
            Reset();
            if (m_isTableLost)
            {
                yield return JobStep.Of(new LazWalk(Blocks).WalkPrefix());
                Source.Dispose();
            }
            for (int c = 0; c < Chunks.Count; c++)
            {
                bool isLong = Chunks[c].Points > Blocks.LongChunkPoints;
                Blocks.Add(c, 0, isLong ? LazWalk.PrefixPoints(Blocks) : Chunks[c].Points, Chunks[c].Offset + Chunks[c].Bytes,
                    !isLong, -1);
            }
        }

        public override IEnumerator<JobStep> IndexBlocks()
        {
            if (m_areBlocksKnown)
                yield break;
            Reset();
            var walk = new LazWalk(Blocks);
            using (Source)
                yield return JobStep.Of(walk.Run(m_isTableLost));
            MakeBlocks(walk);
            // Checking the bounds has opened it again.
            Source.Dispose();
            m_areBlocksKnown = true;
        }

        void Reset()
        {
            Blocks.Clear();
            Blocks.DropCheckpoints();
            if (m_isTableLost)
                Chunks.Clear();
        }

        public override void DisposeUnread() => Blocks.DropCheckpoints();

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
            else if (Info.PointsClaimed > 0 || Source.Length > start + LazChunkTable.MinBytes)
            {
                var table = LazChunkTable.Read(Source, Format, Info, start);
                Blocks.Chunks = table.Chunks;
                isLost = table.IsLost && (Format.IsLayered || !Format.HasVariableChunks);
            }
            for (int c = 0; Format.IsLayered && Chunks.MaxBytes > LazBlocks.MaxLayeredChunkBytes && c < Chunks.Count; c++)
                if (Chunks[c].Bytes > LazBlocks.MaxLayeredChunkBytes)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, Info.Path, Chunks[c].Offset,
                        "bytes of a layered chunk", "at most " + NumberText.Of(LazBlocks.MaxLayeredChunkBytes), Chunks[c].Bytes);
            if (Chunks.Count == 0 && !isLost && Info.PointsClaimed > 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, start, "the header claims "
                    + NumberText.Of(Info.PointsClaimed) + " points, the file holds none");
            return isLost;
        }

        void MakeBlocks(LazWalk walk)
        {
            bool areChunks = Blocks.TryUseChunks();
            for (int c = 0; c < Chunks.Count && !areChunks; c++)
                if (Format.IsLayered || Chunks[c].Points <= Blocks.LongChunkPoints)
                    Blocks.AddChunk(c);
                else
                    AddPartsByCheckpoints(c, walk.CheckpointsOf(c));
            Info.PointsReadable = PointCount;
            Blocks.CheckBounds();
        }

        // Between the checkpoints of a long chunk; blocks whose checkpoint lost its state start from an earlier one.
        void AddPartsByCheckpoints(int c, BlockRange checkpoints)
        {
            var chunk = Chunks[c];
            int withState = -1;
            long at = 0, end;
            for (int i = 0; i <= checkpoints.Count; i++, at = end)
            {
                bool isLast = i == checkpoints.Count;
                int next = checkpoints.First + i;
                end = isLast ? chunk.Points : Blocks.Checkpoints[next].Point;
                long endOffset = isLast ? chunk.Offset + chunk.Bytes : Blocks.Checkpoints[next].FileOffset;
                Blocks.Add(c, at, end - at, endOffset, isLast, withState);
                if (!isLast && Blocks.Checkpoints[next].HasState)
                    withState = next;
            }
        }
    }

    // Points in LAZ chunks, listed in a chunk table (LazReader) or in the hierarchy of an octree (CopcReader).
    internal abstract class LazChunkReader : PointReader, ILasSource
    {
        internal sealed override long DecoderBytes => 512 << 10;
        public const int MaxBlockPoints = 1 << 20; // Chunks up to this size are one block, unless their records are long.

        private protected LazChunkReader(LazBlocks blocks)
        {
            Blocks = blocks;
            Info = blocks.Info;
        }

        private protected LazBlocks Blocks { get; }

        LasFile ILasSource.Las => Blocks.Las;

        public LasHeader Header => Blocks.Las.Header;
        public LazFormat Format => Blocks.Format;

        public override int BlockCount => Blocks.Count;
        public override int MaxPointsPerBlock => Blocks.MaxPoints;

        public override long FirstPointOfBlock(int block) => Blocks.FirstPointOf(block);

        public override int PointsInBlock(int block) => Blocks.PointsOf(block);

        public override string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = Blocks.ChunkOf(Blocks[block]).Offset;
            return Info.Path;
        }

        // Estimates by the block's share of its chunk; unwanted layers are not deducted.
        public override long BytesOfRange(BlockRange range)
        {
            var block = Blocks[range.Block];
            var chunk = Blocks.ChunkOf(block);
            long ofBlock = (long)(chunk.Bytes * (block.Points / (double)Math.Max(1, chunk.Points)));
            return Math.Min(chunk.Bytes, (long)(ofBlock * ((range.First + range.Count) / (double)Math.Max(1, block.Points))));
        }

        internal override void ListPieces(BlockRange range, List<FilePiece> pieces) => pieces.Add(Blocks.PieceOf(range));

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new LazBlockRead(this, Blocks, wanted, capacity, allocator);

        public override void CloseFile()
        {
            Blocks.Source.Dispose();
            Blocks.File.Close();
        }
    }
}
