using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>A slot for nodes of plain records.</summary>
    sealed class EptRecordRead : EptRead
    {
        /// <summary>A slice takes about a millisecond of copying.</summary>
        const int SlicePoints = 1 << 16;

        NativeArray<LasFieldCopy> m_copies;
        NativeReference<DecompressState> m_state;

        public EptRecordRead(EptReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            try
            {
                m_copies = new NativeArray<LasFieldCopy>(PlanCopies(reader, wanted, Points), allocator);
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
            int recordBytes = Reader.Index.RecordBytes;
            var decoded = BeginRead(block, (block.FirstInNode + range.First) * recordBytes, range.Count * recordBytes, 0);
            for (int first = 0; first < range.Count; first += SlicePoints)
                decoded = new DecodeEptJob
                {
                    Records = Input,
                    State = m_state,
                    Copies = m_copies,
                    Columns = Points.Bytes,
                    Result = Result,
                    RecordBytes = recordBytes,
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
