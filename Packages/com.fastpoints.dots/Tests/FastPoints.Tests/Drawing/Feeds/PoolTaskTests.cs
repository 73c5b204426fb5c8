using System;
using System.Threading;
using System.Threading.Tasks;
using NUnit.Framework;

namespace FastPoints.Tests.Drawing
{
    public sealed class PoolTaskTests
    {
        static readonly TimeSpan s_maxTime = TimeSpan.FromMinutes(1);

        sealed class DisposableResult : IDisposable
        {
            public readonly ManualResetEventSlim Disposed = new ManualResetEventSlim();

            public void Dispose() => Disposed.Set();
        }

        [Test]
        public void Take_FailedTask_ThrowsItsFailure()
        {
            var thrown = new PointCloudException(FailureCode.NotFound, "a.las", -1, "no such file");
            var work = PoolTask.Begin<int>("cloud", () => throw thrown);
            Assert.That(Assert.Throws<PointCloudException>(() => work.Take()), Is.SameAs(thrown));
        }

        [Test]
        public void Take_UnexpectedException_NamesTheFile()
        {
            var work = PoolTask.Begin<int>("cloud", () => throw new InvalidOperationException("planted"));
            var failure = Failures.Of(() => work.Take(), FailureCode.Unexpected);
            Assert.That(failure.Message, Is.EqualTo("cloud: InvalidOperationException: planted"));
            Assert.That(failure.FullMessage, Does.StartWith(failure.Message).And.Contains(nameof(PoolTaskTests)));
        }

        [Test]
        public void Take_AwaitedTaskFailed_ThrowsItsException()
        {
            int Fail() => throw new InvalidOperationException("planted");
            var work = PoolTask.Begin("cloud", () => Task.Run(Fail).Result);
            Assert.That(Assert.Throws<PointCloudException>(() => work.Take()).What,
                Is.EqualTo("InvalidOperationException: planted"));
        }

        [Test]
        public void TakeOrDefault_FailedTask_IsDefault() =>
            Assert.That(PoolTask.Begin<string>("cloud", () => throw new InvalidOperationException("planted")).TakeOrDefault(),
                Is.Null);

        [Test]
        public void Dispose_BeforeTheEnd_DisposesTheLaterResult()
        {
            using var hasMore = new ManualResetEventSlim();
            var thing = new DisposableResult();
            var work = PoolTask.Begin("cloud", () =>
            {
                hasMore.Wait();
                return thing;
            }, unwanted => unwanted.Dispose());
            work.Dispose();
            Assert.That(thing.Disposed.IsSet, Is.False);
            hasMore.Set();
            Assert.That(thing.Disposed.Wait(s_maxTime), Is.True);
        }

        [Test]
        public void Dispose_AfterTheEnd_DisposesTheUntakenResult()
        {
            var thing = new DisposableResult();
            var work = PoolTask.Begin("cloud", () => thing, unwanted => unwanted.Dispose());
            Assert.That(SpinWait.SpinUntil(() => work.IsDone, s_maxTime), Is.True);
            work.Dispose();
            Assert.That(thing.Disposed.IsSet, Is.True);
        }

        [Test]
        public void Dispose_TakenResult_IsLeftToItsOwner()
        {
            var thing = new DisposableResult();
            var work = PoolTask.Begin("cloud", () => thing, unwanted => unwanted.Dispose());
            work.Take();
            work.Dispose();
            Assert.That(thing.Disposed.IsSet, Is.False);
        }
    }
}
