namespace FastPoints.Benchmarks
{
    /// <summary>An EPT octree of plain records, all attributes, its hierarchy included, to columns.</summary>
    public struct EptBinaryWorkload : IWorkload
    {
        string m_path;

        public string Name => "ept binary";
        public string LimitName => "ept binary read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = EptBenchmarkFolder.Make(context, false);
            Run();
        }

        public WorkloadResult Run() => OctreeBenchmark.Decode(m_path);

        public void Dispose()
        {
        }
    }
}
