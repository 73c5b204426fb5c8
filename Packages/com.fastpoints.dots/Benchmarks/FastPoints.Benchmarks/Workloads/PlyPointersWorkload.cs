namespace FastPoints.Benchmarks
{
    /// <summary>The loop of <see cref="PlyBinaryWorkload"/> over raw pointers in plain threads, against the same bound.</summary>
    public struct PlyPointersWorkload : IWorkload
    {
        string m_path;

        public string Name => "ply pointers";
        public string LimitName => "ply read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = PlyBenchmarkFile.Make(context, false);
            Run();
        }

        public WorkloadResult Run() => PlyPlainPass.Run(m_path, true);

        public void Dispose()
        {
        }
    }
}
