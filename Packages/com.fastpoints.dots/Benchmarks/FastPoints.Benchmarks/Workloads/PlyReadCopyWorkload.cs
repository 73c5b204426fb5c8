namespace FastPoints.Benchmarks
{
    /// <summary>The file of <see cref="PlyBinaryWorkload"/> read and copied once, no more: its bound.</summary>
    public struct PlyReadCopyWorkload : IWorkload
    {
        string m_path;

        public string Name => "ply read and copy";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = PlyBenchmarkFile.Make(context, false);
            Run();
        }

        public WorkloadResult Run() => PlyPlainPass.Run(m_path, false);

        public void Dispose()
        {
        }
    }
}
