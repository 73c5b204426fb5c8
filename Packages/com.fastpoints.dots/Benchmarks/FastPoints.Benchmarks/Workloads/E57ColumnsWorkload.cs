using FastPoints.Base;
using FastPoints.Files;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>An E57 file, all fields, to columns: its walk, checksums and invalid points included.</summary>
    public struct E57ColumnsWorkload : IWorkload
    {
        sealed class Consumer : IBlockConsumer
        {
            public long Points;

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => decoded;

            public void Completed(BlockRead read, int slot) => Points += read.Points.Count;
        }

        string m_path;

        public string Name => "e57 columns";
        public string LimitName => "e57 read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = E57BenchmarkFile.Make(context);
            Run();
        }

        public WorkloadResult Run()
        {
            var consumer = new Consumer();
            using (var reader = E57Reader.Open(m_path))
            {
                WorkPump.RunToEnd(reader.FindBlocks());
                WorkPump.RunToEnd(SourceScan.Run(reader, reader.Info.Schema, consumer, SourceScan.DefaultSlots, null));
                return new WorkloadResult { Points = consumer.Points, Bytes = reader.Info.FileBytes };
            }
        }

        public void Dispose()
        {
        }
    }
}
