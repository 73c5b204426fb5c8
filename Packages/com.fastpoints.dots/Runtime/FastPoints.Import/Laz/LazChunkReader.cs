using System;
using FastPoints.Core;
using FastPoints.Las;
using FastPoints.Octrees;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Laz
{
    // Points in LAZ chunks, listed in a chunk table (LazReader) or in the hierarchy of an octree (CopcReader).
    internal abstract class LazChunkReader : PointReader
    {
        // Of a decoder and its tile.
        internal sealed override long DecoderBytes => 512 << 10;

        // Chunks up to this size are one block, unless their records are long.
        public const int MaxBlockPoints = 1 << 20;

        private protected LazChunkReader(LazBlocks blocks)
        {
            Blocks = blocks;
            Info = blocks.Info;
        }

        private protected LazBlocks Blocks { get; }

        internal sealed override LasFile Las => Blocks.Las;

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

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new LazBlockRead(this, Blocks, wanted, capacity, allocator);

        public override void CloseFile()
        {
            Blocks.Source.Dispose();
            Blocks.File.Close();
        }
    }
}
