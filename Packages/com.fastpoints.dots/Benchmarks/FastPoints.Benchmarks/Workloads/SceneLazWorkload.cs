namespace FastPoints.Benchmarks
{
    /// <summary>A LAZ file: prefixes of its chunks, then all of it.</summary>
    public sealed class SceneLazWorkload : ScenePreviewBase
    {
        public override string Name => "scene laz";

        protected override string Find(WorkloadContext context) => LazBenchmarkFile.Find(context, LazBenchmarkFile.Layered);
    }
}
