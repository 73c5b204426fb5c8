using FastPoints.Sources;

namespace FastPoints.Benchmarks
{
    /// <summary>What comes before the first point of an E57 file: its header, its XML section, and the walk over its packets'
    /// headers.</summary>
    sealed class E57WalkWorkload : IWorkload
    {
        string m_path;

        public string Name => "e57 walk";
        public string LimitName => "e57 read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = E57BenchmarkFile.Make(context);
            Run();
        }

        public WorkloadResult Run()
        {
            using var reader = PointReaders.Open(m_path);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            return new WorkloadResult { Points = reader.PointCount, Bytes = reader.Info.FileBytes };
        }

        public void Dispose() { }
    }
}
