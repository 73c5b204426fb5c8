using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    /// <summary>Copies a slice of records in the schema's layout to columns.</summary>
    [BurstCompile]
    unsafe struct DecodeEptJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;

        /// <summary>The outcome of making the records; if broken, there are none.</summary>
        [ReadOnly] public NativeReference<DecompressState> State;

        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public int RecordBytes;

        /// <summary>Index of the slice's first record.</summary>
        public int FirstRecord;

        /// <summary>First point of the slice, counted from the range's start.</summary>
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

    /// <summary>What the decoding jobs of EPT report in <see cref="DecodeResult.Error"/>.</summary>
    static class EptError
    {
        /// <summary>The stream broke off, or is invalid.</summary>
        public const int Broken = 1;
    }
}
