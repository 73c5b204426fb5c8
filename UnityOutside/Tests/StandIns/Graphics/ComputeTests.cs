namespace UnityOutside.Tests.StandIns.Graphics;

public sealed class ComputeTests : GraphicsFixture
{
    private ComputeShader m_shader;

    [OneTimeSetUp]
    public void Load() => m_shader = HeadlessShaders.LoadCompute(PathOf("Numbers.compute"));

    [Test]
    public void FindKernel_UnknownName_Throws()
    {
        Assert.That(m_shader.FindKernel("Copy"), Is.EqualTo(1));
        Assert.That(() => m_shader.FindKernel("Nothing"), Throws.ArgumentException.With.Message.Contains("Nothing"));
    }

    [TestCase(false, 10u)]
    [TestCase(true, 20u)]
    public void Dispatch_KeywordVariant_RunsItsOwnCode(bool isTwice, uint first)
    {
        using GraphicsBuffer numbers = Structured(100);
        m_shader.SetInt("_First", 10);
        m_shader.SetInt("_Count", 100);
        m_shader.SetBuffer(0, Id("_Numbers"), numbers);
        if (isTwice)
            m_shader.EnableKeyword("TWICE");
        m_shader.Dispatch(0, 2, 1, 1);
        m_shader.DisableKeyword("TWICE");
        Assert.That(Read(numbers), Is.EqualTo(Enumerable.Range(0, 100).Select(i => first + (uint)i * (isTwice ? 2u : 1u))));
    }

    [Test]
    public void Dispatch_StagingToPool_CopiesLockedBytes()
    {
        using var staging =
            new GraphicsBuffer(GraphicsBuffer.Target.Structured, GraphicsBuffer.UsageFlags.LockBufferForWrite, 64, 16);
        using GraphicsBuffer pool = Structured(256, 16);
        pool.SetData(new uint[1024]);
        NativeArray<uint> locked = staging.LockBufferForWrite<uint>(0, 256);
        for (int i = 0; i < locked.Length; i++)
            locked[i] = (uint)i + 1;
        staging.UnlockBufferAfterWrite<uint>(256);

        using var commands = new CommandBuffer { name = "upload" };
        commands.SetComputeIntParam(m_shader, Id("_First"), 128);
        commands.SetComputeIntParam(m_shader, Id("_Count"), 64);
        commands.SetComputeBufferParam(m_shader, 1, Id("_Source"), staging);
        commands.SetComputeBufferParam(m_shader, 1, Id("_Target"), pool);
        commands.DispatchCompute(m_shader, 1, 1, 1, 1);
        Execute(commands);
        uint[] data = Read(pool);
        Assert.That(data.Skip(512).Take(256), Is.EqualTo(Enumerable.Range(1, 256)));
        Assert.That(data.Take(512).Concat(data.Skip(768)), Is.All.Zero);
    }

    [Test]
    public void Dispatch_Indirect_ReadsItsGroupsFromTheBuffer()
    {
        using GraphicsBuffer numbers = Structured(256);
        using var arguments = new GraphicsBuffer(GraphicsBuffer.Target.IndirectArguments, 4, 4);
        numbers.SetData(new uint[256]);
        arguments.SetData(new uint[] { 9, 2, 1, 1 });
        using var commands = new CommandBuffer();
        commands.SetComputeIntParam(m_shader, Id("_First"), 1);
        commands.SetComputeIntParam(m_shader, Id("_Count"), 256);
        commands.SetComputeBufferParam(m_shader, 0, Id("_Numbers"), numbers);
        commands.DispatchCompute(m_shader, 0, arguments, 4);
        Execute(commands);
        Assert.That(Read(numbers).Count(n => n != 0), Is.EqualTo(128));
    }

    [Test]
    public void Dispatch_Constants_ArriveAsTheyWereSet()
    {
        using GraphicsBuffer numbers = Structured(5);
        using var raw = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 4, 4);
        raw.SetData(new uint[] { 1, 2, 3, 4 });
        Matrix4x4 matrix = Matrix4x4.Translate(new Vector3(10, 20, 30));
        m_shader.SetMatrix(Id("_Matrix"), matrix);
        m_shader.SetVector(Id("_Vector"), new Vector4(1, 2, 3, 1));
        m_shader.SetFloat("_Factor", 0.25f);
        m_shader.SetInt(Id("_Whole"), -4);
        m_shader.SetBuffer(2, Id("_Numbers"), numbers);
        m_shader.SetBuffer(2, Id("_Raw"), raw);
        m_shader.Dispatch(2, 1, 1, 1);
        uint[] data = Read(numbers);
        Assert.That(data.Take(3).Select(BitConverter.UInt32BitsToSingle), Is.EqualTo(new[] { 11f, 22f, 0.25f }));
        Assert.That(((int)data[3], data[4]), Is.EqualTo((-4, 3u)));
    }

    [TestCase(GraphicsFormat.R32G32B32A32_SFloat)]
    [TestCase(GraphicsFormat.R8G8B8A8_UNorm)]
    public void Dispatch_RandomWrite_FillsTheTexture(GraphicsFormat format)
    {
        var texture = new RenderTexture(16, 8, 0, format) { enableRandomWrite = true };
        m_shader.SetFloat("_Factor", 0.5f);
        m_shader.SetTexture(3, Id("_Image"), texture);
        m_shader.Dispatch(3, 2, 1, 1);
        if (format == GraphicsFormat.R8G8B8A8_UNorm)
            Assert.That(Read<uint>(texture)[16], Is.EqualTo(0xff80ff00u));
        else
            Assert.That(Read<Vector4>(texture)[16 * 3 + 5], Is.EqualTo(new Vector4(5, 3, 0.5f, 1)));
        UnityEngine.Object.DestroyImmediate(texture);
    }

    [Test]
    public void Dispatch_AnotherFormatThanTheShaderReads_Throws()
    {
        var texture = new RenderTexture(8, 8, 0, GraphicsFormat.R32_SFloat) { enableRandomWrite = true };
        m_shader.SetTexture(4, Id("_Most"), texture);
        Assert.That(() => m_shader.Dispatch(4, 1, 1, 1), Throws.InvalidOperationException.With.Message.Contains("R32Uint"));
        UnityEngine.Object.DestroyImmediate(texture);
        texture = new RenderTexture(8, 8, 0, GraphicsFormat.R32_UInt) { enableRandomWrite = true };
        using var commands = new CommandBuffer();
        commands.SetRenderTarget(texture);
        commands.ClearRenderTarget(false, true, new Color(5, 0, 0, 0));
        commands.SetComputeTextureParam(m_shader, 4, Id("_Most"), texture);
        commands.DispatchCompute(m_shader, 4, 1, 1, 1);
        Execute(commands);
        Assert.That(Read<uint>(texture), Is.EqualTo(Enumerable.Range(0, 64).Select(i => Math.Max(i, 5))));
        UnityEngine.Object.DestroyImmediate(texture);
    }

    [Test]
    public void Dispatch_TooManyGroups_Throws()
    {
        ComputeShader shader = HeadlessShaders.LoadCompute(PathOf("Numbers.compute"));
        Assert.That(() => shader.Dispatch(0, 1, 1, 1), Throws.InvalidOperationException.With.Message.Contains("_Numbers"));
        Assert.That(() => shader.Dispatch(0, 0, 1, 1), Throws.ArgumentException);
        Assert.That(() => shader.Dispatch(7, 1, 1, 1), Throws.InstanceOf<IndexOutOfRangeException>());
        using GraphicsBuffer wrongStride = Structured(4, 8);
        shader.SetBuffer(0, Id("_Numbers"), wrongStride);
        Assert.That(() => shader.Dispatch(0, 1, 1, 1), Throws.InvalidOperationException.With.Message.Contains("4 bytes"));
        using var forHost =
            new GraphicsBuffer(GraphicsBuffer.Target.Structured, GraphicsBuffer.UsageFlags.LockBufferForWrite, 4, 4);
        shader.SetBuffer(0, Id("_Numbers"), forHost);
        Assert.That(() => shader.Dispatch(0, 1, 1, 1), Throws.InvalidOperationException.With.Message.Contains("host's to write"));
        using var wrongTarget = new GraphicsBuffer(GraphicsBuffer.Target.CopySource, 4, 4);
        shader.SetBuffer(0, Id("_Numbers"), wrongTarget);
        Assert.That(() => shader.Dispatch(0, 1, 1, 1), Throws.InvalidOperationException.With.Message.Contains("Structured"));
    }
}
