using System;
using System.Collections.Generic;

namespace FastPoints.Reading
{
    // Points have no fixed length: a block is a segment of the file with the points that start in it, read whole for any range.
    internal abstract class SegmentReader : PointReader
    {
        private protected SegmentReader(SourceInfo info, SourceHandle file)
        {
            Info = info;
            File = file;
        }

        internal SourceHandle File { get; }

        private protected SegmentBlocks Blocks { get; } = new SegmentBlocks();

        public override int BlockCount => Blocks.Count;
        public override int MaxPointsPerBlock => Blocks.Count == 0 ? 0 : Blocks.MaxPoints;

        public override long FirstPointOfBlock(int block) => Blocks[block].FirstPoint;

        public override int PointsInBlock(int block) => Blocks[block].Points;

        public override long OrderOfBlock(int block) => Blocks[block].OffsetBytes;

        public override long BytesOfRange(BlockRange range) => range.Count == 0 ? 0 : Blocks[range.Block].Bytes;
        private protected virtual int BytesBehindBlock => 0; // Where the last line may end.

        internal override void ListPieces(BlockRange range, List<FilePiece> pieces)
        {
            var block = Blocks[range.Block];
            long bytes = (long)block.Bytes + BytesBehindBlock;
            pieces.Add(new FilePiece { Path = File.Path, OffsetBytes = block.OffsetBytes, LengthBytes = bytes });
        }

        public override void CloseFile() => File.Close();
    }

    // Text with a point on each line: a random offset leads to a random line.
    internal abstract class LineReader : SegmentReader, IPrefixSource
    {
        public const int MaxPrefixes = AsciiSegments.Count;

        readonly long m_dataOffset;
        AsciiSegments m_segments;

        private protected LineReader(SourceInfo info, SourceHandle file, long dataOffset) : base(info, file)
        {
            m_dataOffset = dataOffset;
        }

        private protected bool AreAllFound { get; set; }

        public sealed override bool BlocksAreKnown => AreAllFound;

        public virtual bool HasPrefixes => !AreAllFound && Info.FileBytes - m_dataOffset >= AsciiSegments.MinBytes;

        public PointEstimate EstimatedPoints =>
            Info.HasPointsClaimed ? new PointEstimate(Info.PointsClaimed, 0) : m_segments.Estimate;

        public IEnumerator<JobStep> FindPrefixes(int count)
        {
            m_segments ??= new AsciiSegments(File, Info.FileBytes, m_dataOffset);
            yield return JobStep.Of(m_segments.Find(count));
            Blocks.Set(m_segments.Blocks);
            OnBlocksFound();
        }

        // Blocks that were found before keep their numbers.
        private protected virtual void OnBlocksFound() { }
    }

    sealed class SegmentBlocks
    {
        SegmentBlock[] m_blocks;

        public bool AreFound => m_blocks != null;
        public int Count => FoundBlocks().Length;
        public int MaxPoints { get; private set; }
        public int MaxBytes { get; private set; }

        public SegmentBlock this[int block] => FoundBlocks()[block];

        public long Set(SegmentBlock[] blocks)
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

        SegmentBlock[] FoundBlocks() => m_blocks ?? throw new InvalidOperationException("FindBlocks comes first");
    }

    struct SegmentBlock
    {
        public long OffsetBytes;
        public int Bytes;
        public long FirstPoint;
        public int Points;
        public int RowsBefore; // Text: lines of the block before the points.
        public bool StartsInRow; // Text: the block starts within a line of an earlier block.
    }
}
