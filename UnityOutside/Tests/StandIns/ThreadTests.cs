#if ENABLE_UNITY_COLLECTIONS_CHECKS

namespace UnityOutside.Tests.StandIns;

public sealed unsafe class ThreadTests
{
    static void OnThePool(Action call) => Task.Run(call).GetAwaiter().GetResult();
    static TestCaseData Container(string name, Action<Allocator> make) => new TestCaseData(make).SetArgDisplayNames(name);

    static readonly TestCaseData[] s_containers =
    {
        Container("Malloc", a => UnsafeUtility.Free(UnsafeUtility.Malloc(8, 8, a), a)),
        Container("MallocTracked", a => UnsafeUtility.FreeTracked(UnsafeUtility.MallocTracked(8, 8, a, 0), a)),
        Container("NativeArray", a => new NativeArray<int>(4, a).Dispose()),
        Container("NativeArray of an array", a => new NativeArray<int>(new[] { 1 }, a).Dispose()),
        Container("NativeList", a => new NativeList<int>(a).Dispose()),
        Container("NativeReference", a => new NativeReference<int>(a).Dispose()),
        Container("NativeParallelHashMap", a => new NativeParallelHashMap<int, int>(1, a).Dispose()),
    };

    [TestCaseSource(nameof(s_containers))]
    public void Temp_OnAPoolThread_IsRefused(Action<Allocator> make)
    {
        var failure = Assert.Throws<ArgumentException>(() => OnThePool(() => make(Allocator.Temp)));
        Assert.That(failure.Message,
            Is.EqualTo("Could not allocate native memory. If this allocation was made from a managed "
            + "thread outside of a job, you must use Allocator.Persistent or Allocator.TempJob."));
    }

    [TestCaseSource(nameof(s_containers))]
    public void Memory_NotTemp_IsUsableOnAnyThread(Action<Allocator> make)
    {
        OnThePool(() => make(Allocator.Persistent));
        OnThePool(() => make(Allocator.TempJob));
    }

    [TestCaseSource(nameof(s_containers))]
    public void Temp_OnTheMainThread_IsAllocated(Action<Allocator> make) => make(Allocator.Temp);

    struct TakeTempJob : IJobParallelFor
    {
        [WriteOnly] public NativeArray<int> Out;

        public void Execute(int index) => Out[index] = new NativeArray<int>(4, Allocator.Temp).Length;
    }

    [Test]
    public void Temp_InAJob_IsAllocatedOnEachWorker()
    {
        using var lengths = new NativeArray<int>(100, Allocator.TempJob);
        new TakeTempJob { Out = lengths }.Schedule(lengths.Length, 1).Complete();
        Assert.That(lengths.ToArray(), Is.All.EqualTo(4));
        // Without workers this thread runs the job, and can tell.
        JobsUtility.JobWorkerCount = 0;
        int before = TempMemory.Now.Blocks;
        new TakeTempJob { Out = lengths }.Schedule(lengths.Length, 1).Complete();
        JobsUtility.ResetJobWorkerCount();
        Assert.That(TempMemory.Now.Blocks, Is.EqualTo(before));
    }

    [Test]
    public void Handles_OnAPoolThread_AreOnlyOpened()
    {
        string path = Path.GetTempFileName();
        File.WriteAllBytes(path, new byte[16]);
        try
        {
            FileHandle file = default;
            OnThePool(() => file = AsyncReadManager.OpenFileAsync(path));
            var buffer = stackalloc byte[16];
            var commands = new ReadCommandArray { CommandCount = 1 };
            var command = new ReadCommand { Buffer = buffer, Size = 16 };
            commands.ReadCommands = &command;
            Refused("Close", () => file.Close());
            Refused("get_Status", () => _ = file.Status);
            Refused("get_JobHandle", () => _ = file.JobHandle);
            Refused("IsValid", () => file.IsValid());
            Refused("Read", () => AsyncReadManager.Read(file, commands));
            var read = AsyncReadManager.Read(file, commands);
            Refused("Cancel", () => read.Cancel());
            read.JobHandle.Complete();
            OnThePool(() => read.Dispose());
            file.Close().Complete();
        }
        finally
        {
            File.Delete(path);
        }
    }

    static void Refused(string member, Action call)
    {
        var failure = Assert.Throws<UnityException>(() => OnThePool(call));
        Assert.That(failure.Message, Does.StartWith(member + " can only be called from the main thread.\n"));
    }
}
#endif
