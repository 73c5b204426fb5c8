namespace FastPoints.Benchmarks
{
    /// <summary>A Potree 2 sample of encoding BROTLI to columns; no points where the sample collection is absent.</summary>
    public struct PotreeBrotliWorkload : IWorkload
    {
        string m_path;

        public string Name => "potree brotli";
        public string LimitName => "potree brotli read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = OctreeBenchmark.FindSample(context, "potree", "v2-autzen-brotli");
            Run();
        }

        public WorkloadResult Run() => OctreeBenchmark.Decode(m_path);

        public void Dispose()
        {
        }
    }
}
