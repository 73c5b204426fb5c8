namespace UnityOutside.Tests.StandIns.Graphics;

public sealed class FrameTests : GraphicsFixture
{
    private const int RingBuffers = HeadlessGraphics.FramesInFlight + 1;
    private const int UploadWords = 256;

    private readonly GraphicsBuffer[] m_ring = new GraphicsBuffer[RingBuffers];
    private readonly uint[] m_words = new uint[64];
    private GraphicsFence m_fence;
    private GraphicsBuffer m_pool;
    private GraphicsBuffer m_arguments;
    private ComputeShader m_compute;
    private Material m_material;
    private RenderTexture m_target;
    private MaterialPropertyBlock m_block;
    private CommandBuffer m_commands;
    private int m_squares;
    private int m_tint;
    private int m_source;
    private int m_poolName;
    private int m_first;
    private int m_count;

    [SetUp]
    public void Make()
    {
        HeadlessGraphics.FramesBehind = 0;
        m_compute = HeadlessShaders.LoadCompute(PathOf("Numbers.compute"));
        m_material = new Material(HeadlessShaders.Load(PathOf("Quads.shader")));
        m_target = new RenderTexture(16, 16, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        for (int i = 0; i < RingBuffers; i++)
            m_ring[i] = new GraphicsBuffer(GraphicsBuffer.Target.Structured, GraphicsBuffer.UsageFlags.LockBufferForWrite,
                UploadWords / 4, 16);
        m_pool = new GraphicsBuffer(GraphicsBuffer.Target.Raw, UploadWords, 16);
        m_arguments = new GraphicsBuffer(GraphicsBuffer.Target.IndirectArguments, 1, GraphicsBuffer.IndirectDrawArgs.size);
        m_arguments.SetData(new[] { new GraphicsBuffer.IndirectDrawArgs { vertexCountPerInstance = 6, instanceCount = 2 } });
        m_block = new MaterialPropertyBlock();
        m_commands = new CommandBuffer { name = "frame" };
        (m_squares, m_tint, m_source, m_poolName) = (Id("_Squares"), Id("_Tint"), Id("_Source"), Id("_Target"));
        (m_first, m_count) = (Id("_First"), Id("_Count"));
    }

    [TearDown]
    public void Free()
    {
        foreach (GraphicsBuffer buffer in m_ring)
            buffer.Dispose();
        m_pool.Dispose();
        m_arguments.Dispose();
        m_commands.Dispose();
        UnityEngine.Object.DestroyImmediate(m_material);
        UnityEngine.Object.DestroyImmediate(m_target);
    }

    private void Upload(int frame)
    {
        GraphicsBuffer staging = m_ring[frame % RingBuffers];
        NativeArray<int> locked = staging.LockBufferForWrite<int>(0, UploadWords);
        for (int i = 0; i < UploadWords; i++)
            locked[i] = frame + i;
        staging.UnlockBufferAfterWrite<int>(UploadWords);
        m_commands.SetComputeIntParam(m_compute, m_first, frame % 4 * UploadWords / 4);
        m_commands.SetComputeIntParam(m_compute, m_count, UploadWords / 4);
        m_commands.SetComputeBufferParam(m_compute, 1, m_source, staging);
        m_commands.SetComputeBufferParam(m_compute, 1, m_poolName, m_pool);
        m_commands.DispatchCompute(m_compute, 1, 1, 1, 1);
    }

    private void Draw(int draws)
    {
        m_commands.SetRenderTarget(m_target);
        m_commands.ClearRenderTarget(true, true, Color.black);
        m_commands.SetViewProjectionMatrices(Matrix4x4.identity, Matrix4x4.Perspective(90, 1, 0.1f, 100));
        for (int i = 0; i < draws; i++)
        {
            m_block.Clear();
            m_block.SetBuffer(m_squares, m_pool);
            m_block.SetVector(m_tint, new Vector4(i, 1, 1, 1));
            m_commands.DrawProceduralIndirect(Matrix4x4.identity, m_material, 0, MeshTopology.Triangles, m_arguments, 0, m_block);
        }
    }

    // What else a frame may do each time: small data by command, a temporary texture, a fence.
    private void DoTheRest()
    {
        m_commands.SetBufferData(m_pool, m_words, 0, 0, m_words.Length);
        m_commands.SetGlobalVector(m_tint, Vector4.one);
        m_commands.GetTemporaryRT(m_source, new RenderTextureDescriptor(8, 8, GraphicsFormat.R32_SFloat, 0));
        m_commands.SetRenderTarget(m_source);
        m_commands.ClearRenderTarget(false, true, Color.clear);
        m_commands.ReleaseTemporaryRT(m_source);
        m_fence =
            m_commands.CreateGraphicsFence(GraphicsFenceType.CPUSynchronisation, SynchronisationStageFlags.AllGPUOperations);
    }

    private void Frame(int frame, int draws)
    {
        m_commands.Clear();
        Upload(frame);
        if (draws > 0)
        {
            Draw(draws);
            DoTheRest();
        }
        Execute(m_commands);
        HeadlessGraphics.EndFrame();
    }

    [Test]
    public void Frames_TenThousandUploads_LeakNothing()
    {
        for (int frame = 0; frame < 100; frame++)
            Frame(frame, draws: 0);
        long used = HeadlessGraphics.UsedBytes;
        for (int frame = 100; frame < 10_000; frame++)
            Frame(frame, draws: 0);
        Assert.That(HeadlessGraphics.UsedBytes, Is.EqualTo(used));
        var pool = new int[UploadWords * 4];
        m_pool.GetData(pool);
        for (int frame = 9_996; frame < 10_000; frame++)
            Assert.That(pool[frame % 4 * UploadWords + 7], Is.EqualTo(frame + 7));
    }

    [Test]
    public void Frames_GpuFarBehind_FencesPassFramesLater()
    {
        HeadlessGraphics.FramesBehind = 3;
        Frame(0, draws: 1);
        GraphicsFence first = m_fence;
        for (int frame = 1; frame < 3; frame++)
            Frame(frame, draws: 1);
        System.Threading.Thread.Sleep(20);
        Assert.That(first.passed, Is.False, "however long ago the device was done");
        HeadlessGraphics.EndFrame();
        Assert.That(first.passed, Is.True);
        Assert.That(m_fence.passed, Is.False);
    }

    [Test]
    public void Frames_WithDrawsAndUploads_MakeNoGarbage()
    {
        for (int frame = 0; frame < 100; frame++)
            Frame(frame, draws: 8);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int frame = 100; frame < 200; frame++)
            Frame(frame, draws: 8);
        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        HeadlessGraphics.WaitForIdle();
        Assert.That(m_fence.passed, Is.True);
    }

    [Test]
    public void Frames_ResourcesCreatedAndDisposed_LeakNothing()
    {
        long used = 0;
        for (int frame = 0; frame < 60; frame++)
        {
            using GraphicsBuffer passing = Structured(10_000 + frame * 1000);
            passing.SetData(new uint[10_000]);
            var texture = new RenderTexture(64, 64 + frame, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
            m_commands.Clear();
            m_commands.SetRenderTarget(texture);
            m_commands.ClearRenderTarget(true, true, Color.white);
            Execute(m_commands);
            UnityEngine.Object.DestroyImmediate(texture);
            passing.Dispose();
            HeadlessGraphics.WaitForIdle();
            if (frame == 40)
                used = HeadlessGraphics.UsedBytes;
        }
        Assert.That(HeadlessGraphics.UsedBytes, Is.EqualTo(used));
    }
}
