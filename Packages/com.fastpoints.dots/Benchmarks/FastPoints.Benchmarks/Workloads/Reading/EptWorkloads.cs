namespace FastPoints.Benchmarks
{
    /// <summary>An EPT octree of plain records, all attributes, its hierarchy included.</summary>
    public sealed class EptBinaryWorkload : ColumnsWorkload
    {
        public EptBinaryWorkload() : base("ept binary", "ept binary read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => EptBenchmarkFolder.Make(context, false);
    }

    /// <summary>The limit of decoding the plain records.</summary>
    public sealed class EptBinaryReadCopyWorkload : ReadCopyWorkload
    {
        public EptBinaryReadCopyWorkload() : base("ept binary read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => EptBenchmarkFolder.Make(context, false);
    }

    /// <summary>An EPT octree of LAZ nodes, all attributes, its hierarchy included.</summary>
    public sealed class EptLaszipWorkload : ColumnsWorkload
    {
        public EptLaszipWorkload() : base("ept laszip", "ept laszip read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => EptBenchmarkFolder.Make(context, true);
    }

    /// <summary>The limit of decoding the LAZ nodes.</summary>
    public sealed class EptLaszipReadCopyWorkload : ReadCopyWorkload
    {
        public EptLaszipReadCopyWorkload() : base("ept laszip read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => EptBenchmarkFolder.Make(context, true);
    }
}
