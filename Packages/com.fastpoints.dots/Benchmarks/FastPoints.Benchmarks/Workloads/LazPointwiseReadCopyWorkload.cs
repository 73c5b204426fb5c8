namespace FastPoints.Benchmarks
{
    /// <summary>The pointwise LAZ file read, and as many bytes copied as its records have, on one thread: the limit of decoding
    /// it.</summary>
    public struct LazPointwiseReadCopyWorkload : IWorkload
    {
        const int BufferBytes = 1 << 20;

        string m_path;
        byte[] m_from;
        byte[] m_to;

        public string Name => "laz pointwise read and copy";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = LazBenchmarkFile.Find(context, LazBenchmarkFile.Pointwise);
            m_from = new byte[BufferBytes];
            m_to = new byte[BufferBytes];
            Run();
        }

        public WorkloadResult Run() => LazBenchmarkFile.ReadAndCopy(m_path, m_from, m_to);

        public void Dispose()
        {
        }
    }
}
