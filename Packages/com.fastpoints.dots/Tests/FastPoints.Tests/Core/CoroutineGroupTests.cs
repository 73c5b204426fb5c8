using System;
using System.Collections.Generic;
using System.Threading;
using FastPoints.Evaluation;
using NUnit.Framework;
using Unity.Jobs;

namespace FastPoints.Tests.Core
{
    public class CoroutineGroupTests
    {
        static readonly ManualResetEventSlim s_gate = new ManualResetEventSlim();
        readonly List<string> m_events = new List<string>();

        [SetUp]
        public void Forget() => m_events.Clear();

        IEnumerable<IEnumerator<JobStep>> Works(int count, int steps, int failing = -1)
        {
            for (int i = 0; i < count; i++)
                yield return One(i, steps, i == failing);
        }

        IEnumerator<JobStep> One(int number, int steps, bool isFailing)
        {
            m_events.Add("begin " + number);
            try
            {
                for (int i = 0; i < steps; i++)
                    yield return default;
                if (isFailing)
                    throw new InvalidOperationException("broken");
            }
            finally
            {
                m_events.Add("free " + number);
            }
        }

        [TestCase(1), TestCase(2), TestCase(9)]
        public void Run_SeveralWorks_BeginsEachInOrderAndNoMoreAtOnce(int atOnce)
        {
            JobCoroutine.RunToEnd(CoroutineGroup.Run(Works(5, 3), atOnce));
            int inWork = 0, max = 0, begun = 0;
            foreach (string what in m_events)
            {
                bool isBegin = what.StartsWith("begin");
                if (isBegin)
                    Assert.That(what, Is.EqualTo("begin " + begun++));
                max = Math.Max(max, inWork += isBegin ? 1 : -1);
            }
            Assert.That(begun, Is.EqualTo(5));
            Assert.That(inWork, Is.EqualTo(0));
            Assert.That(max, Is.EqualTo(Math.Min(atOnce, 5)));
        }

        [Test]
        public void Run_NoWorks_Ends() => JobCoroutine.RunToEnd(CoroutineGroup.Run(Works(0, 0), 2));

        [Test]
        public void Run_OneFails_FreesAll()
        {
            Assert.That(() => JobCoroutine.RunToEnd(CoroutineGroup.Run(Works(5, 3, failing: 1), 3)),
                Throws.InvalidOperationException.With.Message.EqualTo("broken"));
            Assert.That(m_events.FindAll(e => e.StartsWith("free")).Count, Is.EqualTo(
                m_events.FindAll(e => e.StartsWith("begin")).Count));
        }

        [Test]
        public void Run_OldestInFlight_StepsTheOthers()
        {
            s_gate.Reset();
            using var workers = new WorkerCount(1);
            var coroutine = new JobCoroutine(CoroutineGroup.Run(new[] { Waiting(), One(1, 5, false) }, 2));
            try
            {
                for (int i = 0; i < 100 && !m_events.Contains("free 1"); i++)
                    coroutine.Tick(2);
                Assert.That(m_events, Does.Contain("free 1"));
                Assert.That(coroutine.IsDone, Is.False);
                s_gate.Set();
                for (int i = 0; i < 1000 && !coroutine.Tick(2); i++)
                    Thread.Sleep(1);
                Assert.That(coroutine.IsDone, Is.True);
            }
            finally
            {
                s_gate.Set();
                coroutine.Cancel();
            }
        }

        static IEnumerator<JobStep> Waiting()
        {
            var job = default(GateJob).Schedule();
            try
            {
                yield return job;
            }
            finally
            {
                job.Complete();
            }
        }

        struct GateJob : IJob
        {
            public void Execute() => s_gate.Wait();
        }
    }
}
