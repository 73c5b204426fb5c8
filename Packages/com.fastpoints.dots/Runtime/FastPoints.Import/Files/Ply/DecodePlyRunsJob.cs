using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Scattered records that a read has brought into memory, to their places in a batch.</summary>
    [BurstCompile]
    struct DecodePlyRunsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<RunInBuffer> Runs;
        [ReadOnly] public NativeArray<PlyCopy> Copies;
        public int RunCount;
        public int RecordBytes;
        public bool IsBigEndian;

        // Other slots write other places of it at the same time.
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Columns;

        public unsafe void Execute()
        {
            byte* records = (byte*)Records.GetUnsafeReadOnlyPtr();
            byte* columns = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Columns);
            for (int i = 0; i < RunCount; i++)
            {
                var run = Runs[i];
                if (run.FirstByte + (run.Count - 1L) * run.StrideBytes + RecordBytes > Records.Length)
                    return;
                PlyRecords.ToColumns(records + run.FirstByte, run.StrideBytes, run.Count,
                    (PlyCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, IsBigEndian, columns, run.Place);
            }
        }
    }
}
