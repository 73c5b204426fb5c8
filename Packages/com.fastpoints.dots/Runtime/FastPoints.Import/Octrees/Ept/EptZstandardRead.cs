using System;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    sealed class EptZstandardRead : EptRead
    {
        // Less than a millisecond of decompression.
        const int TileBytes = 256 << 10;

        readonly int m_tilePoints;
        readonly DecompressorHandle m_decompressor;
        readonly int m_recordBytes;
        NativeArray<FieldCopy> m_copies;
        NativeArray<byte> m_tile;
        NativeReference<DecompressState> m_state;

        public EptZstandardRead(PointReader reader, EptBlocks blocks, EptIndex index, PointSchema wanted, int capacity,
            Allocator allocator)
            : base(reader, blocks, wanted, capacity, allocator)
        {
            m_recordBytes = index.RecordBytes;
            try
            {
                m_copies = new NativeArray<FieldCopy>(FieldCopyPlan.Make(index.Fields, Points), allocator);
                m_decompressor = new DecompressorHandle(Decompressors.Zstandard());
            }
            catch
            {
                Dispose();
                throw;
            }
            m_tilePoints = Math.Max(1, TileBytes / m_recordBytes);
            m_tile = new NativeArray<byte>(m_tilePoints * m_recordBytes, allocator, NativeArrayOptions.UninitializedMemory);
            m_state = new NativeReference<DecompressState>(allocator);
        }

        protected override JobHandle Schedule(BlockRange range, in EptBlock block)
        {
            long begin = block.FirstInNode + range.First, end = begin + range.Count;
            var decoded = BeginRead(block, 0, (int)block.FileBytes, 0);
            for (long first = 0; first < end; first += m_tilePoints)
            {
                int count = (int)Math.Min(m_tilePoints, end - first);
                decoded = new DecompressJob
                {
                    Input = Input,
                    InputBytes = (int)block.FileBytes,
                    Output = m_tile,
                    Wanted = count * m_recordBytes,
                    IsFirst = first == 0,
                    Slot = m_decompressor.Handle,
                    State = m_state,
                }.Schedule(decoded);
                long from = Math.Max(first, begin);
                if (from < first + count)
                    decoded = new DecodeEptJob
                    {
                        Records = m_tile,
                        State = m_state,
                        Copies = m_copies,
                        Columns = Points.Bytes,
                        Result = Result,
                        RecordBytes = m_recordBytes,
                        FirstRecord = (int)(from - first),
                        First = (int)(from - begin),
                        Count = (int)(first + count - from),
                    }.Schedule(decoded);
            }
            return decoded;
        }

        protected override void WarnBroken(DecodeResult result)
        {
            var failure = m_decompressor.Failure;
            m_decompressor.Failure = null;
            if (result.Error != 0)
                Blocks.WarnBroken(Range.Block, "its zstandard stream is broken: points are left out",
                    "wanted " + Range.Count + " points, got " + result.Points
                        + (failure != null ? " (" + failure.Message + ")" : ""),
                    result.ErrorOffset);
        }

        protected override void DisposeTables()
        {
            m_decompressor?.Dispose();
            if (m_copies.IsCreated)
                m_copies.Dispose();
            if (m_tile.IsCreated)
                m_tile.Dispose();
            if (m_state.IsCreated)
                m_state.Dispose();
        }
    }
}
