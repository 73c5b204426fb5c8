using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>A slot for nodes that are LAS or LAZ files: the file is read whole, then a chain of slices decodes it as far as
    /// the range goes, to the cloud's grid.</summary>
    sealed class PotreeLasRead : BlockRead
    {
        readonly Potree1Reader m_reader;
        readonly Allocator m_allocator;
        readonly LazFileDecoding m_decoding;
        NativeReference<DecodeResult> m_result;
        NativeFileRead m_file;
        int m_fileCapacity;
        bool m_isBusy;
        bool m_isDisposed;

        public PotreeLasRead(Potree1Reader reader, PointSchema wanted, int capacity, Allocator allocator)
        {
            m_reader = reader;
            m_allocator = allocator;
            Points = new PointBatch(wanted, capacity, allocator);
            try
            {
                m_decoding = new LazFileDecoding(reader.Las, reader.Laz, Points, allocator);
            }
            catch (ArgumentException)
            {
                Points.Dispose();
                throw;
            }
            m_result = new NativeReference<DecodeResult>(allocator);
            Result = m_result;
        }

        public override void Begin(BlockRange range)
        {
            if (m_isBusy)
                throw new InvalidOperationException("the slot is still reading; Complete it first");
            m_reader.CheckRange(range, Points.Capacity);
            Range = range;
            FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
            Points.Count = 0;
            m_result.Value = default;
            m_isBusy = true;
            Decoded = range.Count == 0 ? default : Schedule(range, (int)m_reader.Block(range.Block).Bytes);
        }

        public override void Complete()
        {
            if (!m_isBusy)
                throw new InvalidOperationException("the slot has no range in flight");
            m_isBusy = false;
            Decoded.Complete();
            m_file?.End();
            Points.Count = m_result.Value.Points;
            Warn(m_result.Value);
        }

        public override void Dispose()
        {
            if (m_isDisposed)
                return;
            m_isDisposed = true;
            m_isBusy = false;
            Decoded.Complete();
            m_file?.Dispose();
            m_decoding.Dispose();
            Points.Dispose();
            m_result.Dispose();
        }

        JobHandle Schedule(BlockRange range, int bytes)
        {
            if (m_file == null || m_fileCapacity < bytes + RangeCode.PaddingBytes)
            {
                m_file?.Dispose();
                m_fileCapacity = bytes + RangeCode.PaddingBytes;
                m_file = new NativeFileRead(m_reader.Info.Path, default, m_fileCapacity, m_allocator);
            }
            var read = m_file.Begin(m_reader.PathOf(range.Block), 0, bytes);
            return m_decoding.Schedule(m_file.Buffer, bytes, range.First, range.Count, true, Points, m_result, read);
        }

        void Warn(DecodeResult result)
        {
            if (result.Error == LazError.NoChunk)
                m_reader.WarnBroken(Range.Block, "its file is not what the other nodes' are: its points are left out",
                    "wanted point format " + m_reader.Las.Header.PointFormat + " in records of " +
                    m_reader.Las.Header.RecordBytes + " bytes, " + (m_reader.Laz == null ? "LAS" : "LAZ"), 0);
            else if (result.Error == LazError.OffGrid)
                m_reader.WarnBroken(Range.Block, "its positions do not lie on the cloud's grid: they are left out from there",
                    "wanted its scale, and places within 32 bits", result.ErrorOffset);
            else if (result.Error != LazError.None)
                m_reader.WarnBroken(Range.Block, "its file breaks off", "wanted " + Range.Count + " points, got " + result.Points,
                    result.ErrorOffset);
        }
    }
}
