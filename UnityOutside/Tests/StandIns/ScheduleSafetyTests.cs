#if ENABLE_UNITY_COLLECTIONS_CHECKS
namespace UnityOutside.Tests.StandIns;

public sealed unsafe class ScheduleSafetyTests
{
    NativeArray<int> m_values;
    NativeArray<int> m_others;
    NativeList<int> m_list;

    [SetUp]
    public void Allocate()
    {
        m_values = new NativeArray<int>(8, Allocator.Persistent);
        m_others = new NativeArray<int>(8, Allocator.Persistent);
        m_list = new NativeList<int>(Allocator.Persistent);
    }

    [TearDown]
    public void Free()
    {
        m_values.Dispose();
        m_others.Dispose();
        m_list.Dispose();
    }

    struct ReadOnlyViewJob : IJob
    {
        public NativeArray<int>.ReadOnly Values;

        public void Execute() => _ = Values[0];
    }

    struct TwoWritersJob : IJob
    {
        public NativeArray<int> A;
        public NativeArray<int> B;

        public void Execute() => A[0] = B[0];
    }

    struct TwoReadersJob : IJob
    {
        [ReadOnly] public NativeArray<int> A;
        [ReadOnly] public NativeArray<int> B;

        public void Execute() => _ = A[0] + B[0];
    }

    struct UncheckedAliasJob : IJob
    {
        public NativeArray<int> A;
        [NativeDisableContainerSafetyRestriction] public NativeArray<int> B;

        public void Execute() => A[0] = 1;
    }

    struct Columns
    {
        public NativeArray<int> X;
        public NativeArray<int> Y;
    }

    struct NestedJob : IJob
    {
        public Columns Columns;

        public void Execute() => Columns.X[0] = Columns.Y[0];
    }

    struct NestedReadOnlyJob : IJobFor
    {
        [ReadOnly] public Columns Columns;

        public void Execute(int index) => _ = Columns.X[7 - index];
    }

    struct PointerJob : IJob
    {
        public int* Pointer;

        public void Execute() { }
    }

    struct AllowedPointerJob : IJob
    {
        [NativeDisableUnsafePtrRestriction] public int* Pointer;

        public void Execute() => Pointer[0] = 9;
    }

    struct ManagedFieldJob : IJob
    {
        public int[] Values;

        public void Execute() { }
    }

    struct NestedManagedFieldJob : IJob
    {
        public Holder Held;

        public struct Holder
        {
            public int Count;
            public string Name;
        }

        public void Execute() { }
    }

    struct ParallelListJob : IJobFor
    {
        public NativeList<int> List;

        public void Execute(int index) { }
    }

    struct SchedulingJob : IJob
    {
        public void Execute() => new SchedulingJob().Schedule();
    }

    struct CompletingJob : IJob
    {
        public JobHandle Other;

        public void Execute() => Other.Complete();
    }

    static NUnit.Framework.Constraints.IResolveConstraint Refused(string text) =>
        Throws.TypeOf<InvalidOperationException>().With.Message.Contains(text);

    [Test]
    public void TwoWriters_WithoutDependency_AreRefused()
    {
        JobHandle first = new WriteJob { Values = m_values }.Schedule();
        Assert.That(() => new WriteJob { Values = m_values }.Schedule(),
            Refused("The previously scheduled job WriteJob writes to the Unity.Collections.NativeArray`1[System.Int32] "
                + "WriteJob.Values. You are trying to schedule a new job WriteJob, which writes to the same"));
        first.Complete();
        Assert.That(m_values[0], Is.EqualTo(1));
    }

    [Test]
    public void Job_ReadingWhatAnotherWrites_IsRefused()
    {
        JobHandle first = new WriteJob { Values = m_values }.Schedule();
        Assert.That(() => new ReadJob { Values = m_values }.Schedule(), Refused("which reads from the same"));
        Assert.That(() => new ReadOnlyViewJob { Values = m_values.AsReadOnly() }.Schedule(),
            Refused("which reads from the same"));
        first.Complete();
    }

    [Test]
    public void Job_WritingWhatAnotherReads_IsRefused()
    {
        JobHandle first = new ReadJob { Values = m_values }.Schedule();
        Assert.That(() => new WriteJob { Values = m_values }.Schedule(),
            Refused("The previously scheduled job ReadJob reads from the"));
        first.Complete();
    }

    [Test]
    public void Job_WritingAfterOneReaderOfTwo_IsRefused()
    {
        JobHandle one = new ReadJob { Values = m_values }.Schedule();
        JobHandle two = new ReadJob { Values = m_values }.Schedule();
        Assert.That(() => new WriteJob { Values = m_values }.Schedule(two), Refused("reads from the"));
        JobHandle both = new WriteJob { Values = m_values }.Schedule(JobHandle.CombineDependencies(one, two));
        both.Complete();
    }

    [Test]
    public void Jobs_ReadersAndDependentWriters_AreAllowed()
    {
        JobHandle one = new ReadJob { Values = m_values }.Schedule();
        JobHandle two = new ReadOnlyViewJob { Values = m_values.AsReadOnly() }.Schedule();
        JobHandle write = new WriteJob { Values = m_values }.Schedule(JobHandle.CombineDependencies(one, two));
        JobHandle between = new WriteJob { Values = m_others }.Schedule(write);
        new ReadJob { Values = m_values }.Schedule(between).Complete();
        Assert.That(m_values[0], Is.EqualTo(1));
    }

    [Test]
    public void Conflict_JobFinishedButNotCompleted_IsRefused()
    {
        JobHandle first = new WriteJob { Values = m_values }.Schedule();
        SpinWait.SpinUntil(() => first.IsCompleted);
        Assert.That(() => new WriteJob { Values = m_values }.Schedule(), Refused("as a dependency"));
        first.Complete();
        new WriteJob { Values = m_values }.Schedule().Complete();
    }

    [Test]
    public void Run_WhileAJobIsInFlight_IsRefused()
    {
        JobHandle first = new WriteJob { Values = m_values }.Schedule();
        Assert.That(() => new ReadJob { Values = m_values }.Run(), Refused("The previously scheduled job WriteJob"));
        first.Complete();
        new ReadJob { Values = m_values }.Run();
    }

    [Test]
    public void SubArray_OfAWrittenArray_IsTheSameContainer()
    {
        JobHandle first = new WriteJob { Values = m_values.GetSubArray(0, 4) }.Schedule();
        Assert.That(() => new WriteJob { Values = m_values.GetSubArray(4, 4) }.Schedule(), Refused("writes to the same"));
        Assert.That(() => new WriteJob { Values = m_values.Reinterpret<uint>().Reinterpret<int>() }.Schedule(),
            Refused("writes to the same"));
        first.Complete();
    }

    [Test]
    public void List_AsArray_IsTheSameContainer()
    {
        m_list.Add(1);
        JobHandle first = new WriteJob { Values = m_list.AsArray() }.Schedule();
        Assert.That(() => new ParallelListJob { List = m_list }.Schedule(1, default), Refused("writes to"));
        Assert.That(() => m_list.Length, Refused("You must call JobHandle.Complete()"));
        first.Complete();
    }

    [Test]
    public void SameContainerTwice_OneWriteable_IsRefusedAsAliasing()
    {
        Assert.That(() => new TwoWritersJob { A = m_values, B = m_values }.Schedule(), Refused("(aliasing)"));
        Assert.That(() => new TwoWritersJob { A = m_values.GetSubArray(0, 2), B = m_values.GetSubArray(4, 2) }.Schedule(),
            Refused("(aliasing)"));
        new TwoReadersJob { A = m_values, B = m_values }.Schedule().Complete();
        new UncheckedAliasJob { A = m_values, B = m_values }.Schedule().Complete();
    }

    [Test]
    public void UncreatedContainer_InAJob_IsRefused()
    {
        Assert.That(() => new TwoWritersJob { A = m_values }.Schedule(),
            Refused("TwoWritersJob.B has not been assigned or constructed"));
        Assert.That(() => new ReadJob().Run(), Refused("has not been assigned or constructed"));
        Assert.That(() => new NestedJob { Columns = new Columns { X = m_values } }.Schedule(),
            Refused("NestedJob.Columns.Y has not been assigned"));
    }

    [Test]
    public void DisposedContainer_InAJob_IsRefused()
    {
        var gone = new NativeArray<int>(1, Allocator.TempJob);
        NativeArray<int> copy = gone;
        gone.Dispose();
        Assert.That(() => new WriteJob { Values = copy }.Schedule(), Refused("has been deallocated"));
    }

    [Test]
    public void TempMemory_InAScheduledJob_IsRefused()
    {
        var temp = new NativeArray<int>(1, Allocator.Temp);
        Assert.That(() => new WriteJob { Values = temp }.Schedule(), Refused("Allocator.Temp"));
        new WriteJob { Values = temp }.Run();
        Assert.That(temp[0], Is.EqualTo(1));
        temp.Dispose();
    }

    [Test]
    public void RefusedJob_LeavesNothingInFlight()
    {
        Assert.That(() => new TwoWritersJob { A = m_values }.Schedule(), Throws.InvalidOperationException);
        m_values[0] = 3;
        new WriteJob { Values = m_values }.Schedule().Complete();
        Assert.That(m_values[0], Is.EqualTo(4));
    }

    [Test]
    public void NestedContainers_CountAndInheritReadOnly()
    {
        var columns = new Columns { X = m_values, Y = m_others };
        JobHandle first = new WriteJob { Values = m_others }.Schedule();
        Assert.That(() => new NestedJob { Columns = columns }.Schedule(), Refused("NestedJob.Columns.Y"));
        first.Complete();
        new NestedReadOnlyJob { Columns = columns }.ScheduleParallel(8, 1, default).Complete();
    }

    [Test]
    public void RawPointer_WithoutItsAttribute_IsRefused()
    {
        Assert.That(() => new PointerJob { Pointer = null }.Schedule(), Refused("uses unsafe Pointers which is not allowed"));
        int value = 0;
        new AllowedPointerJob { Pointer = &value }.Run();
        Assert.That(value, Is.EqualTo(9));
    }

    [Test]
    public void ReferenceField_InAJob_IsRefused()
    {
        Assert.That(() => new ManagedFieldJob { Values = new int[1] }.Schedule(),
            Refused("ManagedFieldJob.Values is not a value type. Job structs may not contain any reference types."));
        var held = new NestedManagedFieldJob.Holder { Count = 1, Name = "" };
        Assert.That(() => new NestedManagedFieldJob { Held = held }.Run(),
            Refused("NestedManagedFieldJob.Held.Name is not a value type"));
    }

    [Test]
    public void ParallelJob_WithAWriteableContainerThatCannot_IsRefused()
    {
        Assert.That(() => new ParallelListJob { List = m_list }.ScheduleParallel(4, 1, default),
            Refused("The container does not support parallel writing"));
    }

    [Test]
    public void ScheduleAndComplete_OffTheMainThread_AreRefused()
    {
        JobHandle mine = new WriteJob { Values = m_values }.Schedule();
        Exception onSchedule = Caught(() => new WriteJob { Values = m_others }.Schedule());
        Exception onComplete = Caught(() => mine.Complete());
        Exception onRun = Caught(() => new WriteJob { Values = m_others }.Run());
        Exception onCombine = Caught(() => JobHandle.CombineDependencies(mine, mine));
        mine.Complete();
        foreach (Exception exception in new[] { onSchedule, onComplete, onRun, onCombine })
        {
            Assert.That(exception, Is.TypeOf<InvalidOperationException>());
            Assert.That(exception.Message, Does.Contain("can only be called from the main thread"));
        }
    }

    [Test]
    public void ScheduleAndComplete_FromWithinAJob_AreRefused()
    {
        JobHandle scheduling = new SchedulingJob().Schedule();
        Assert.That(() => scheduling.CompleteAndThrow(), Refused("Schedule can not be called from within a job"));
        JobHandle other = new WriteJob { Values = m_values }.Schedule();
        JobHandle completing = new CompletingJob { Other = other }.Schedule();
        Assert.That(() => completing.CompleteAndThrow(), Refused("JobHandle.Complete can not be called from within a job"));
        other.Complete();
    }

    [Test]
    public void Dispose_DependenciesWithoutARunningJob_IsRefused()
    {
        var array = new NativeArray<int>(1, Allocator.TempJob);
        JobHandle write = new WriteJob { Values = array }.Schedule();
        Assert.That(() => array.Dispose(default(JobHandle)), Refused("The previously scheduled job WriteJob writes to"));
        JobHandle disposed = array.Dispose(write);
        Assert.That(array.IsCreated, Is.False);
        disposed.Complete();
    }

    static Exception Caught(Action action)
    {
        Exception caught = null;
        var thread = new Thread(() =>
        {
            try
            {
                action();
            }
            catch (Exception exception)
            {
                caught = exception;
            }
        });
        thread.Start();
        thread.Join();
        return caught;
    }
}
#endif
