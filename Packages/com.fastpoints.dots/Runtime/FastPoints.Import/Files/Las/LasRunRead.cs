using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Scattered runs of plain LAS records.</summary>
    sealed class LasRunRead : RunRead
    {
        readonly int m_recordBytes;
        NativeArray<LasFieldCopy> m_copies;

        public LasRunRead(LasReader reader, PointBatch target, int maxRuns, int maxBytes, Allocator allocator)
            : base(reader, reader.File, reader.OffsetOfPoint(0), target, maxRuns, maxBytes, allocator)
        {
            m_recordBytes = reader.Info.RecordBytes;
            m_copies = new NativeArray<LasFieldCopy>(LasCopyPlan.Make(reader.Layout, target), allocator);
        }

        private protected override JobHandle Schedule(NativeArray<byte> records, NativeArray<RunInBuffer> runs, int runCount,
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
}
