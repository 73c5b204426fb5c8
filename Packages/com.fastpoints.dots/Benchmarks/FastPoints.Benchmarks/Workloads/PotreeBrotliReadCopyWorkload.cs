namespace FastPoints.Benchmarks
{
    /// <summary>The files of <see cref="PotreeBrotliWorkload"/> read, and as many bytes copied as their columns
    /// have, on one thread.</summary>
    public struct PotreeBrotliReadCopyWorkload : IWorkload
    {
        const int BufferBytes = 1 << 20;

        string m_path;
        byte[] m_from;
        byte[] m_to;

        public string Name => "potree brotli read and copy";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = OctreeBenchmark.FindSample(context, "potree", "v2-autzen-brotli");
            m_from = new byte[BufferBytes];
            m_to = new byte[BufferBytes];
            Run();
        }

        public WorkloadResult Run() => OctreeBenchmark.ReadAndCopy(m_path, m_from, m_to);

        public void Dispose()
        {
        }
    }
}
