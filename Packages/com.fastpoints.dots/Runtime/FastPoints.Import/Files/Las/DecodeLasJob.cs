using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Records that a read has brought into memory, to the columns of a batch. See <see cref="LasRecords"/>.</summary>
    [BurstCompile]
    public struct DecodeLasJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<LasFieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public int RecordBytes;
        public int Count;

        public unsafe void Execute()
        {
            LasRecords.ToColumns((byte*)Records.GetUnsafeReadOnlyPtr(), RecordBytes, Count,
                (LasFieldCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, (byte*)Columns.GetUnsafePtr());
            Result.Value = new DecodeResult { Points = Count };
        }
    }
}
