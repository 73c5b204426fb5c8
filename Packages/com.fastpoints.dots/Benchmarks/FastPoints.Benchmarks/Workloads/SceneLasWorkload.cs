namespace FastPoints.Benchmarks
{
    /// <summary>A LAS file: its points are read where they are wanted.</summary>
    public sealed class SceneLasWorkload : ScenePreviewBase
    {
        public override string Name => "scene las";

        protected override string Find(WorkloadContext context) => TerrainBenchmarkFile.Make(context);
    }
}
