using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>A slot for nodes that are LAZ files: the file is read whole, then a chain of slices decodes it as far as the
    /// range goes.</summary>
    sealed class EptLazRead : EptRead
    {
        readonly LazFileDecoding m_decoding;

        public EptLazRead(EptReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            try
            {
                m_decoding = new LazFileDecoding(reader.Las, reader.Laz, Points, allocator);
            }
            catch (ArgumentException)
            {
                Dispose();
                throw;
            }
        }

        protected override JobHandle Schedule(BlockRange range, in EptBlock block)
        {
            var read = BeginRead(block, 0, (int)block.FileBytes, RangeCode.PaddingBytes);
            return m_decoding.Schedule(Input, (int)block.FileBytes, block.FirstInNode + range.First, range.Count, false, Points,
                Result, read);
        }

        protected override void WarnBroken(DecodeResult result)
        {
            if (result.Error == LazError.NoChunk)
                Reader.WarnBroken(Range.Block, "its file is not what the other nodes' are: its points are left out",
                    "wanted LAZ of point format " + Reader.Las.Header.PointFormat + " with the items of the root", 0);
            else if (result.Error == LazError.OffGrid)
                Reader.WarnBroken(Range.Block, "its positions do not lie on the root's grid: they are left out from there",
                    "wanted scale and offset that are whole steps of the root's, and places within 32 bits; read "
                    + result.Points + " points of " + Range.Count, result.ErrorOffset);
            else if (result.Error != LazError.None)
                Reader.WarnBroken(Range.Block, "its file breaks off", "wanted " + Range.Count + " points, got " + result.Points,
                    result.ErrorOffset);
            else if (m_decoding.PointsInFile != Reader.Block(Range.Block).NodePoints)
                Reader.WarnBroken(Range.Block, "its file has another number of points than the hierarchy claims",
                    m_decoding.PointsInFile + " in the file, " + Reader.Block(Range.Block).NodePoints + " claimed", -1);
        }

        protected override void DisposeTables() => m_decoding?.Dispose();
    }
}
