using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Scattered runs of binary PLY records.</summary>
    sealed class PlyRunRead : RunRead
    {
        readonly int m_recordBytes;
        readonly bool m_isBigEndian;
        NativeArray<PlyCopy> m_copies;

        public PlyRunRead(PlyFixedReader reader, PointBatch target, int maxRuns, int maxBytes, Allocator allocator)
            : base(reader, reader.File, reader.OffsetOfPoint(0), target, maxRuns, maxBytes, allocator)
        {
            m_recordBytes = reader.RecordBytes;
            m_isBigEndian = reader.IsBigEndian;
            m_copies = new NativeArray<PlyCopy>(PlyCopy.From(reader.Steps(target)).ToArray(), allocator);
        }

        private protected override JobHandle Schedule(NativeArray<byte> records, NativeArray<RunInBuffer> runs, int runCount,
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
}
