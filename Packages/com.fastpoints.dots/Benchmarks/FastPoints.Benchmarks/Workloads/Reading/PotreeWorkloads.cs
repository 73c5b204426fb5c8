namespace FastPoints.Benchmarks
{
    /// <summary>A Potree 2 cloud of encoding DEFAULT.</summary>
    public sealed class PotreeDefaultWorkload : ColumnsWorkload
    {
        public PotreeDefaultWorkload() : base("potree default", "potree default read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.PotreeDefault);
    }

    /// <summary>The limit of decoding encoding DEFAULT.</summary>
    public sealed class PotreeDefaultReadCopyWorkload : ReadCopyWorkload
    {
        public PotreeDefaultReadCopyWorkload() : base("potree default read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.PotreeDefault);
    }

    /// <summary>A Potree 2 cloud of encoding BROTLI.</summary>
    public sealed class PotreeBrotliWorkload : ColumnsWorkload
    {
        public PotreeBrotliWorkload() : base("potree brotli", "potree brotli read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.PotreeBrotli);
    }

    /// <summary>The limit of decoding encoding BROTLI.</summary>
    public sealed class PotreeBrotliReadCopyWorkload : ReadCopyWorkload
    {
        public PotreeBrotliReadCopyWorkload() : base("potree brotli read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.PotreeBrotli);
    }
}
