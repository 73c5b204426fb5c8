namespace FastPoints.HostTests.Gpu;

sealed class BuiltInHost : PipelineHost
{
    public BuiltInHost() => BuiltInPass.Begin();

    public override void Render(Camera camera) => camera.Render();
    public override void Dispose() => BuiltInPass.End();
}
