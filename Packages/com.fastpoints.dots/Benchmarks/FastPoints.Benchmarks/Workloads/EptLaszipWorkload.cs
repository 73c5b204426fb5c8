namespace FastPoints.Benchmarks
{
    /// <summary>An EPT octree of LAZ nodes, all attributes, its hierarchy included, to columns.</summary>
    public struct EptLaszipWorkload : IWorkload
    {
        string m_path;

        public string Name => "ept laszip";
        public string LimitName => "ept laszip read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = EptBenchmarkFolder.Make(context, true);
            Run();
        }

        public WorkloadResult Run() => OctreeBenchmark.Decode(m_path);

        public void Dispose()
        {
        }
    }
}
