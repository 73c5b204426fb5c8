using FastPoints.Scenes;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    abstract class LoopWorkload : IWorkload
    {
        NativeArray<int> m_from, m_to;

        public abstract string Name { get; }
        public virtual string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_from = new NativeArray<int>(context.Points, Allocator.Persistent);
            m_to = new NativeArray<int>(context.Points, Allocator.Persistent);
            for (int i = 0; i < m_from.Length; i++)
                m_from[i] = (int)SceneHash.Mix((uint)i);
        }

        public WorkloadResult Run()
        {
            Run(m_from, m_to);
            return new WorkloadResult { Points = m_from.Length, Bytes = 8L * m_from.Length };
        }

        protected abstract void Run(NativeArray<int> from, NativeArray<int> to);

        public void Dispose()
        {
            if (!m_from.IsCreated)
                return;
            m_from.Dispose();
            m_to.Dispose();
        }
    }

    sealed class NativeArrayLoopWorkload : LoopWorkload
    {
        public override string Name => "loop over native arrays";
        public override string LimitName => "loop over pointers";

        protected override void Run(NativeArray<int> from, NativeArray<int> to) =>
            new ScaleArrayJob { From = from, To = to }.Run();

        [BurstCompile]
        struct ScaleArrayJob : IJob
        {
            [ReadOnly] public NativeArray<int> From;
            [WriteOnly] public NativeArray<int> To;

            public void Execute()
            {
                for (int i = 0; i < From.Length; i++)
                    To[i] = (From[i] * 31 + i) >> 3;
            }
        }
    }

    /// <summary>The loop of <see cref="NativeArrayLoopWorkload"/> over raw pointers: its limit.</summary>
    sealed unsafe class PointerLoopWorkload : LoopWorkload
    {
        public override string Name => "loop over pointers";

        protected override void Run(NativeArray<int> from, NativeArray<int> to) => new ScalePointersJob
        {
            From = (int*)from.GetUnsafeReadOnlyPtr(),
            To = (int*)to.GetUnsafePtr(),
            Length = from.Length,
        }.Run();

        [BurstCompile]
        struct ScalePointersJob : IJob
        {
            [NativeDisableUnsafePtrRestriction] public int* From;
            [NativeDisableUnsafePtrRestriction] public int* To;
            public int Length;

            public void Execute()
            {
                for (int i = 0; i < Length; i++)
                    To[i] = (From[i] * 31 + i) >> 3;
            }
        }
    }
}
