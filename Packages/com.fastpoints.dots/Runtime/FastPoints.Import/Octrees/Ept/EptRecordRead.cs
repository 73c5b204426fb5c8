using System;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    sealed class EptRecordRead : EptRead
    {
        // About a millisecond of copying.
        const int SlicePoints = 1 << 16;

        readonly int m_recordBytes;
        NativeArray<FieldCopy> m_copies;
        NativeReference<DecompressState> m_state;

        public EptRecordRead(PointReader reader, EptBlocks blocks, EptIndex index, PointSchema wanted, int capacity,
            Allocator allocator)
            : base(reader, blocks, wanted, capacity, allocator)
        {
            m_recordBytes = index.RecordBytes;
            try
            {
                m_copies = new NativeArray<FieldCopy>(FieldCopyPlan.Make(index.Fields, Points), allocator);
            }
            catch (ArgumentException)
            {
                Dispose();
                throw;
            }
            m_state = new NativeReference<DecompressState>(allocator);
        }

        protected override JobHandle Schedule(BlockRange range, in EptBlock block)
        {
            var decoded = BeginRead(block, (block.FirstInNode + range.First) * m_recordBytes, range.Count * m_recordBytes, 0);
            for (int first = 0; first < range.Count; first += SlicePoints)
                decoded = new DecodeEptJob
                {
                    Records = Input,
                    State = m_state,
                    Copies = m_copies,
                    Columns = Points.Bytes,
                    Result = Result,
                    RecordBytes = m_recordBytes,
                    FirstRecord = first,
                    First = first,
                    Count = Math.Min(SlicePoints, range.Count - first),
                }.Schedule(decoded);
            return decoded;
        }

        protected override void DisposeTables()
        {
            if (m_copies.IsCreated)
                m_copies.Dispose();
            if (m_state.IsCreated)
                m_state.Dispose();
        }
    }
}
