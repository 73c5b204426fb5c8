namespace UnityOutside.Tests.StandIns.Graphics;

public sealed class GraphicsBufferTests : GraphicsFixture
{
    private const GraphicsBuffer.Target Plain = GraphicsBuffer.Target.Structured;

    private static GraphicsBuffer Lockable(int count = 16) =>
        new GraphicsBuffer(Plain, GraphicsBuffer.UsageFlags.LockBufferForWrite, count, 4);

    [Test]
    public void SetData_Ranges_AreOfElements()
    {
        using GraphicsBuffer buffer = Structured(4, 16);
        buffer.SetData(new uint[16]);
        buffer.SetData(new[] { new Vector4(1, 2, 3, 4), new Vector4(5, 6, 7, 8) }, 1, 2, 1);
        using (var native = new NativeArray<uint>(new uint[] { 1, 2, 3 }, Allocator.Persistent))
            buffer.SetData(native, 1, 5, 2);
        var part = new float[4];
        buffer.GetData(part, 1, 9, 3);
        Assert.That(part, Is.EqualTo(new float[] { 0, 6, 7, 8 }));
        Assert.That(Read(buffer).Take(8), Is.EqualTo(new uint[] { 0, 0, 0, 0, 0, 2, 3, 0 }));
        Assert.That(() => buffer.SetData(new uint[2], 0, 15, 2), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void SetBufferData_ByCommand_IsDoneInOrder()
    {
        using GraphicsBuffer buffer = Structured(4);
        using var copy = new GraphicsBuffer(Plain | GraphicsBuffer.Target.CopyDestination, 4, 4);
        using var source = new GraphicsBuffer(Plain | GraphicsBuffer.Target.CopySource, 4, 4);
        var data = new uint[] { 1, 2, 3, 4 };
        using var commands = new CommandBuffer();
        commands.SetBufferData(source, data);
        commands.CopyBuffer(source, copy);
        commands.SetBufferData(source, new uint[] { 9 }, 0, 3, 1);
        data[0] = 77;
        Execute(commands);
        Assert.That(Read(copy), Is.EqualTo(new uint[] { 1, 2, 3, 4 }));
        Assert.That(Read(source), Is.EqualTo(new uint[] { 1, 2, 3, 9 }));
        Assert.That(() => commands.CopyBuffer(buffer, copy), Throws.ArgumentException.With.Message.Contains("CopySource"));
        Assert.That(() => commands.CopyBuffer(source, buffer), Throws.ArgumentException.With.Message.Contains("CopyDestination"));
    }

    [Test]
    public void Constructor_ArgumentsThatUnityRefuses_Throw()
    {
        Assert.That(() => new GraphicsBuffer(Plain, 0, 4), Throws.ArgumentException);
        Assert.That(() => new GraphicsBuffer(Plain, 1, 0), Throws.ArgumentException);
        Assert.That(() => new GraphicsBuffer(Plain, 1, 6), Throws.ArgumentException);
        Assert.That(() => new GraphicsBuffer(GraphicsBuffer.Target.Index, 1, 8), Throws.ArgumentException);
        Assert.That(() => new GraphicsBuffer(Plain | GraphicsBuffer.Target.CopyDestination,
            GraphicsBuffer.UsageFlags.LockBufferForWrite, 1, 4), Throws.ArgumentException.With.Message.Contains("locked"));
        int tooMany = (int)(SystemInfo.maxGraphicsBufferSize / 16) + 1;
        Assert.That(() =>
            new GraphicsBuffer(Plain, tooMany, 16), Throws.ArgumentException.With.Message.Contains("maxGraphicsBufferSize"));
    }

    [Test]
    public void Constructor_Content_IsUndefined()
    {
        using GraphicsBuffer plain = Structured(8);
        using GraphicsBuffer lockable = Lockable(8);
        Assert.That(Read(plain).Concat(Read(lockable)), Is.All.EqualTo(0xCDCDCDCD));
    }

    [Test]
    public void Constructor_OutOfMemory_LogsAndIsNotValid()
    {
        string logged = null;
        Debug.s_sink = (_, text) => logged = text;
        HeadlessGraphics.MemoryLimitBytes = HeadlessGraphics.UsedBytes + 1_000_000;
        try
        {
            using var small = new GraphicsBuffer(Plain, 100_000, 4);
            using var large = new GraphicsBuffer(Plain, 300_000, 4);
            Assert.That((small.IsValid(), large.IsValid()), Is.EqualTo((true, false)));
            Assert.That(logged, Does.Contain("1200000 bytes"));
            Assert.That(() => large.SetData(new uint[1]), Throws.InvalidOperationException);
        }
        finally
        {
            HeadlessGraphics.MemoryLimitBytes = long.MaxValue;
            Debug.s_sink = null;
        }
    }

    [Test]
    public void Use_AfterDispose_Throws()
    {
        GraphicsBuffer buffer = Lockable();
        buffer.Dispose();
        buffer.Dispose();
        Assert.That(buffer.IsValid(), Is.False);
        Assert.That(() => buffer.SetData(new uint[1]), Throws.InvalidOperationException);
        Assert.That(() => buffer.GetData(new uint[1]), Throws.InvalidOperationException);
        Assert.That(() => buffer.LockBufferForWrite<uint>(0, 1), Throws.InvalidOperationException);
    }

    [Test]
    public void SetData_BeyondTheBuffer_Throws()
    {
        using GraphicsBuffer buffer = Structured(4);
        Assert.That(() => buffer.SetData(new uint[5]), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => buffer.SetData(new uint[4], 0, 1, 4), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => buffer.SetData(new uint[4], 2, 0, 3), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => buffer.GetData(new uint[5]), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Lock_WithoutTheFlag_Throws()
    {
        using GraphicsBuffer buffer = Structured(4);
        Assert.That(() =>
            buffer.LockBufferForWrite<uint>(0, 4),
            Throws.InvalidOperationException.With.Message.Contains("LockBufferForWrite"));
    }

    [Test]
    public void Lock_Misused_Throws()
    {
        using GraphicsBuffer buffer = Lockable();
        Assert.That(() => buffer.UnlockBufferAfterWrite<uint>(0), Throws.InvalidOperationException);
        buffer.LockBufferForWrite<uint>(0, 0);
        buffer.UnlockBufferAfterWrite<uint>(0);
        Assert.That(() => buffer.LockBufferForWrite<uint>(10, 7), Throws.InstanceOf<ArgumentOutOfRangeException>());
        NativeArray<uint> locked = buffer.LockBufferForWrite<uint>(4, 8);
        Assert.That(() =>
            buffer.LockBufferForWrite<uint>(0, 1), Throws.InvalidOperationException.With.Message.Contains("locked already"));
        Assert.That(() => buffer.GetData(new uint[1]), Throws.InvalidOperationException.With.Message.Contains("locked"));
        Assert.That(() => buffer.UnlockBufferAfterWrite<Vector4>(1), Throws.InvalidOperationException);
        Assert.That(() => buffer.UnlockBufferAfterWrite<uint>(9), Throws.InstanceOf<ArgumentOutOfRangeException>());
        locked[0] = 5;
        buffer.UnlockBufferAfterWrite<uint>(8);
        Assert.That(() => locked[0] = 6, Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(Read(buffer)[4], Is.EqualTo(5));
    }

    [Test]
    public void Lock_PreviousContent_IsLost()
    {
        using GraphicsBuffer buffer = Lockable();
        buffer.SetData(new uint[16]);
        HeadlessGraphics.WaitForIdle();
        Assert.That(buffer.LockBufferForWrite<uint>(1, 2), Has.All.Not.Zero);
        buffer.UnlockBufferAfterWrite<uint>(0);
    }

    [Test]
    public void Unlock_WhileAJobWrites_Throws()
    {
        using GraphicsBuffer buffer = Lockable();
        var job = new FillJob { Target = buffer.LockBufferForWrite<uint>(0, 16) };
        JobHandle filled = job.Schedule();
        Assert.That(() => buffer.UnlockBufferAfterWrite<uint>(16), Throws.InvalidOperationException);
        filled.Complete();
        buffer.UnlockBufferAfterWrite<uint>(16);
        Assert.That(Read(buffer), Is.EqualTo(Enumerable.Range(0, 16)));
    }

    [Test]
    public void Lock_WhileTheDeviceMayRead_Throws()
    {
        using var ring =
            new GraphicsBuffer(Plain | GraphicsBuffer.Target.CopySource, GraphicsBuffer.UsageFlags.LockBufferForWrite, 4, 4);
        using var pool = new GraphicsBuffer(Plain | GraphicsBuffer.Target.CopyDestination, 4, 4);
        using var commands = new CommandBuffer();
        commands.CopyBuffer(ring, pool);
        GraphicsFence fence =
            commands.CreateGraphicsFence(GraphicsFenceType.CPUSynchronisation, SynchronisationStageFlags.AllGPUOperations);
        Assert.That(fence.passed, Is.False);
        GraphicsFence other = UnityEngine.Graphics.CreateGraphicsFence(GraphicsFenceType.AsyncQueueSynchronisation,
            SynchronisationStageFlags.AllGPUOperations);
        Assert.That(() => other.passed, Throws.TypeOf<NotSupportedException>());
        Assert.That(() => default(GraphicsFence).passed, Throws.InvalidOperationException, "nothing made it");
        Execute(commands);
        Assert.That(() => ring.LockBufferForWrite<uint>(0, 4), Throws.InvalidOperationException.With.Message.Contains("GPU"));
        HeadlessGraphics.WaitForIdle();
        Assert.That(fence.passed, Is.True);
        ring.LockBufferForWrite<uint>(0, 4);
        Assert.That(() => Execute(commands), Throws.InvalidOperationException.With.Message.Contains("locked"));
        ring.UnlockBufferAfterWrite<uint>(0);
    }

    [Test]
    public void Readback_OfAFrame_IsValidUntilItsEnd()
    {
        using GraphicsBuffer buffer = Structured(4);
        buffer.SetData(new uint[] { 1, 2, 3, 4 });
        int called = 0;
        AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(buffer, 8, 4, r => called += r.GetData<uint>().Length);
        request.WaitForCompletion();
        Assert.That((request.done, request.hasError, called), Is.EqualTo((true, false, 2)));
        NativeArray<uint> data = request.GetData<uint>();
        Assert.That(data, Is.EqualTo(new uint[] { 2, 3 }));
        HeadlessGraphics.EndFrame();
        Assert.That(request.hasError, Is.True);
        Assert.That(() => data[0], Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => request.GetData<uint>(), Throws.InvalidOperationException);
    }

    private struct FillJob : IJob
    {
        public NativeArray<uint> Target;

        public void Execute()
        {
            for (int i = 0; i < Target.Length; i++)
                Target[i] = (uint)i;
        }
    }
}
