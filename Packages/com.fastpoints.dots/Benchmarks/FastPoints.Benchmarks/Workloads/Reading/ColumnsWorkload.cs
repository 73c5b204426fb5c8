using System;
using FastPoints.Reading;
using FastPoints.Sources;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    sealed class ColumnsWorkload : IWorkload
    {
        sealed class Counter : IBlockConsumer
        {
            public long Points;

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => decoded;

            public void Completed(BlockRead read, int slot) => Points += read.Points.Count;
        }

        readonly Func<WorkloadContext, string> m_find;
        readonly Func<PointSchema, PointSchema> m_wanted;
        readonly bool m_isByWorkers;
        string m_path;

        /// <param name="find">The path; null if there is none.</param>
        /// <param name="wanted">The attributes; null for all.</param>
        /// <param name="isByWorkers">The main thread only steps the work, as beside frames.</param>
        public ColumnsWorkload(string name, string limitName, Func<WorkloadContext, string> find,
            Func<PointSchema, PointSchema> wanted = null, bool isByWorkers = false)
        {
            (Name, LimitName, m_isByWorkers) = (name, limitName, isByWorkers);
            (m_find, m_wanted) = (find, wanted ?? (schema => schema));
        }

        public string Name { get; }
        public string LimitName { get; }

        public void Prepare(WorkloadContext context)
        {
            m_path = m_find(context);
            Run();
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            var counter = new Counter();
            using var reader = PointReaders.Open(m_path);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            using var frames = new FrameLoop(0, Math.Max(m_isByWorkers ? 1 : 0, JobsUtility.JobWorkerCount));
            frames.Run(SourceScan.Run(reader, m_wanted(reader.Info.Schema), counter, SourceScan.DefaultSlots, null),
                m_isByWorkers ? 0 : -1);
            return new WorkloadResult { Points = counter.Points, Bytes = ReadCopyWorkload.BytesOf(m_path) };
        }

        public void Dispose() { }
    }
}
