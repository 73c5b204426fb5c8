using System;

namespace FastPoints.Reading
{
    // Points have no fixed length: a block is a segment of the file with the points that start in it, read whole for any range.
    internal abstract class SegmentReader : PointReader
    {
        private protected SegmentBlocks Blocks { get; } = new SegmentBlocks();

        public override int BlockCount => Blocks.Count;

        public override int MaxPointsPerBlock => Blocks.Count == 0 ? 0 : Blocks.MaxPoints;

        public override long FirstPointOfBlock(int block) => Blocks[block].FirstPoint;

        public override int PointsInBlock(int block) => Blocks[block].Points;

        public override long PlaceOfBlock(int block) => Blocks[block].OffsetBytes;

        public override long BytesOfRange(BlockRange range) => range.Count == 0 ? 0 : Blocks[range.Block].Bytes;
    }

    sealed class SegmentBlocks
    {
        SegmentBlock[] m_blocks;

        public bool AreFound => m_blocks != null;

        public int Count => Found().Length;

        public int MaxPoints { get; private set; }

        public int MaxBytes { get; private set; }

        public SegmentBlock this[int block] => Found()[block];

        public long Take(SegmentBlock[] blocks)
        {
            m_blocks = blocks;
            MaxPoints = MaxBytes = 0;
            long points = 0;
            foreach (var block in blocks)
            {
                MaxPoints = Math.Max(MaxPoints, block.Points);
                MaxBytes = Math.Max(MaxBytes, block.Bytes);
                points += block.Points;
            }
            return points;
        }

        SegmentBlock[] Found() => m_blocks ?? throw new InvalidOperationException("FindBlocks comes first");
    }

    struct SegmentBlock
    {
        public long OffsetBytes;
        public int Bytes;
        public long FirstPoint;
        public int Points;

        // Of text: lines of the block that belong to what comes before the points.
        public int RowsBefore;

        // Of text: the block starts within a line that belongs to an earlier block.
        public bool StartsInRow;
    }
}
