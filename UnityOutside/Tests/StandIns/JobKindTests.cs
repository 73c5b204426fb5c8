namespace UnityOutside.Tests.StandIns;

public sealed class JobKindTests
{
    [SetUp]
    public void Workers() => JobsUtility.JobWorkerCount = 3;

    [TearDown]
    public void DefaultWorkers() => JobsUtility.ResetJobWorkerCount();

    struct AddJob : IJob
    {
        public NativeArray<int> Values;
        public int Amount;

        public void Execute() => Values[0] += Amount;
    }

    struct SquareFor : IJobFor
    {
        public NativeArray<int> Squares;

        public void Execute(int index) => Squares[index] = index * index;
    }

    struct SquareParallelFor : IJobParallelFor
    {
        [ReadOnly] public NativeArray<int> Roots;
        public NativeArray<int> Squares;

        public void Execute(int index) => Squares[index] = Roots[index] * Roots[index];
    }

    struct ThreadIndexJob : IJobParallelFor
    {
        [NativeSetThreadIndex] public int ThreadIndex;
        public NativeArray<int> IndexOfElement;
        public NativeArray<int> IndexOfUtility;

        public void Execute(int index)
        {
            IndexOfElement[index] = ThreadIndex;
            IndexOfUtility[index] = JobsUtility.ThreadIndex;
        }
    }

    struct DeallocatingJob : IJob
    {
        [DeallocateOnJobCompletion][ReadOnly] public NativeArray<int> Values;
        public NativeReference<int> Result;

        public void Execute() => Result.Value = Values[0];
    }

    unsafe struct OwnPointerJob : IJob
    {
        public fixed int Scratch[64];
        public NativeReference<int> Result;

        public void Execute()
        {
            int* first = (int*)UnsafeUtility.AddressOf(ref Scratch[0]);
            // Until then a young object, with garbage before it, on the managed heap has moved for sure.
            for (int i = 0; i < 3; i++)
                System.GC.Collect(i, System.GCCollectionMode.Forced, true, true);
            first[7] = 5;
            Result.Value += Scratch[7];
        }
    }

    [System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.NoInlining)]
    static void MakeGarbage()
    {
        for (int i = 0; i < 100; i++)
            System.GC.KeepAlive(new byte[1000]);
    }

    static NativeArray<int> Array(int length) => new NativeArray<int>(length, Allocator.Persistent);

    [Test]
    public void Job_ScheduledAndRun_WritesThroughItsCopyOfTheArray()
    {
        using NativeArray<int> values = Array(1);
        var job = new AddJob { Values = values, Amount = 3 };
        job.Schedule().Complete();
        job.ScheduleByRef().Complete();
        job.Run();
        job.RunByRef();
        Assert.That(values[0], Is.EqualTo(12));
    }

    [Test]
    public void Job_ChangedAfterSchedule_RunsWithTheScheduledValues()
    {
        using NativeArray<int> values = Array(1);
        var job = new AddJob { Values = values, Amount = 5 };
        JobHandle handle = job.ScheduleByRef();
        job.Amount = 1000;
        handle.Complete();
        Assert.That(values[0], Is.EqualTo(5));
    }

    [TestCase(0)]
    [TestCase(1)]
    [TestCase(1000)]
    public void JobFor_EveryWayToSchedule_VisitsEachIndexOnce(int length)
    {
        using NativeArray<int> single = Array(length);
        using NativeArray<int> parallel = Array(length);
        using NativeArray<int> run = Array(length);
        JobHandle a = new SquareFor { Squares = single }.Schedule(length, default);
        JobHandle b = new SquareFor { Squares = parallel }.ScheduleParallel(length, 7, a);
        new SquareFor { Squares = run }.Run(length);
        b.Complete();
        for (int i = 0; i < length; i++)
            Assert.That(new[] { single[i], parallel[i], run[i] }, Is.All.EqualTo(i * i));
    }

    [TestCase(1, 1)]
    [TestCase(10, 64)]
    [TestCase(1000, 1)]
    [TestCase(1000, 33)]
    public void JobParallelFor_AnyBatchSize_VisitsEachIndexOnce(int length, int batch)
    {
        using var roots = new NativeArray<int>(Enumerable.Range(0, length).ToArray(), Allocator.Persistent);
        using NativeArray<int> squares = Array(length);
        new SquareParallelFor { Roots = roots, Squares = squares }.Schedule(length, batch).Complete();
        for (int i = 0; i < length; i++)
            Assert.That(squares[i], Is.EqualTo(i * i));
    }

    [Test]
    public void ThreadIndex_InAJob_IsThatOfTheThreadAndInRange()
    {
        using NativeArray<int> field = Array(64);
        using NativeArray<int> utility = Array(64);
        new ThreadIndexJob { IndexOfElement = field, IndexOfUtility = utility, ThreadIndex = -1 }.Schedule(64, 1).Complete();
        Assert.That(field.ToArray(), Is.EqualTo(utility.ToArray()));
        Assert.That(field.ToArray(), Is.All.InRange(0, JobsUtility.ThreadIndexCount - 1));
    }

    [Test]
    public void Job_WithAPointerToItsOwnField_KeepsItAcrossACollection()
    {
        using var result = new NativeReference<int>(Allocator.Persistent);
        JobsUtility.JobWorkerCount = 0;
        JobHandle handle = default;
        for (int i = 0; i < 4; i++)
        {
            MakeGarbage();
            handle = new OwnPointerJob { Result = result }.Schedule(handle);
        }
        handle.Complete();
        Assert.That(result.Value, Is.EqualTo(4 * 5));
    }

    [Test]
    public void DeallocateOnJobCompletion_JobDone_FreesTheArray()
    {
        using var result = new NativeReference<int>(Allocator.Persistent);
        var values = new NativeArray<int>(new[] { 42 }, Allocator.TempJob);
        new DeallocatingJob { Values = values, Result = result }.Schedule().Complete();
        Assert.That(result.Value, Is.EqualTo(42));
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        Assert.That(() => values[0], Throws.TypeOf<System.ObjectDisposedException>());
#endif
    }

    [TestCase(0)]
    [TestCase(1)]
    [TestCase(5)]
    public void WorkerCount_Any_JobsAreDoneWhenCompleted(int workers)
    {
        JobsUtility.JobWorkerCount = workers;
        using NativeArray<int> squares = Array(500);
        JobHandle handle = new SquareFor { Squares = squares }.ScheduleParallel(500, 3, default);
        handle.Complete();
        Assert.That(handle.IsCompleted, Is.True);
        Assert.That(squares[499], Is.EqualTo(499 * 499));
    }

    [Test]
    public void WorkerCount_OutOfRange_Throws()
    {
        Assert.That(() => JobsUtility.JobWorkerCount = -1, Throws.TypeOf<System.ArgumentOutOfRangeException>());
        Assert.That(() => JobsUtility.JobWorkerCount = JobsUtility.JobWorkerMaximumCount + 1,
            Throws.TypeOf<System.ArgumentOutOfRangeException>());
    }

    [Test]
    public void ScheduledJob_NeverCompleted_RunsOnAWorker()
    {
        using NativeArray<int> values = Array(1);
        JobHandle handle = new AddJob { Values = values, Amount = 1 }.Schedule();
        JobHandle.ScheduleBatchedJobs();
        Assert.That(SpinWait.SpinUntil(() => handle.IsCompleted, 5000), Is.True);
        handle.Complete();
        Assert.That(values[0], Is.EqualTo(1));
    }
}
