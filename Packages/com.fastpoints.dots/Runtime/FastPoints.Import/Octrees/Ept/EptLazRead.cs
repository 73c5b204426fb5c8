using System;
using FastPoints.Core;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    sealed class EptLazRead : EptRead
    {
        readonly LasFile m_like;
        readonly LazFileDecoding m_decoding;

        public EptLazRead(PointReader reader, EptBlocks blocks, (LasFile Las, LazFormat Laz) like, PointSchema wanted,
            int capacity, Allocator allocator)
            : base(reader, blocks, wanted, capacity, allocator)
        {
            m_like = like.Las;
            try
            {
                m_decoding = new LazFileDecoding(like.Las, like.Laz, Points, allocator);
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
                Blocks.WarnBroken(Range.Block, "its file is not what the other nodes' are: its points are left out",
                    "wanted LAZ of point format " + m_like.Header.PointFormat + " with the items of the root", 0);
            else if (result.Error == LazError.OffGrid)
                Blocks.WarnBroken(Range.Block, "its positions do not lie on the root's grid: they are left out from there",
                    "wanted scale and offset that are whole steps of the root's, and places within 32 bits; read "
                    + result.Points + " points of " + Range.Count, result.ErrorOffset);
            else if (result.Error != LazError.None)
                Blocks.WarnBroken(Range.Block, "its file breaks off", "wanted " + Range.Count + " points, got " + result.Points,
                    result.ErrorOffset);
            else if (m_decoding.PointsInFile != Blocks[Range.Block].NodePoints)
                Blocks.WarnBroken(Range.Block, "its file has another number of points than the hierarchy claims",
                    m_decoding.PointsInFile + " in the file, " + Blocks[Range.Block].NodePoints + " claimed", -1);
        }

        protected override void DisposeTables() => m_decoding?.Dispose();
    }
}
