using System;
using FastPoints.Core;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    sealed class PotreeLasRead : SlotRead
    {
        readonly PotreeReader m_reader;
        readonly (LasFile Las, LazFormat Laz) m_like;
        readonly LazFileDecoding m_decoding;
        readonly NativeFileRead m_file;

        public PotreeLasRead(PotreeReader reader, (LasFile Las, LazFormat Laz) like, PointSchema wanted, int capacity,
            Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            m_like = like;
            m_file = new NativeFileRead(0, allocator);
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

        protected override JobHandle Schedule(BlockRange range)
        {
            int bytes = (int)m_reader.Block(range.Block).Bytes;
            m_file.Reserve((long)bytes + RangeCode.PaddingBytes);
            var read = DependencyOf(m_file.Begin(m_reader.FileOfBlock(range.Block, out _), 0, bytes));
            return m_decoding.Schedule(m_file.Buffer, bytes, range.First, range.Count, true, Points, Result, read);
        }

        protected override void EndRead() => m_file.End();

        protected override void DisposeMemory()
        {
            m_file.Dispose();
            m_decoding?.Dispose();
        }

        protected override void Warn(DecodeResult result)
        {
            if (result.Error == LazError.NoChunk)
                m_reader.WarnBroken(Range.Block, "its file is not what the other nodes' are: its points are left out",
                    "wanted point format " + m_like.Las.Header.PointFormat + " in records of " +
                    m_like.Las.Header.RecordBytes + " bytes, " + (m_like.Laz == null ? "LAS" : "LAZ"), 0);
            else if (result.Error == LazError.OffGrid)
                m_reader.WarnBroken(Range.Block, "its positions do not lie on the cloud's grid: they are left out from there",
                    "wanted its scale, and places within 32 bits", result.ErrorOffset);
            else if (result.Error != LazError.None)
                m_reader.WarnBroken(Range.Block, "its file breaks off", "wanted " + Range.Count + " points, got " + result.Points,
                    result.ErrorOffset);
        }
    }
}
