#pragma warning disable CA1821, CA1822, CA1823, CS0649, CS0169, CS1998, CS4014, IDE0052, IDE0059, IDE0060

namespace FastPoints.HostTests.Threads
{
    /// <summary>Code that is never run: what Unity refuses on other threads than the main one, a fault each, and beside it what
    /// looks like it and is fine.</summary>
    internal static class PlantedThreads
    {
        private const string IsPlaying = "uses UnityEngine.Application.get_isPlaying, which is for the main thread";
        private const string Temp = "takes Allocator.Temp outside of jobs";

        internal interface IStep
        {
            void Take();
        }

        internal sealed class AskingStep : IStep
        {
            public void Take() => Ask();
        }

        internal sealed class QuietStep : IStep
        {
            public void Take() => Thread.Yield();
        }

        internal abstract class Walk
        {
            public void Go() => Step();

            public IEnumerator<int> Steps()
            {
                Step();
                yield return 1;
            }

            public IEnumerator<JobStep> Nested()
            {
                yield return JobStep.Of(Stages());
            }

            private IEnumerator<JobStep> Stages()
            {
                Step();
                yield return default;
            }

            public virtual void Rest() => Thread.Yield();
            protected abstract void Step();
        }

        internal sealed class AskingWalk : Walk
        {
            public override void Rest() => Ask();
            protected override void Step() => Ask();
        }

        internal sealed class QuietWalk : Walk
        {
            protected override void Step() => Thread.Yield();
        }

        private static bool Ask() => Application.isPlaying;

        private static IEnumerable<int> Count()
        {
            yield return 1;
            Ask();
            yield return 2;
        }

        private static int TakeTemp()
        {
            using var taken = new NativeArray<int>(4, Allocator.Temp);
            return taken.Length;
        }

        private static NativeArray<int> TakeOf(Allocator allocator) => new NativeArray<int>(4, allocator);

        [Planted("Task.Run (")]
        internal static class Direct
        {
            internal static Task Begin() => Task.Run(() => Application.isPlaying);
        }

        [Planted(IsPlaying)]
        internal static class MethodGroup
        {
            internal static Task Begin() => Task.Run(Ask);
        }

        [Planted]
        internal static class OnTheMainThread
        {
            internal static bool Begin()
            {
                bool isPlaying = Ask();
                Task.Run(() => math.sin(1));
                return isPlaying;
            }
        }

        [Planted(IsPlaying)]
        internal static class ThroughAnInterface
        {
            internal static Task Begin(bool asks)
            {
                IStep step = asks ? new AskingStep() : new QuietStep();
                return Task.Run(() => step.Take());
            }
        }

        [Planted]
        internal static class ThroughAnInterfaceThatIsKnown
        {
            internal static Task Begin()
            {
                IStep step = new QuietStep();
                return Task.Run(() => step.Take());
            }
        }

        [Planted(IsPlaying)]
        internal static class ThroughAnInterfaceOutOfAList
        {
            internal static Task Begin(List<IStep> steps) => Task.Run(() => steps[0].Take());
        }

        [Planted(IsPlaying)]
        internal static class ThroughABaseType
        {
            internal static Task Begin()
            {
                var walk = new AskingWalk();
                return Task.Run(() => walk.Go());
            }
        }

        [Planted(IsPlaying)]
        internal static class ThroughAMethodGroupOfABaseType
        {
            internal static Task Begin(Walk walk) => Task.Run(walk.Rest);
        }

        [Planted]
        internal static class ThroughABaseTypeThatIsKnown
        {
            internal static Task Begin() => Task.Run(() => new QuietWalk().Go());
        }

        [Planted(IsPlaying)]
        internal static class ThroughAnIteratorOfABaseType
        {
            internal static Task Begin() => Task.Run(() => new AskingWalk().Steps().MoveNext());
        }

        [Planted]
        internal static class ThroughAnIteratorOfABaseTypeThatIsKnown
        {
            internal static Task Begin() => Task.Run(() => new QuietWalk().Steps().MoveNext());
        }

        [Planted(IsPlaying)]
        internal static class ThroughNestedWork
        {
            internal static Task Begin() => Task.Run(() => new CoroutineStack(new AskingWalk().Nested()).MoveNext());
        }

        [Planted]
        internal static class ThroughNestedWorkThatIsKnown
        {
            internal static Task Begin() => Task.Run(() => new CoroutineStack(new QuietWalk().Nested()).MoveNext());
        }

        [Planted(IsPlaying)]
        internal static class ThroughACapture
        {
            internal static Task Begin()
            {
                Func<bool> ask = () => Application.isPlaying;
                return Task.Run(() => ask() ? 1 : 2);
            }
        }

        [Planted(IsPlaying)]
        internal static class ThroughAParameter
        {
            internal static Task Begin() => Hand(() => Ask());
            private static Task Hand(Func<bool> work) => Task.Run(work);
        }

        [Planted(IsPlaying)]
        internal sealed class ThroughAField
        {
            private readonly Func<bool> m_work = Ask;

            internal Task Begin() => Task.Run(() => m_work());
        }

        [Planted(IsPlaying)]
        internal sealed class ThroughADelegateOutOfAList
        {
            private readonly List<Func<bool>> m_work = new List<Func<bool>> { Ask };

            internal Task Begin() => Task.Run(m_work[0]);
        }

        [Planted(IsPlaying)]
        internal static class ThroughACallbackOfNet
        {
            internal static Task Begin(List<int> list) => Task.Run(() => list.ForEach(i => Ask()));
        }

        [Planted]
        internal static class KeptForTheMainThread
        {
            internal static Task Begin(Queue<Action> waiting) => Task.Run(() => waiting.Enqueue(() => Ask()));
        }

        internal sealed class AskingComparer : IComparer<int>
        {
            public int Compare(int x, int y) => Ask() ? x : y;
        }

        [Planted(IsPlaying)]
        internal static class ThroughAComparer
        {
            internal static Task Begin(List<int> list) => Task.Run(() => list.Sort(new AskingComparer()));
        }

        [Planted(IsPlaying)]
        internal static class ThroughAnIterator
        {
            internal static Task Begin() => Task.Run(() =>
            {
                foreach (int unused in Count())
                    Thread.Yield();
            });
        }

        [Planted(IsPlaying)]
        internal static class ThroughAnIteratorOfAnotherThread
        {
            internal static Task Begin()
            {
                IEnumerator<int> steps = Count().GetEnumerator();
                return Task.Run(() => steps.MoveNext());
            }
        }

        [Planted]
        internal static class IteratorThatIsOnlyMade
        {
            internal static Task Begin() => Task.Run(() => Count());
        }

        [Planted(IsPlaying)]
        internal static class ThroughAContinuation
        {
            internal static void Begin(Task task) => task.ContinueWith(t => Ask());
        }

        [Planted("Thread.ctor (")]
        internal static class OnAThread
        {
            internal static Thread Begin() => new Thread(() => Ask());
        }

        [Planted(IsPlaying)]
        internal static class OnAThreadOfThePool
        {
            internal static void Begin() => ThreadPool.QueueUserWorkItem(_ => Ask());
        }

        [Planted(IsPlaying)]
        internal static class ByATimer
        {
            internal static Timer Begin() => new Timer(_ => Ask());
        }

        [Planted(IsPlaying)]
        internal static class ByAnEventOfATimer
        {
            internal static void Begin(System.Timers.Timer timer) => timer.Elapsed += (sender, e) => Ask();
        }

        [Planted(IsPlaying)]
        internal static class ByAWatcher
        {
            internal static void Begin(FileSystemWatcher watcher) => watcher.Changed += (sender, e) => Ask();
        }

        [Planted(IsPlaying)]
        internal static class InParallel
        {
            internal static void Begin() => Parallel.For(0, 4, i => Ask());
        }

        [Planted("finalizer of ")]
        internal sealed class ByItsFinalizer
        {
            ~ByItsFinalizer() => Ask();
        }

        [Planted("constructor of ")]
        internal sealed class ByItsConstructor : ScriptableObject
        {
            private readonly bool m_isPlaying = Ask();
        }

        [Planted("constructor of ")]
        [Serializable]
        internal sealed class ByTheConstructorOfWhatIsKept
        {
            private readonly bool m_isPlaying = Ask();
        }

        [Planted("serialization of ")]
        internal sealed class ByTheSerializer : ISerializationCallbackReceiver
        {
            public void OnBeforeSerialize() { }
            public void OnAfterDeserialize() => Ask();
        }

        [Planted(IsPlaying)]
        internal static class InAnAsyncMethod
        {
            internal static Task Begin() => Task.Run(Work);

            private static async Task Work()
            {
                await Task.Delay(1);
                Ask();
            }
        }

        [Planted("after ConfigureAwait(false)")]
        internal static class AfterConfigureAwait
        {
            internal static async Task Work()
            {
                await Task.Delay(1).ConfigureAwait(false);
                Ask();
            }
        }

        [Planted]
        internal static class BeforeConfigureAwait
        {
            internal static async Task Work()
            {
                Ask();
                await Task.Delay(1);
                Ask();
                await Task.Delay(1).ConfigureAwait(false);
            }
        }

        internal static class Generic<T> where T : IStep, new()
        {
            internal static void Take() => new T().Take();
        }

        [Planted(IsPlaying)]
        internal static class ThroughAGeneric
        {
            internal static Task Begin() => Task.Run(() => Generic<AskingStep>.Take());
        }

        [Planted]
        internal static class ThroughAGenericThatIsKnown
        {
            internal static Task Begin() => Task.Run(() => Generic<QuietStep>.Take());
        }

        [Planted(IsPlaying)]
        internal sealed class InAGeneric<T> where T : IStep
        {
            private readonly T m_step;

            internal InAGeneric(T step) => m_step = step;

            internal static InAGeneric<AskingStep> Make() => new InAGeneric<AskingStep>(new AskingStep());
            internal void Begin(Task task) => task.ContinueWith(t => m_step.Take());
        }

        [Planted]
        internal sealed class InAGenericThatIsKnown<T> where T : IStep
        {
            internal static InAGenericThatIsKnown<QuietStep> Make() => new InAGenericThatIsKnown<QuietStep>();
            internal void Begin(Task<T> task) => task.ContinueWith(t => (t.Result as IStep)?.Take());
        }

        [Planted(IsPlaying)]
        internal sealed class ByACallbackOfAGeneric<T> where T : IStep
        {
            private readonly Action<T> m_done;

            internal ByACallbackOfAGeneric(Action<T> done) => m_done = done;

            internal static ByACallbackOfAGeneric<AskingStep> Make() => new ByACallbackOfAGeneric<AskingStep>(s => s.Take());
            internal void Begin(Task<T> task) => task.ContinueWith(t => m_done(t.Result));
        }

        internal static class Registry
        {
            internal static readonly bool IsPlaying = Ask();

            internal static int Number => IsPlaying ? 1 : 2;
        }

        [Planted(IsPlaying)]
        internal static class ThroughAStaticConstructor
        {
            internal static Task Begin() => Task.Run(() => Registry.Number);
        }

        [Planted("uses Unity.IO.LowLevel.Unsafe.FileHandle.Close")]
        internal sealed class ThroughAUsing : IDisposable
        {
            private readonly FileHandle m_file;

            public void Dispose() => m_file.Close();

            internal static Task Begin() => Task.Run(() =>
            {
                using var file = new ThroughAUsing();
                Thread.Yield();
            });
        }

        [Planted(Temp)]
        internal static class TempOnAThread
        {
            internal static Task Begin() => Task.Run(TakeTemp);
        }

        [Planted(Temp)]
        internal static class TempOfAnotherMethod
        {
            internal static Task Begin() => Task.Run(() => TakeOf(Allocator.Temp));
        }

        [Planted(Temp)]
        internal static class TempByAVariable
        {
            internal static Task Begin(bool isShort) => Task.Run(() =>
            {
                Allocator allocator = isShort ? Allocator.Temp : Allocator.Persistent;
                return new NativeList<int>(4, allocator).Length;
            });
        }

        [Planted(Temp)]
        internal sealed class TempByAField
        {
            private readonly Allocator m_allocator = Allocator.Temp;

            internal Task Begin() => Task.Run(() => TakeOf(m_allocator).Length);
        }

        [Planted]
        internal static class OtherMemory
        {
            internal static Task Begin() =>
                Task.Run(() => TakeOf(Allocator.TempJob).Length + TakeOf(Allocator.Persistent).Length);
        }

        [Planted]
        [BurstCompile]
        internal struct TempJob : IJob
        {
            public void Execute() => TakeTemp();
        }

        [Planted(Temp)]
        internal static class TempInAJobThatIsRunThere
        {
            internal static Task Begin() => Task.Run(() => new TempJob().Run());
        }

        [Planted("for which the manual asks for the main thread")]
        internal static class JobThatIsScheduledThere
        {
            internal static Task Begin() => Task.Run(() => new TempJob().Schedule());
        }

        [Planted(IsPlaying)]
        internal struct AskingJob : IJobParallelFor
        {
            public void Execute(int index) => Ask();
        }

        [Planted("what it runs is not to be seen")]
        internal static class NothingToRun
        {
            internal static Task Begin() => Task.Run((Action)null);
        }
    }
}

namespace UnityEngine
{
    /// <summary>Unity's, by name: the package has no use for it, so that the stand-ins do not have it.</summary>
    internal interface ISerializationCallbackReceiver
    {
        void OnBeforeSerialize();
        void OnAfterDeserialize();
    }
}
