using FastPoints.Points;

namespace FastPoints.Benchmarks
{
    /// <summary>Positions only of a layered LAZ file: other layers are neither read nor decoded.</summary>
    public struct LazPositionsWorkload : IWorkload
    {
        string m_path;

        public string Name => "laz layered positions";
        public string LimitName => "laz layered read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = LazBenchmarkFile.Find(context, LazBenchmarkFile.Layered);
            Run();
        }

        public WorkloadResult Run() => LazBenchmarkFile.Decode(m_path, AttributeNames.X, AttributeNames.Y, AttributeNames.Z);

        public void Dispose()
        {
        }
    }
}
