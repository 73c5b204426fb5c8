namespace FastPoints.Benchmarks
{
    /// <summary>The files of <see cref="EptLaszipWorkload"/> read, and as many bytes copied as their columns
    /// have, on one thread.</summary>
    public struct EptLaszipReadCopyWorkload : IWorkload
    {
        const int BufferBytes = 1 << 20;

        string m_path;
        byte[] m_from;
        byte[] m_to;

        public string Name => "ept laszip read and copy";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = EptBenchmarkFolder.Make(context, true);
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
