using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    [BurstCompile]
    unsafe struct DecodeEptJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;

        // Of making the records; if broken, there are none.
        [ReadOnly] public NativeReference<DecompressState> State;

        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public int RecordBytes;
        public int FirstRecord;

        // Counted from the range's start.
        public int First;
        public int Count;

        public void Execute()
        {
            var result = First == 0 ? default : Result.Value;
            if (State.Value.IsBroken)
            {
                if (result.Error == 0)
                {
                    result.Error = EptError.Broken;
                    result.ErrorOffset = State.Value.Consumed;
                }
            }
            else
            {
                byte* records = (byte*)Records.GetUnsafeReadOnlyPtr() + (long)FirstRecord * RecordBytes;
                PointRecords.ToColumns(records, RecordBytes, Count, (FieldCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length,
                    (byte*)Columns.GetUnsafePtr(), First);
                result.Points = First + Count;
            }
            Result.Value = result;
        }
    }

    static class EptError
    {
        public const int Broken = 1;
    }
}
