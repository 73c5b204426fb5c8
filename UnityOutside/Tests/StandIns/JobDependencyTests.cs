using Random = System.Random;

namespace UnityOutside.Tests.StandIns;

public sealed class JobDependencyTests
{
    [TearDown]
    public void DefaultWorkers() => JobsUtility.ResetJobWorkerCount();

    struct IncrementJob : IJob
    {
        public NativeArray<int> Counter;
        public int Expected;
        public NativeArray<int> Misses;

        public void Execute()
        {
            if (Counter[0] != Expected)
                Misses[0]++;
            Counter[0]++;
        }
    }

    unsafe struct CheckPredecessorsJob : IJob
    {
        [NativeDisableUnsafePtrRestriction] public int* RanOfJob;
        [NativeDisableUnsafePtrRestriction] public int* Predecessors;
        [NativeDisableUnsafePtrRestriction] public int* Misses;
        public int PredecessorCount;
        public int Self;

        public void Execute()
        {
            for (int i = 0; i < PredecessorCount; i++)
                if (System.Threading.Volatile.Read(ref RanOfJob[Predecessors[i]]) == 0)
                    System.Threading.Interlocked.Increment(ref *Misses);
            System.Threading.Volatile.Write(ref RanOfJob[Self], 1);
        }
    }

    unsafe struct CheckPredecessorsForJob : IJobFor
    {
        public CheckPredecessorsJob Check;
        [NativeDisableUnsafePtrRestriction] public int* Left;

        public void Execute(int index)
        {
            // The job counts as run when its last index has.
            for (int i = 0; i < Check.PredecessorCount; i++)
                if (System.Threading.Volatile.Read(ref Check.RanOfJob[Check.Predecessors[i]]) == 0)
                    System.Threading.Interlocked.Increment(ref *Check.Misses);
            if (System.Threading.Interlocked.Decrement(ref *Left) == 0)
                System.Threading.Volatile.Write(ref Check.RanOfJob[Check.Self], 1);
        }
    }

    struct ThrowingJob : IJob
    {
        public void Execute() => throw new ArithmeticException("thrown in a job");
    }

    struct ThrowingForJob : IJobFor
    {
        public int At;

        public void Execute(int index)
        {
            if (index == At)
                throw new ArithmeticException("thrown at an index");
        }
    }

    struct NothingJob : IJob
    {
        public void Execute() { }
    }

    [TestCase(1)]
    [TestCase(3)]
    public void Chain_OfAThousandSlices_RunsInOrder(int workers)
    {
        JobsUtility.JobWorkerCount = workers;
        using var counter = new NativeArray<int>(1, Allocator.Persistent);
        using var misses = new NativeArray<int>(1, Allocator.Persistent);
        JobHandle last = default;
        for (int i = 0; i < 1000; i++)
            last = new IncrementJob { Counter = counter, Expected = i, Misses = misses }.Schedule(last);
        last.Complete();
        Assert.That(misses[0], Is.Zero);
        Assert.That(counter[0], Is.EqualTo(1000));
    }

    [TestCase(0, 1u)]
    [TestCase(1, 2u)]
    [TestCase(2, 3u)]
    [TestCase(4, 4u)]
    [TestCase(8, 5u)]
    public unsafe void RandomGraph_AnyWorkerCount_EveryJobRunsAfterAllItDependsOn(int workers, uint seed)
    {
        JobsUtility.JobWorkerCount = workers;
        const int jobs = 3000;
        using var ran = new NativeArray<int>(jobs, Allocator.Persistent);
        using var left = new NativeArray<int>(jobs, Allocator.Persistent);
        using var predecessors = new NativeArray<int>(jobs * 4, Allocator.Persistent);
        using var misses = new NativeArray<int>(1, Allocator.Persistent);
        var handles = new JobHandle[jobs];
        var random = new Random((int)seed);
        int* listed = (int*)predecessors.GetUnsafePtr();
        int* leftOfJob = (int*)left.GetUnsafePtr();
        var check = new CheckPredecessorsJob { RanOfJob = (int*)ran.GetUnsafePtr(), Misses = (int*)misses.GetUnsafePtr() };
        for (int i = 0; i < jobs; i++)
        {
            check.Self = i;
            check.Predecessors = listed + 4 * i;
            check.PredecessorCount = i == 0 ? 0 : random.Next(0, 5);
            var dependencies = new NativeArray<JobHandle>(check.PredecessorCount, Allocator.Temp);
            for (int k = 0; k < check.PredecessorCount; k++)
            {
                // Near ones make deep graphs, far ones are often done already.
                int before = random.Next(2) == 0 ? random.Next(i) : Math.Max(0, i - 1 - random.Next(20));
                check.Predecessors[k] = before;
                dependencies[k] = handles[before];
            }
            JobHandle all = JobHandle.CombineDependencies(dependencies);
            dependencies.Dispose();
            if (random.Next(3) == 0)
            {
                int length = random.Next(1, 40);
                leftOfJob[i] = length;
                handles[i] = new CheckPredecessorsForJob { Check = check, Left = leftOfJob + i }
                    .ScheduleParallel(length, random.Next(1, 8), all);
            }
            else
            {
                handles[i] = check.Schedule(all);
            }
            if (random.Next(200) == 0)
                handles[random.Next(i + 1)].Complete();
        }
        var everything = new NativeArray<JobHandle>(handles, Allocator.Temp);
        JobHandle.CompleteAll(everything);
        everything.Dispose();
        Assert.That(misses[0], Is.Zero);
        Assert.That(ran.ToArray(), Is.All.EqualTo(1));
    }

    [Test]
    public void Combined_DeepChainWithoutWork_CompletesWithTheLastJob()
    {
        JobHandle all = default;
        for (int i = 0; i < 20000; i++)
            all = JobHandle.CombineDependencies(all, new NothingJob().Schedule());
        all.Complete();
        Assert.That(all.IsCompleted, Is.True);
    }

    [Test]
    public void CompleteAll_OfTwoAndThree_ResetsTheHandles()
    {
        JobHandle a = new NothingJob().Schedule();
        JobHandle b = new NothingJob().Schedule(a);
        JobHandle c = new NothingJob().Schedule(a);
        JobHandle d = JobHandle.CombineDependencies(a, b, c);
        JobHandle.CompleteAll(ref a, ref b, ref c);
        JobHandle.CompleteAll(ref d, ref c);
        Assert.That(new[] { a, b, c, d }, Is.All.EqualTo(default(JobHandle)));
    }

    [Test]
    public void DefaultHandle_IsCompletedAndDependsOnNothing()
    {
        JobHandle none = default;
        none.Complete();
        Assert.That(none.IsCompleted, Is.True);
        Assert.That(JobHandle.CombineDependencies(none, none), Is.EqualTo(none));
    }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
    [Test]
    public void CheckFence_DependencyOrNot_IsReported()
    {
        JobHandle a = new NothingJob().Schedule();
        JobHandle b = new NothingJob().Schedule(a);
        JobHandle c = new NothingJob().Schedule(b);
        Assert.That(JobHandle.CheckFenceIsDependencyOrDidSyncFence(a, c), Is.True);
        c.Complete();
        Assert.That(JobHandle.CheckFenceIsDependencyOrDidSyncFence(b, default), Is.True);
        JobHandle other = new NothingJob().Schedule();
        Assert.That(JobHandle.CheckFenceIsDependencyOrDidSyncFence(other, c), Is.False);
        other.Complete();
    }
#endif

    [Test]
    public void Exception_InAJob_IsLoggedAndNotThrownByComplete()
    {
        string logged = null;
        UnityEngine.Debug.s_sink = (type, text) => logged = type + ": " + text;
        try
        {
            JobHandle handle = new ThrowingJob().Schedule();
            Assert.That(() => handle.Complete(), Throws.Nothing);
            Assert.That(logged, Does.StartWith("Exception: System.ArithmeticException: thrown in a job"));
            logged = null;
            Assert.That(() => new ThrowingJob().Run(), Throws.Nothing);
            Assert.That(logged, Does.StartWith("Exception: System.ArithmeticException: thrown in a job"));
        }
        finally
        {
            UnityEngine.Debug.s_sink = null;
        }
        Assert.That(() => LoggedExceptions.ThrowFirst(), Throws.TypeOf<ArithmeticException>());
    }

    /// <summary>What else would tell: the rest of a test that nobody looks at.</summary>
    [Test]
    public void Exception_NotExpectedByATest_FailsIt()
    {
        new ThrowingJob().Schedule().Complete();
        Assert.That(() => new AsInUnityAttribute().AfterTest(null), Throws.TypeOf<ArithmeticException>());
        Assert.That(() => new AsInUnityAttribute().AfterTest(null), Throws.Nothing);
    }

    [Test]
    public void Exception_BeforeADependentJob_DependentRuns()
    {
        using var counter = new NativeArray<int>(1, Allocator.Persistent);
        using var misses = new NativeArray<int>(1, Allocator.Persistent);
        JobHandle last = new ThrowingJob().Schedule();
        for (int i = 0; i < 10; i++)
            last = new IncrementJob { Counter = counter, Expected = i, Misses = misses }.Schedule(last);
        last = JobHandle.CombineDependencies(last, new NothingJob().Schedule());
        Assert.That(() => last.CompleteAndThrow(), Throws.TypeOf<ArithmeticException>());
        Assert.That(counter[0], Is.EqualTo(10));
    }

    [TestCase(0)]
    [TestCase(77)]
    public void Exception_AtOneIndexOfAParallelJob_IsLogged(int at)
    {
        JobHandle handle = new ThrowingForJob { At = at }.ScheduleParallel(100, 5, default);
        Assert.That(() => handle.CompleteAndThrow(), Throws.TypeOf<ArithmeticException>());
    }

    static volatile bool s_ran;

    struct LoggingJob : IJob
    {
        public void Execute() => s_ran = true;
    }

    [Test]
    public void Job_Scheduled_WaitsUntilFlushed()
    {
        static void Waits(Action flush)
        {
            s_ran = false;
            JobHandle handle = new LoggingJob().Schedule();
            System.Threading.Thread.Sleep(30);
            Assert.That(s_ran, Is.False, "nobody flushed");
            flush();
            Assert.That(() => s_ran, Is.True.After(5000, 1));
            handle.Complete();
        }
        Waits(() => JobHandle.ScheduleBatchedJobs());
        Waits(() => _ = default(JobHandle).IsCompleted);
        JobHandle other = new NothingJob().Schedule();
        Waits(() => other.Complete());
    }

    [Test]
    public void Handles_OfManyShortJobs_NeverNameAnother()
    {
        // Nodes are reused: a stale handle must stay completed.
        var stale = new List<JobHandle>();
        for (int round = 0; round < 200; round++)
        {
            JobHandle handle = new NothingJob().Schedule();
            handle.Complete();
            stale.Add(handle);
        }
        foreach (JobHandle handle in stale)
            Assert.That(handle.IsCompleted, Is.True);
    }
}
