using FastPoints.Points;

namespace FastPoints.Benchmarks
{
    /// <summary>Positions and colours of a layered LAZ file.</summary>
    public struct LazColorsWorkload : IWorkload
    {
        string m_path;

        public string Name => "laz layered positions and colours";
        public string LimitName => "laz layered read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = LazBenchmarkFile.Find(context, LazBenchmarkFile.Layered);
            Run();
        }

        public WorkloadResult Run() => LazBenchmarkFile.Decode(m_path, AttributeNames.X, AttributeNames.Y, AttributeNames.Z,
            AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue);

        public void Dispose()
        {
        }
    }
}
