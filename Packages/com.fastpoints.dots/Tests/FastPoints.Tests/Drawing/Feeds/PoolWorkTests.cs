using System;
using System.Threading;
using System.Threading.Tasks;
using FastPoints.Core;
using FastPoints.Tests.Support;
using NUnit.Framework;

namespace FastPoints.Tests.Drawing
{
    public sealed class PoolWorkTests
    {
        static readonly TimeSpan s_mostTime = TimeSpan.FromMinutes(1);

        sealed class Thing : IDisposable
        {
            public readonly ManualResetEventSlim Disposed = new ManualResetEventSlim();

            public void Dispose() => Disposed.Set();
        }

        [Test]
        public void Take_OfWorkThatFails_IsItsFailure()
        {
            var thrown = new PointCloudException(FailureCode.NotFound, "a.las", -1, "no such file");
            var work = PoolWork.Begin<int>("cloud", () => throw thrown);
            Assert.That(Assert.Throws<PointCloudException>(() => work.Take()), Is.SameAs(thrown));
        }

        [Test]
        public void Take_OfWorkThatThrowsWhatNobodyForesaw_NamesTheFileAndSaysWhere()
        {
            var work = PoolWork.Begin<int>("cloud", () => throw new InvalidOperationException("planted"));
            var failure = Failures.Of(() => work.Take(), FailureCode.Unexpected);
            Assert.That(failure.Message, Is.EqualTo("cloud: InvalidOperationException: planted"));
            Assert.That(failure.Story, Does.StartWith(failure.Message).And.Contains(nameof(PoolWorkTests)));
        }

        [Test]
        public void Take_OfWorkThatWaitsForATaskThatFails_IsWhatTheTaskThrew()
        {
            int Fail() => throw new InvalidOperationException("planted");
            var work = PoolWork.Begin("cloud", () => Task.Run(Fail).Result);
            Assert.That(Assert.Throws<PointCloudException>(() => work.Take()).What,
                Is.EqualTo("InvalidOperationException: planted"));
        }

        [Test]
        public void TakeIfSound_OfWorkThatFails_IsNothing() =>
            Assert.That(PoolWork.Begin<string>("cloud", () => throw new InvalidOperationException("planted")).TakeIfSound(),
                Is.Null);

        [Test]
        public void Dispose_BeforeTheEnd_DisposesWhatComesOfIt()
        {
            using var goesOn = new ManualResetEventSlim();
            var thing = new Thing();
            var work = PoolWork.Begin("cloud", () =>
            {
                goesOn.Wait();
                return thing;
            }, unwanted => unwanted.Dispose());
            work.Dispose();
            Assert.That(thing.Disposed.IsSet, Is.False);
            goesOn.Set();
            Assert.That(thing.Disposed.Wait(s_mostTime), Is.True);
        }

        [Test]
        public void Dispose_AfterTheEnd_DisposesWhatNobodyTook()
        {
            var thing = new Thing();
            var work = PoolWork.Begin("cloud", () => thing, unwanted => unwanted.Dispose());
            Assert.That(SpinWait.SpinUntil(() => work.IsDone, s_mostTime), Is.True);
            work.Dispose();
            Assert.That(thing.Disposed.IsSet, Is.True);
        }

        [Test]
        public void Dispose_OfWhatWasTaken_LeavesItToWhoHasIt()
        {
            var thing = new Thing();
            var work = PoolWork.Begin("cloud", () => thing, unwanted => unwanted.Dispose());
            work.Take();
            work.Dispose();
            Assert.That(thing.Disposed.IsSet, Is.False);
        }
    }
}
