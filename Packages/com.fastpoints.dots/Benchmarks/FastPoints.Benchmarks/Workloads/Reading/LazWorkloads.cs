using FastPoints.Points;

namespace FastPoints.Benchmarks
{
    /// <summary>All attributes of a pointwise LAZ file.</summary>
    public sealed class LazPointwiseWorkload : ColumnsWorkload
    {
        public LazPointwiseWorkload() : base("laz pointwise", "laz pointwise read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.LazPointwise);
    }

    /// <summary>The limit of decoding the pointwise file.</summary>
    public sealed class LazPointwiseReadCopyWorkload : ReadCopyWorkload
    {
        public LazPointwiseReadCopyWorkload() : base("laz pointwise read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.LazPointwise);
    }

    /// <summary>All attributes of a layered LAZ file.</summary>
    public sealed class LazLayeredWorkload : ColumnsWorkload
    {
        public LazLayeredWorkload() : base("laz layered", "laz layered read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.LazLayered);
    }

    /// <summary>Positions and colours of a layered LAZ file.</summary>
    public sealed class LazColorsWorkload : ColumnsWorkload
    {
        public LazColorsWorkload() : base("laz layered positions and colours", "laz layered read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.LazLayered);

        protected override PointSchema Wanted(PointSchema schema) => LasBenchmarkFile.Wanted(schema);
    }

    /// <summary>Positions only of a layered LAZ file: other layers are neither read nor decoded.</summary>
    public sealed class LazPositionsWorkload : ColumnsWorkload
    {
        public LazPositionsWorkload() : base("laz layered positions", "laz layered read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.LazLayered);

        protected override PointSchema Wanted(PointSchema schema) =>
            schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z);
    }

    /// <summary>The limit of decoding the layered file.</summary>
    public sealed class LazLayeredReadCopyWorkload : ReadCopyWorkload
    {
        public LazLayeredReadCopyWorkload() : base("laz layered read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.LazLayered);
    }
}
