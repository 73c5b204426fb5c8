namespace FastPoints.Benchmarks
{
    /// <summary>A COPC file, streamed as it is.</summary>
    public sealed class SceneCopcWorkload : ScenePreviewBase
    {
        public override string Name => "scene copc";

        protected override string Find(WorkloadContext context) => CopcBenchmarkFile.Find(context);
    }
}
