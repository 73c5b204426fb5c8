using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Tests.Core
{
    public class JobCoroutineTests
    {
        readonly List<string> m_events = new List<string>();
        Action m_atInnermost;

        [SetUp]
        public void Forget()
        {
            m_events.Clear();
            m_atInnermost = () => { };
        }

        IEnumerator<JobStep> Level(int levels)
        {
            try
            {
                m_events.Add("begin " + levels);
                if (levels == 1)
                    m_atInnermost();
                yield return default;
                if (levels > 1)
                    yield return JobStep.Of(Level(levels - 1));
                yield return default;
                m_events.Add("end " + levels);
            }
            finally
            {
                m_events.Add("free " + levels);
            }
        }

        [Test]
        public void RunToEnd_NestedWork_RunsInOrder()
        {
            JobCoroutine.RunToEnd(Level(3));
            Assert.That(m_events, Is.EqualTo(new[]
            {
                "begin 3", "begin 2", "begin 1", "end 1", "free 1", "end 2", "free 2", "end 3", "free 3",
            }));
        }

        [Test]
        public void Tick_JobWithoutWorkers_RunsIt()
        {
            using var workers = new WorkerCount(0);
            using var value = new NativeReference<int>(Allocator.Persistent);
            var coroutine = new JobCoroutine(Setting(value));
            for (int tick = 0; tick < 1000 && !coroutine.IsDone; tick++)
                coroutine.Tick(2);
            bool isDone = coroutine.IsDone;
            coroutine.Cancel();
            Assert.That(isDone, Is.True);
            Assert.That(value.Value, Is.EqualTo(7));
        }

        [Test]
        public void Tick_ShortJobsInARow_DoesNotTakeATickForEach()
        {
            s_gate.Set();
            using var workers = new WorkerCount(1);
            var coroutine = new JobCoroutine(Waits(40), () => 0);
            Assert.That(coroutine.Tick(8), Is.True);
            Assert.That(coroutine.FailedSpins, Is.Zero);
        }

        [Test]
        public void Tick_LongJobsInARow_RarelyWaitsForThem()
        {
            using var workers = new WorkerCount(1);
            double nowMs = 0;
            int ticks = 0;
            var coroutine = new JobCoroutine(Waits(40), () => nowMs += 0.1);
            for (; !coroutine.IsDone; ticks++)
            {
                s_gate.Reset();
                coroutine.Tick(16);
                s_gate.Set();
                Thread.Sleep(1);
            }
            Assert.That(coroutine.FailedSpins, Is.GreaterThan(0).And.LessThanOrEqualTo(5 + ticks / 16));
        }

        /// <summary>By a clock that stands as soon as a short look would be over; only then can the job end.</summary>
        [TestCase(24, true)]
        [TestCase(16, false)]
        public void Tick_WithMoreTimeThanAFrame_WaitsForAJobAsLong(int budgetMs, bool waits)
        {
            s_gate.Reset();
            using var workers = new WorkerCount(1);
            int nowMs = 0;
            var coroutine = new JobCoroutine(Waits(1), () =>
            {
                if (nowMs == 10)
                    s_gate.Set();
                return nowMs = Math.Min(nowMs + 1, 10);
            });
            Assert.That(coroutine.Tick(budgetMs), Is.EqualTo(waits));
            s_gate.Set();
            coroutine.Cancel();
        }

        static readonly ManualResetEventSlim s_gate = new ManualResetEventSlim();

        static IEnumerator<JobStep> Waits(int jobs)
        {
            var job = default(JobHandle);
            try
            {
                for (int i = 0; i < jobs; i++)
                {
                    job = default(BusyJob).Schedule();
                    yield return job;
                    job.Complete();
                }
            }
            finally
            {
                job.Complete();
            }
        }

        struct BusyJob : IJob
        {
            public void Execute()
            {
                s_gate.Wait();
                var watch = Stopwatch.StartNew();
                while (watch.Elapsed.TotalMilliseconds < 0.1)
                    Thread.Yield();
            }
        }

        static IEnumerator<JobStep> Setting(NativeReference<int> value)
        {
            var job = new SetJob { Value = value }.Schedule();
            try
            {
                yield return job;
            }
            finally
            {
                job.Complete();
            }
        }

        struct SetJob : IJob
        {
            public NativeReference<int> Value;

            public void Execute() => Value.Value = 7;
        }

        [Test]
        public void MoveNext_StepsOfAllLevels_AreCounted()
        {
            int steps = 0;
            using (var work = new CoroutineStack(Level(3)))
                while (work.MoveNext())
                    steps++;
            Assert.That(steps, Is.EqualTo(6));
        }

        [Test]
        public void RunToEnd_CancelledInTheInnermostLevel_DisposesFromTheInside()
        {
            using var cancellation = new CancellationTokenSource();
            m_atInnermost = cancellation.Cancel;
            Assert.That(() =>
                JobCoroutine.RunToEnd(Level(3), cancellation.Token), Throws.InstanceOf<OperationCanceledException>());
            Assert.That(m_events, Is.EqualTo(new[] { "begin 3", "begin 2", "begin 1", "free 1", "free 2", "free 3" }));
        }

        [Test]
        public void RunToEnd_ExceptionInTheInnermostLevel_DisposesAllAndIsThrown()
        {
            m_atInnermost = () => throw new InvalidOperationException("broken");
            Assert.That(() => JobCoroutine.RunToEnd(Level(3)), Throws.InvalidOperationException.With.Message.EqualTo("broken"));
            Assert.That(m_events, Is.EqualTo(new[] { "begin 3", "begin 2", "begin 1", "free 1", "free 2", "free 3" }));
        }

        [Test]
        public void Dispose_WhereFreeingFails_FreesTheOtherLevels()
        {
            var work = new CoroutineStack(FailingToFree());
            for (int i = 0; i < 2; i++)
                Assert.That(work.MoveNext(), Is.True);
            Assert.That(() => work.Dispose(), Throws.InvalidOperationException);
            Assert.That(m_events, Is.EqualTo(new[] { "free inner", "free outer" }));
            Assert.That(work.MoveNext(), Is.False);
        }

        IEnumerator<JobStep> FailingToFree()
        {
            try
            {
                yield return default;
                yield return JobStep.Of(Inner());
            }
            finally
            {
                m_events.Add("free outer");
            }

            IEnumerator<JobStep> Inner()
            {
                try
                {
                    yield return default;
                }
                finally
                {
                    m_events.Add("free inner");
                    throw new InvalidOperationException("freeing failed");
                }
            }
        }
    }
}
