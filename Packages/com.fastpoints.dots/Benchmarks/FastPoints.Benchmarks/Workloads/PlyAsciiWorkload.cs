namespace FastPoints.Benchmarks
{
    /// <summary>An ascii PLY file, positions and colours, to columns; finding the lines is part of it.</summary>
    public struct PlyAsciiWorkload : IWorkload
    {
        string m_path;

        public string Name => "ply ascii";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = PlyBenchmarkFile.Make(context, true);
            Run();
        }

        public WorkloadResult Run() => PlyBenchmarkFile.Scan(m_path);

        public void Dispose()
        {
        }
    }
}
