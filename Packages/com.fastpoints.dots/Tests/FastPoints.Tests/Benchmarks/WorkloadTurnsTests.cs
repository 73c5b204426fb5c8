using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Benchmarks;
using NUnit.Framework;

namespace FastPoints.Tests.Benchmarks
{
    [Category("Smoke")]
    public sealed class WorkloadTurnsTests
    {
        sealed class LoggingWorkload : IWorkload
        {
            readonly List<string> m_log;
            readonly Action m_run;

            public LoggingWorkload(string name, string limit, List<string> log, Action run = null)
            {
                Name = name;
                LimitName = limit;
                m_log = log;
                m_run = run;
            }

            public string Name { get; }
            public string LimitName { get; }

            public void Prepare(WorkloadContext context) => m_log.Add("prepare " + Name);

            public WorkloadResult Run()
            {
                m_log.Add(Name);
                m_run?.Invoke();
                return new WorkloadResult { Points = 10, Error = 0.5, ErrorUnit = "m" };
            }

            public void Dispose() => m_log.Add("dispose " + Name);
        }

        static TurnSettings Settings(int turns) => new TurnSettings
        {
            Turns = turns,
            WarmUpRuns = 1,
            MinWarmUpRuns = 1,
            WarmUpMs = 0,
            LongWarmUpMs = 0,
            ShortestSampleMs = 0,
        };

        [Test]
        public void Take_AWorkloadAndItsLimit_TimesThemInTurns()
        {
            var log = new List<string>();
            var group = new IWorkload[] { new LoggingWorkload("limit", null, log), new LoggingWorkload("work", "limit", log) };

            List<WorkloadSamples> samples = WorkloadTurns.Run(group, new WorkloadContext(), Settings(2));

            Assert.That(log, Is.EqualTo(new[]
            {
                "prepare limit", "limit", "prepare work", "work", "limit", "work", "limit", "work",
                "dispose limit", "dispose work",
            }));
            Assert.That(samples.Select(s => s.Ms.Count), Is.EqualTo(new[] { 2, 2 }));
            Assert.That(samples[0].HasLimit, Is.False);
            Assert.That(samples[1].RatioToLimit.Count(), Is.EqualTo(2));
        }

        [Test]
        public void Take_AWorkloadThatThrows_DisposesAll()
        {
            var log = new List<string>();
            var group = new IWorkload[] { new LoggingWorkload("limit", null, log),
                new LoggingWorkload("work", "limit", log, () => throw new InvalidOperationException()) };

            Assert.That(() => WorkloadTurns.Run(group, new WorkloadContext(), Settings(1)), Throws.InvalidOperationException);
            Assert.That(log, Does.Contain("dispose limit").And.Contain("dispose work"));
        }

        [Test]
        public void Take_ShortRuns_AreRepeatedWithinASample()
        {
            var log = new List<string>();
            TurnSettings settings = Settings(1);
            settings.ShortestSampleMs = 1e9;

            WorkloadTurns.Run(new IWorkload[] { new LoggingWorkload("short", null, log) }, new WorkloadContext(), settings);

            Assert.That(log.Count(l => l == "short"), Is.EqualTo(1 + 1000), "one to warm up, and as many as a sample may have");
        }

        [Test]
        public void Take_AllocatedBytes_AreGivenByRun()
        {
            long allocated = 0;
            TurnSettings settings = Settings(3);
            settings.AllocatedBytes = () => allocated;

            var samples =
                WorkloadTurns.Run(new IWorkload[] { new LoggingWorkload("work", null, new List<string>(), () =>
                    allocated += 64) },
                new WorkloadContext(), settings);

            Assert.That(samples[0].MedianGarbageBytes, Is.EqualTo(64));
        }

        [Test]
        public void Groups_WorkloadWithALimit_HasItsLimitFirst()
        {
            var log = new List<string>();
            var all = new IWorkload[] { new LoggingWorkload("a", "z", log), new LoggingWorkload("b", null, log),
                new LoggingWorkload("z", null, log) };

            Assert.That(WorkloadTurns.Groups(all, new[] { all[0] }).Select(g => string.Join(" ", g.Select(w => w.Name))),
                Is.EqualTo(new[] { "z a" }));
            Assert.That(WorkloadTurns.Groups(all, all).Select(g => g.Count), Is.EqualTo(new[] { 2, 1 }));
        }

        [Test]
        public void Groups_OfAllWorkloads_ContainEachOnceAndEveryLimit()
        {
            List<IWorkload> all = WorkloadList.All();
            List<IWorkload> grouped = WorkloadTurns.Groups(all, all).SelectMany(g => g).ToList();

            Assert.That(grouped.Select(w => w.Name), Is.EquivalentTo(all.Select(w => w.Name)).And.Unique);
            Assert.That(all.Where(w => w.LimitName != null).Select(w => w.LimitName).Distinct(),
                Is.SubsetOf(all.Select(w => w.Name)));
        }
    }
}
