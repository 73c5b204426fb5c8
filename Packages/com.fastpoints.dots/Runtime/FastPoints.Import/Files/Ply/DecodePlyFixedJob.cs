using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Records of one length into columns. See <see cref="PlyRecords"/>.</summary>
    [BurstCompile]
    unsafe struct DecodePlyFixedJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input;
        [ReadOnly] public NativeArray<PlyCopy> Copies;
        public int RecordBytes;
        public int Points;
        public bool IsBigEndian;
        [WriteOnly] public NativeArray<byte> Output;
        [WriteOnly] public NativeReference<DecodeResult> Result;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* output = (byte*)Output.GetUnsafePtr();
            PlyRecords.ToColumns(input, RecordBytes, Points, (PlyCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, IsBigEndian,
                output);
            Result.Value = new DecodeResult { Points = Points };
        }
    }
}
