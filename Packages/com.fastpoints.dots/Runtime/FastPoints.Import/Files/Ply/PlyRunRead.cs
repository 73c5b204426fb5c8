using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Reads scattered runs of binary PLY records.</summary>
    sealed class PlyRunRead : RunRead
    {
        readonly int m_recordBytes;
        readonly bool m_isBigEndian;
        NativeArray<PlyCopy> m_copies;

        public PlyRunRead(PlyFixedReader reader, PointBatch target, int maxRuns, int maxBytes, Allocator allocator)
            : base(new FixedRecords(reader.Info, reader.File, reader.OffsetOfPoint(0)), target, maxRuns, maxBytes, allocator)
        {
            m_recordBytes = reader.RecordBytes;
            m_isBigEndian = reader.IsBigEndian;
            m_copies = new NativeArray<PlyCopy>(PlyCopy.From(reader.Steps(target)).ToArray(), allocator);
        }

        private protected override JobHandle Schedule(NativeArray<byte> records, NativeArray<BufferedRun> runs, int runCount,
            JobHandle read) =>
            new DecodePlyRunsJob
            {
                Records = records,
                Runs = runs,
                Copies = m_copies,
                RunCount = runCount,
                RecordBytes = m_recordBytes,
                IsBigEndian = m_isBigEndian,
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
    struct DecodePlyRunsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<BufferedRun> Runs;
        [ReadOnly] public NativeArray<PlyCopy> Copies;
        public int RunCount;
        public int RecordBytes;
        public bool IsBigEndian;

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
                PlyRecords.ToColumns(records + run.FirstByte, run.StrideBytes, run.Count,
                    (PlyCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, IsBigEndian, columns, run.Place);
            }
        }
    }
}
