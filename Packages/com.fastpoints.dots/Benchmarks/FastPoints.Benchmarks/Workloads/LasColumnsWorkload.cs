using FastPoints.Base;
using FastPoints.Files;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>Position and colour of a LAS file to columns, through the reader and all workers.</summary>
    public struct LasColumnsWorkload : IWorkload
    {
        sealed class Counter : IBlockConsumer
        {
            public long Points;

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => decoded;

            public void Completed(BlockRead read, int slot) => Points += read.Points.Count;
        }

        string m_path;

        public string Name => "las columns";
        public string LimitName => "las read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = LasBenchmarkFile.Make(context);
            Run();
        }

        public WorkloadResult Run()
        {
            var counter = new Counter();
            using (var reader = PointReaders.Open(m_path))
            {
                WorkPump.RunToEnd(SourceScan.Run(reader, LasBenchmarkFile.Wanted(reader.Info.Schema), counter,
                    SourceScan.DefaultSlots, null));
                return new WorkloadResult { Points = counter.Points, Bytes = reader.Info.FileBytes };
            }
        }

        public void Dispose()
        {
        }
    }
}
