using FastPoints.Scenes;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>The loop of <see cref="NativeArrayLoopWorkload"/> over raw pointers: its limit.</summary>
    public unsafe struct PointerLoopWorkload : IWorkload
    {
        NativeArray<int> m_from;
        NativeArray<int> m_to;

        public string Name => "loop over pointers";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_from = new NativeArray<int>(context.Points, Allocator.Persistent);
            m_to = new NativeArray<int>(context.Points, Allocator.Persistent);
            for (int i = 0; i < m_from.Length; i++)
                m_from[i] = (int)SceneHash.Mix((uint)i);
        }

        public WorkloadResult Run()
        {
            new ScalePointersJob
            {
                From = (int*)m_from.GetUnsafeReadOnlyPtr(),
                To = (int*)m_to.GetUnsafePtr(),
                Length = m_from.Length,
            }.Run();
            return new WorkloadResult { Points = m_from.Length, Bytes = 8L * m_from.Length };
        }

        public void Dispose()
        {
            if (!m_from.IsCreated)
                return;
            m_from.Dispose();
            m_to.Dispose();
        }

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
