using System;
using FastPoints.Files;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>Records in memory to position and colour columns by <see cref="DecodeLasJob"/>, block by block.</summary>
    public struct LasDecodeWorkload : IWorkload
    {
        const int Blocks = 128;

        NativeArray<byte> m_records;
        NativeArray<LasFieldCopy> m_copies;
        NativeReference<DecodeResult> m_result;
        PointBatch m_batch;

        public string Name => "las decode";
        public string LimitName => "las decode by pointers";

        public void Prepare(WorkloadContext context)
        {
            var layout = new LasRecordLayout(LasPointFormat.Of(LasBenchmarkFile.PointFormat), LasBenchmarkFile.RecordBytes,
                Array.Empty<LasField>());
            m_batch = new PointBatch(LasBenchmarkFile.Wanted(layout.Schema), LasBenchmarkFile.BlockPoints, Allocator.Persistent);
            m_copies = new NativeArray<LasFieldCopy>(LasCopyPlan.Make(layout, m_batch), Allocator.Persistent);
            m_records = new NativeArray<byte>(LasBenchmarkFile.BlockPoints * LasBenchmarkFile.RecordBytes, Allocator.Persistent);
            m_result = new NativeReference<DecodeResult>(Allocator.Persistent);
            Run();
        }

        public WorkloadResult Run()
        {
            for (int i = 0; i < Blocks; i++)
                new DecodeLasJob
                {
                    Records = m_records,
                    Copies = m_copies,
                    Columns = m_batch.Bytes,
                    Result = m_result,
                    RecordBytes = LasBenchmarkFile.RecordBytes,
                    Count = LasBenchmarkFile.BlockPoints,
                }.Run();
            return new WorkloadResult
            {
                Points = (long)Blocks * LasBenchmarkFile.BlockPoints,
                Bytes = (long)Blocks * m_records.Length,
            };
        }

        public void Dispose()
        {
            if (!m_records.IsCreated)
                return;
            m_batch.Dispose();
            m_copies.Dispose();
            m_records.Dispose();
            m_result.Dispose();
        }
    }
}
