namespace UnityOutside.Tests.StandIns.Graphics;

public abstract class GraphicsFixture
{
    [OneTimeSetUp]
    public void MakeDevice()
    {
        HeadlessGraphics.Validate = true;
        if (!HeadlessGraphics.IsAvailable)
            Assert.Ignore("No graphics: " + HeadlessGraphics.UnsupportedReason);
    }

    [TearDown]
    public void ExpectNoValidationMessage()
    {
        HeadlessGraphics.WaitForIdle();
        Assert.That(HeadlessGraphics.TakeValidationMessages(), Is.Empty);
    }

    protected static string PathOf(string shader) =>
        Path.Combine(AppContext.BaseDirectory, "StandIns", "Graphics", "Shaders", shader);

    protected static int Id(string name) => Shader.PropertyToID(name);

    protected static GraphicsBuffer Structured(int count, int stride = 4) =>
        new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, stride);

    protected static uint[] Read(GraphicsBuffer buffer)
    {
        var data = new uint[buffer.count * buffer.stride / 4];
        buffer.GetData(data);
        return data;
    }

    protected static T[] Read<T>(Texture texture, int layer = 0) where T : struct
    {
        AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture);
        request.WaitForCompletion();
        NativeArray<T> data = request.GetData<T>(layer);
        return data.ToArray();
    }

    protected static void Execute(CommandBuffer commands) => UnityEngine.Graphics.ExecuteCommandBuffer(commands);
}
