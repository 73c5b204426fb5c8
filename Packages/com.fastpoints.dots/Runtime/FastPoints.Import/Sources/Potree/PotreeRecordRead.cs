using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // Potree 1 BIN and Potree 2 DEFAULT.
    sealed class PotreeRecordRead : NodeRead
    {
        const int PointsPerSlice = 1 << 17; // About a millisecond of decoding.

        readonly PotreeReader m_reader;
        readonly PotreeSpecialColumns m_special;
        readonly NativeArray<FieldCopy> m_copies;

        public PotreeRecordRead(PotreeReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            m_special = PotreeSpecialColumns.Of(reader.Layout, Points);
            var copies = reader.Layout.PlanCopies(Points, attribute => !attribute.IsPackedNormal, 0);
            m_copies = Own(new NativeArray<FieldCopy>(copies, allocator));
        }

        protected override JobHandle Schedule(BlockRange range, in NodeBlock block)
        {
            int recordBytes = m_reader.Layout.RecordBytes;
            var decoded = BeginRead(range);
            var decode = new DecodePotreeJob
            {
                Records = FileRead.Buffer,
                Copies = m_copies,
                Columns = Points.Bytes,
                Result = Result,
                Special = m_special,
                RecordBytes = recordBytes,
                Shift = m_reader.ShiftOf(range.Block),
            };
            for (int first = 0; first < range.Count; first += PointsPerSlice)
            {
                decode.First = first;
                decode.Count = Math.Min(PointsPerSlice, range.Count - first);
                decoded = decode.Schedule(decoded);
            }
            return decoded;
        }

        protected override void Report(DecodeResult result)
        {
            if (result.Error != PotreeError.None)
                Reader.WarnBroken(Range.Block, "has positions beyond the 32-bit grid of the cloud: they are at its edge",
                    null, -1);
        }
    }

    // Positions are moved from the node's corner to the cloud's.
    [BurstCompile]
    unsafe struct DecodePotreeJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public PotreeSpecialColumns Special;
        public int RecordBytes;
        public int First;
        public int Count;
        public int3 Shift; // From the node's corner to the cloud's, in grid steps.

        public void Execute()
        {
            byte* records = (byte*)Records.GetUnsafeReadOnlyPtr() + (long)First * RecordBytes;
            byte* columns = (byte*)Columns.GetUnsafePtr();
            PointRecords.ToColumns(records, RecordBytes, Count, Copies, columns, First);
            var result = First == 0 ? default : Result.Value;
            for (int axis = 0; axis < 3; axis++)
                if (Special.PositionOffsets[axis] >= 0 && Shift[axis] != 0)
                    result.Error |= Move((int*)(columns + Special.PositionOffsets[axis]) + First, Count, Shift[axis]);
            if (math.any(Special.NormalOffsets >= 0))
                Special.DecodeNormals(records + Special.NormalRecordByte, RecordBytes, Count, columns, First);
            result.Points = First + Count;
            Result.Value = result;
        }

        // An error if a position left the grid and was moved to its edge.
        public static int Move(int* column, int count, int shift)
        {
            int error = PotreeError.None;
            for (int i = 0; i < count; i++)
            {
                long moved = (long)column[i] + shift;
                if (moved != (int)moved)
                {
                    moved = moved < 0 ? int.MinValue : int.MaxValue;
                    error = PotreeError.OffGrid;
                }
                column[i] = (int)moved;
            }
            return error;
        }
    }

    // Bits, since several slices have one result.
    static class PotreeError
    {
        public const int None = 0;
        public const int OffGrid = 1; // Positions beyond the 32-bit grid were set to its edge.
        public const int Broken = 2; // A compressed node broke off, or its decompressor failed.
    }
}
