namespace FastPoints.HostTests.Gpu;

abstract class PipelineHost : IDisposable
{
    public static PipelineHost Make(string name) => name switch
    {
        nameof(BuiltInHost) => new BuiltInHost(),
        nameof(UrpHost) => new UrpHost(),
        nameof(HdrpHost) => new HdrpHost(),
        _ => throw new ArgumentException(name),
    };

    public abstract void Render(Camera camera);
    public abstract void Dispose();

    protected static void Clear(Camera camera, CommandBuffer commands)
    {
        commands.SetRenderTarget(camera.targetTexture, 0, CubemapFace.Unknown, -1);
        commands.ClearRenderTarget(true, true, camera.backgroundColor);
    }
}
