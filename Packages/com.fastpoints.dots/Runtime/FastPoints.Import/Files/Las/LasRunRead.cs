using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Reads scattered runs of plain LAS records.</summary>
    sealed class LasRunRead : RunRead
    {
        readonly int m_recordBytes;
        NativeArray<LasFieldCopy> m_copies;

        public LasRunRead(LasReader reader, PointBatch target, int maxRuns, int maxBytes, Allocator allocator)
            : base(new FixedRecords(reader.Info, reader.File, reader.OffsetOfPoint(0)), target, maxRuns, maxBytes, allocator)
        {
            m_recordBytes = reader.Info.RecordBytes;
            m_copies = new NativeArray<LasFieldCopy>(LasCopyPlan.Make(reader.Layout, target), allocator);
        }

        private protected override JobHandle Schedule(NativeArray<byte> records, NativeArray<BufferedRun> runs, int runCount,
            JobHandle read) =>
            new DecodeLasRunsJob
            {
                Records = records,
                Runs = runs,
                Copies = m_copies,
                RunCount = runCount,
                RecordBytes = m_recordBytes,
                Columns = Target.Bytes,
            }.Schedule(read);

        public override void Dispose()
        {
            base.Dispose();
            if (m_copies.IsCreated)
                m_copies.Dispose();
        }
    }

    /// <summary>Decodes scattered records that a read has brought into memory to their places in a batch.</summary>
    [BurstCompile]
    struct DecodeLasRunsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<BufferedRun> Runs;
        [ReadOnly] public NativeArray<LasFieldCopy> Copies;
        public int RunCount;
        public int RecordBytes;

        // Other slots write to other parts of it at the same time.
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
                LasRecords.ToColumns(records + run.FirstByte, run.StrideBytes, run.Count,
                    (LasFieldCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, columns, run.Place);
            }
        }
    }
}
