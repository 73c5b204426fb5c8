using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>A file or a folder to columns, through its reader and all workers, from opening it on; finding the points is part
    /// of it. Without a file it does nothing, and reports no points.</summary>
    public abstract class ColumnsWorkload : IWorkload
    {
        sealed class Counter : IBlockConsumer
        {
            public long Points;

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => decoded;

            public void Completed(BlockRead read, int slot) => Points += read.Points.Count;
        }

        string m_path;

        protected ColumnsWorkload(string name, string limitName)
        {
            Name = name;
            LimitName = limitName;
        }

        public string Name { get; }
        public string LimitName { get; }

        public void Prepare(WorkloadContext context)
        {
            m_path = Find(context);
            Run();
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            var counter = new Counter();
            using (var reader = PointReaders.Open(m_path))
            {
                WorkPump.RunToEnd(reader.FindBlocks());
                WorkPump.RunToEnd(SourceScan.Run(reader, Wanted(reader.Info.Schema), counter, SourceScan.DefaultSlots, null));
            }
            return new WorkloadResult { Points = counter.Points, Bytes = ReadCopyWorkload.BytesOf(m_path) };
        }

        public void Dispose()
        {
        }

        /// <returns>The path; null where there is none.</returns>
        protected abstract string Find(WorkloadContext context);

        /// <summary>All attributes, unless said otherwise.</summary>
        protected virtual PointSchema Wanted(PointSchema schema) => schema;
    }

    /// <summary>Position and colour of a LAS file.</summary>
    public sealed class LasColumnsWorkload : ColumnsWorkload
    {
        public LasColumnsWorkload() : base("las columns", "las read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => LasBenchmarkFile.Make(context);

        protected override PointSchema Wanted(PointSchema schema) => LasBenchmarkFile.Wanted(schema);
    }
}
