using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    /// <summary>Decodes a slice of a node's records to columns, and moves positions from the node's corner to the
    /// cloud's.</summary>
    [BurstCompile]
    unsafe struct DecodePotreeJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public PotreeSpecialColumns Special;
        public int RecordBytes;

        /// <summary>First point of the slice, counted from the range's start.</summary>
        public int First;
        public int Count;

        /// <summary>From the node's corner to the cloud's, in grid steps.</summary>
        public int3 Shift;

        public void Execute()
        {
            byte* records = (byte*)Records.GetUnsafeReadOnlyPtr() + (long)First * RecordBytes;
            byte* columns = (byte*)Columns.GetUnsafePtr();
            PointRecords.ToColumns(records, RecordBytes, Count, (FieldCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length,
                columns, First);
            var result = First == 0 ? default : Result.Value;
            for (int axis = 0; axis < 3; axis++)
                if (Special.Position[axis] >= 0 && Shift[axis] != 0)
                    result.Error |= Move((int*)(columns + Special.Position[axis]) + First, Count, Shift[axis]);
            if (math.any(Special.Normal >= 0))
                Special.DecodeNormals(records + Special.NormalRecordByte, RecordBytes, Count, columns, First);
            result.Points = First + Count;
            Result.Value = result;
        }

        /// <returns>An error if a position left the grid and was moved to its edge.</returns>
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

    /// <summary>Codes of <see cref="DecodeResult.Error"/>; bits, since several slices have one result.</summary>
    static class PotreeError
    {
        public const int None = 0;

        /// <summary>Positions beyond the 32-bit grid were set to its edge.</summary>
        public const int OffGrid = 1;

        /// <summary>A compressed node broke off, or its decompressor failed.</summary>
        public const int Broken = 2;
    }
}
