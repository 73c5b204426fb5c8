using System;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    // Potree 1 BIN and Potree 2 DEFAULT.
    sealed class PotreeRecordRead : PotreeRead
    {
        // About a millisecond of decoding.
        const int SlicePoints = 1 << 17;

        readonly PotreeSpecialColumns m_special;
        NativeArray<FieldCopy> m_copies;

        public PotreeRecordRead(PotreeNodeReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, (long)capacity * reader.Layout.RecordBytes, allocator)
        {
            m_special = PotreeSpecialColumns.Of(reader.Layout, Points);
            m_copies = new NativeArray<FieldCopy>(PlanCopies(attribute => !attribute.IsPackedNormal, 0), allocator);
        }

        protected override JobHandle Schedule(BlockRange range, in PotreeBlock block)
        {
            int recordBytes = Reader.Layout.RecordBytes;
            var decoded = DependencyOf(Reader.BeginRead(File, range.Block, block.Offset + (long)range.First * recordBytes,
                range.Count * recordBytes));
            var decode = new DecodePotreeJob
            {
                Records = File.Buffer,
                Copies = m_copies,
                Columns = Points.Bytes,
                Result = Result,
                Special = m_special,
                RecordBytes = recordBytes,
                Shift = Reader.ShiftOf(range.Block),
            };
            for (int first = 0; first < range.Count; first += SlicePoints)
            {
                decode.First = first;
                decode.Count = Math.Min(SlicePoints, range.Count - first);
                decoded = decode.Schedule(decoded);
            }
            return decoded;
        }

        protected override void DisposeTables() => m_copies.Dispose();
    }
}
