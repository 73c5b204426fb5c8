#if ENABLE_UNITY_COLLECTIONS_CHECKS

namespace UnityOutside.Tests.StandIns;

struct WriteJob : IJob
{
    public NativeArray<int> Values;

    public void Execute() => Values[0]++;
}

struct ReadJob : IJob
{
    [ReadOnly] public NativeArray<int> Values;

    public void Execute() => _ = Values[0];
}

/// <summary>What Unity refuses when a container is touched, resized or disposed, and what it says of memory left behind.
/// </summary>
public sealed unsafe class AccessSafetyTests
{
    NativeArray<int> m_values;
    NativeList<int> m_list;

    [SetUp]
    public void Allocate()
    {
        m_values = new NativeArray<int>(16, Allocator.Persistent);
        m_list = new NativeList<int>(4, Allocator.Persistent);
    }

    [TearDown]
    public void Free()
    {
        if (m_values.IsCreated)
            m_values.Dispose();
        if (m_list.IsCreated)
            m_list.Dispose();
    }

    struct WriteToReadOnlyJob : IJob
    {
        [ReadOnly] public NativeArray<int> Values;

        public void Execute() => Values[0] = 1;
    }

    struct PointerToReadOnlyJob : IJob
    {
        [ReadOnly] public NativeArray<int> Values;

        public void Execute() => *(int*)Values.GetUnsafePtr() = 1;
    }

    struct ReadFromWriteOnlyJob : IJob
    {
        [WriteOnly] public NativeArray<int> Values;

        public void Execute() => _ = Values[0];
    }

    struct WriteOnlyJob : IJob
    {
        [WriteOnly] public NativeArray<int> Values;

        public void Execute() => Values[0] = 5;
    }

    struct NeighbourForJob : IJobFor
    {
        public NativeArray<int> Values;

        public void Execute(int index) => Values[(index + 1) % Values.Length] = index;
    }

    struct NeighbourParallelForJob : IJobParallelFor
    {
        public NativeArray<int> Values;

        public void Execute(int index) => _ = Values[(index + 8) % Values.Length];
    }

    struct UnrestrictedNeighbourJob : IJobFor
    {
        [NativeDisableParallelForRestriction] public NativeArray<int> Values;

        public void Execute(int index) => Values[(index + 1) % Values.Length] = index;
    }

    struct ShiftJob : IJobFor
    {
        public NativeArray<int> Values;
        public int By;

        public void Execute(int index)
        {
            if (index + By >= 0 && index + By < Values.Length)
                Values[index + By] = index;
        }
    }

    struct OutOfRangeJob : IJob
    {
        public NativeArray<int> Values;

        public void Execute() => Values[Values.Length] = 1;
    }

    struct DisposingJob : IJob
    {
        public NativeArray<int> Values;

        public void Execute() => Values.Dispose();
    }

    struct AppendJob : IJob
    {
        public NativeList<int> List;

        public void Execute() => List.Add(1);
    }

    struct IdleListJob : IJob
    {
        public NativeList<int> List;

        public void Execute() { }
    }

    struct ReadOnlyListJob : IJob
    {
        [ReadOnly] public NativeList<int> List;

        public void Execute() => List.Add(1);
    }

    static NUnit.Framework.Constraints.IResolveConstraint Refused(string text) =>
        Throws.TypeOf<InvalidOperationException>().With.Message.Contains(text);

    [Test]
    public void ArrayInFlight_WrittenByAJob_ThrowsOnAccess()
    {
        JobHandle handle = new WriteJob { Values = m_values }.Schedule();
        const string must = "You must call JobHandle.Complete() on the job WriteJob";
        Assert.That(() => m_values[0], Refused(must));
        Assert.That(() => m_values[0] = 1, Refused(must));
        Assert.That(() => m_values.ToArray(), Refused(must));
        Assert.That(() => m_values.AsSpan().Length, Refused(must));
        Assert.That(() => (IntPtr)m_values.GetUnsafePtr(), Refused(must));
        Assert.That(() => m_values.GetSubArray(0, 1)[0], Refused(must));
        Assert.That(() => m_values.AsReadOnly()[0], Refused(must));
        Assert.That(() => m_values.CopyFrom(new int[16]), Refused(must));
        handle.Complete();
        Assert.That(m_values[0], Is.EqualTo(1));
    }

    [Test]
    public void ArrayInFlight_ReadByAJob_CanBeReadButNotWritten()
    {
        JobHandle handle = new ReadJob { Values = m_values }.Schedule();
        Assert.That(m_values[0], Is.Zero);
        Assert.That(() => m_values[0] = 1, Refused("ReadJob reads from"));
        handle.Complete();
        m_values[0] = 1;
    }

    [Test]
    public void ArrayInFlight_JobBeforeACompletedOne_IsAccessible()
    {
        JobHandle first = new WriteJob { Values = m_values }.Schedule();
        JobHandle last = new ReadJob { Values = m_values }.Schedule(new WriteJob { Values = m_values }.Schedule(first));
        last.Complete();
        m_values[0] += 1;
        Assert.That(m_values[0], Is.EqualTo(3));
    }

    [Test]
    public void ReadOnlyField_WrittenInTheJob_Throws()
    {
        Assert.That(() => new WriteToReadOnlyJob { Values = m_values }.Schedule().CompleteAndThrow(),
            Refused("WriteToReadOnlyJob.Values has been declared as [ReadOnly] in the job, but you are writing to it"));
        new PointerToReadOnlyJob { Values = m_values }.Run();
        Assert.That(() => LoggedExceptions.ThrowFirst(), Refused("declared as [ReadOnly]"));
        Assert.That(() => new ReadOnlyListJob { List = m_list }.Schedule().CompleteAndThrow(), Refused("declared as [ReadOnly]"));
        Assert.That(m_values[0], Is.Zero);
    }

    [Test]
    public void WriteOnlyField_ReadInTheJob_Throws()
    {
        Assert.That(() => new ReadFromWriteOnlyJob { Values = m_values }.Schedule().CompleteAndThrow(),
            Refused("declared as [WriteOnly] in the job, but you are reading from it"));
        new WriteOnlyJob { Values = m_values }.Schedule().Complete();
        Assert.That(m_values[0], Is.EqualTo(5));
    }

    [Test]
    public void ParallelJob_OutsideItsIndex_Throws()
    {
        Assert.That(() => new NeighbourForJob { Values = m_values }.ScheduleParallel(16, 4, default).CompleteAndThrow(),
            Throws.TypeOf<IndexOutOfRangeException>().With.Message.Contains("is out of restricted IJobParallelFor range"));
        Assert.That(() => new NeighbourParallelForJob { Values = m_values }.Schedule(16, 4).CompleteAndThrow(),
            Throws.TypeOf<IndexOutOfRangeException>().With.Message.Contains("ReadWriteBuffer"));
        new NeighbourForJob { Values = m_values }.Schedule(16, default).Complete();
        new UnrestrictedNeighbourJob { Values = m_values }.ScheduleParallel(16, 4, default).Complete();
        Assert.That(m_values[1], Is.Zero);
        Assert.That(m_values[0], Is.EqualTo(15));
    }

    [TestCase(-1)]
    [TestCase(1)]
    public void ParallelJob_OutsideItsBatch_Throws(int by)
    {
        Assert.That(() => new ShiftJob { Values = m_values, By = by }.ScheduleParallel(16, 4, default).CompleteAndThrow(),
            Throws.TypeOf<IndexOutOfRangeException>());
        new ShiftJob { Values = m_values, By = 0 }.ScheduleParallel(16, 4, default).Complete();
    }

    [TestCase(-1)]
    [TestCase(16)]
    public void Index_OutsideTheArray_Throws(int index)
    {
        Assert.That(() => m_values[index], Throws.TypeOf<IndexOutOfRangeException>()
            .With.Message.EqualTo($"Index {index} is out of range of '16' Length."));
        Assert.That(() => m_values[index] = 0, Throws.TypeOf<IndexOutOfRangeException>());
        Assert.That(() => m_values.AsReadOnly()[index], Throws.TypeOf<IndexOutOfRangeException>());
        Assert.That(() => m_list[index], Throws.TypeOf<IndexOutOfRangeException>());
    }

    [Test]
    public void Index_OutsideTheArrayInAJob_ReachesComplete() =>
        Assert.That(() => new OutOfRangeJob { Values = m_values }.Schedule().CompleteAndThrow(),
            Throws.TypeOf<IndexOutOfRangeException>());

    [Test]
    public void Dispose_WhileAJobUsesIt_Throws()
    {
        JobHandle write = new WriteJob { Values = m_values }.Schedule();
        Assert.That(() => m_values.Dispose(), Refused("before you can deallocate the"));
        write.Complete();
        JobHandle read = new ReadJob { Values = m_values }.Schedule();
        Assert.That(() => m_values.Dispose(), Refused("ReadJob reads from"));
        read.Complete();
        JobHandle append = new AppendJob { List = m_list }.Schedule();
        Assert.That(() => m_list.Dispose(), Refused("before you can deallocate"));
        append.Complete();
        Assert.That(m_list.Length, Is.EqualTo(1));
    }

    [Test]
    public void Dispose_FromWithinAJob_Throws() =>
        Assert.That(() => new DisposingJob { Values = m_values }.Schedule().CompleteAndThrow(),
            Refused("can not be deallocated"));

    [Test]
    public void Dispose_Twice_Throws()
    {
        NativeArray<int> copy = m_values;
        m_values.Dispose();
        Assert.That(() => copy.Dispose(), Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => m_values.Dispose(), Throws.TypeOf<ObjectDisposedException>());
        NativeList<int> listCopy = m_list;
        m_list.Dispose();
        Assert.That(() => listCopy.Dispose(), Throws.TypeOf<ObjectDisposedException>());
        NativeArray<int> never = default;
        Assert.That(() => never.Dispose(), Throws.Nothing);
    }

    [Test]
    public void Use_AfterDispose_Throws()
    {
        NativeArray<int> copy = m_values;
        NativeArray<int> part = m_values.GetSubArray(2, 3);
        NativeList<int> listCopy = m_list;
        m_values.Dispose();
        m_list.Dispose();
        Assert.That(() => copy[0], Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => part[0] = 1, Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => listCopy.Add(1), Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => default(NativeArray<int>)[0], Throws.TypeOf<NullReferenceException>());
    }

    [Test]
    public void Use_AfterADisposeJobWasScheduled_Throws()
    {
        NativeArray<int> copy = m_values;
        JobHandle disposed = m_values.Dispose(default(JobHandle));
        Assert.That(() => copy[0], Throws.TypeOf<ObjectDisposedException>());
        disposed.Complete();
    }

    [Test]
    public void ViewOfAList_AfterTheListGrew_Throws()
    {
        m_list.Add(1);
        NativeArray<int> view = m_list.AsArray();
        Assert.That(view[0], Is.EqualTo(1));
        m_list[0] = 2;
        Assert.That(view[0], Is.EqualTo(2));
        m_list.Add(3);
        Assert.That(() => view[0], Throws.TypeOf<ObjectDisposedException>());
        NativeArray<int> again = m_list.AsArray();
        // A job that may write the list may make it grow: what it did in the end does not matter.
        new IdleListJob { List = m_list }.Schedule().Complete();
        Assert.That(() => again[0], Throws.TypeOf<ObjectDisposedException>());
    }

    [Test]
    public void TempMemory_AfterItsFrame_IsInvalid()
    {
        var temp = new NativeArray<int>(4, Allocator.Temp);
        temp[0] = 1;
        AllocationLedger.AdvanceFrame();
        Assert.That(() => temp[0], Throws.TypeOf<ObjectDisposedException>());
    }

    [Test]
    public void TempJobMemory_OlderThanFourFrames_IsReported()
    {
        var array = new NativeArray<int>(4, Allocator.TempJob);
        for (int frame = 0; frame < 4; frame++)
            AllocationLedger.AdvanceFrame();
        Assert.That(() => AllocationLedger.AdvanceFrame(), Refused("more than the maximum lifespan of 4 frames old"));
        array.Dispose();
        Assert.That(() => AllocationLedger.AdvanceFrame(), Throws.Nothing);
    }

    [TestCase(Allocator.Persistent)]
    [TestCase(Allocator.TempJob)]
    public void Leak_OfAnyContainer_IsCountedUntilDisposed(Allocator allocator)
    {
        int before = AllocationLedger.Live(allocator);
        var array = new NativeArray<int>(4, allocator);
        var list = new NativeList<int>(4, allocator);
        var map = new NativeParallelHashMap<int, int>(4, allocator);
        var reference = new NativeReference<int>(allocator);
        Assert.That(AllocationLedger.Live(allocator), Is.GreaterThanOrEqualTo(before + 4));
        array.Dispose();
        list.Dispose();
        map.Dispose();
        reference.Dispose();
        Assert.That(AllocationLedger.Live(allocator), Is.EqualTo(before));
    }

    [Test]
    public void CheckForLeaks_WithStackTraces_NamesTheAllocationSite()
    {
        NativeLeakDetectionMode mode = NativeLeakDetection.Mode;
        UnsafeUtility.ForgiveLeaks();
        string log = null;
        NativeLeakDetection.Mode = NativeLeakDetectionMode.EnabledWithStackTrace;
        UnityEngine.Debug.s_sink = (type, text) => log += text;
        var leaked = new NativeArray<int>(4, Allocator.Persistent);
        try
        {
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.EqualTo(1));
            Assert.That(log, Does.Contain(nameof(CheckForLeaks_WithStackTraces_NamesTheAllocationSite)));
        }
        finally
        {
            NativeLeakDetection.Mode = mode;
            UnityEngine.Debug.s_sink = null;
            leaked.Dispose();
        }
        Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
    }

    [Test]
    public void Free_TwiceOrWithAnotherAllocator_Throws()
    {
        void* memory = UnsafeUtility.Malloc(16, 8, Allocator.Persistent);
        Assert.That(() => UnsafeUtility.Free(memory, Allocator.TempJob), Refused("freed with Allocator.TempJob"));
        UnsafeUtility.Free(memory, Allocator.Persistent);
        Assert.That(() => UnsafeUtility.Free(memory, Allocator.Persistent), Refused("freed already"));
    }
}
#endif
