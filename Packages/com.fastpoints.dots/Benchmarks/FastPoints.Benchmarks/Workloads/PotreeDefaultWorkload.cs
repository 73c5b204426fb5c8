namespace FastPoints.Benchmarks
{
    /// <summary>A Potree 2 sample of encoding DEFAULT to columns; no points where the sample collection is absent.</summary>
    public struct PotreeDefaultWorkload : IWorkload
    {
        string m_path;

        public string Name => "potree default";
        public string LimitName => "potree default read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = OctreeBenchmark.FindSample(context, "potree", "v2-mixedconifer-default");
            Run();
        }

        public WorkloadResult Run() => OctreeBenchmark.Decode(m_path);

        public void Dispose()
        {
        }
    }
}
