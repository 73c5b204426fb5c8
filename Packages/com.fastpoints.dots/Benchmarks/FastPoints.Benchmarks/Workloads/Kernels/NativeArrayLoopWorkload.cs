using FastPoints.Scenes;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>A plain loop over native arrays: what indexing them costs beside raw pointers.</summary>
    public struct NativeArrayLoopWorkload : IWorkload
    {
        NativeArray<int> m_from;
        NativeArray<int> m_to;

        public string Name => "loop over native arrays";
        public string LimitName => "loop over pointers";

        public void Prepare(WorkloadContext context)
        {
            m_from = new NativeArray<int>(context.Points, Allocator.Persistent);
            m_to = new NativeArray<int>(context.Points, Allocator.Persistent);
            for (int i = 0; i < m_from.Length; i++)
                m_from[i] = (int)SceneHash.Mix((uint)i);
        }

        public WorkloadResult Run()
        {
            new ScaleArrayJob { From = m_from, To = m_to }.Run();
            return new WorkloadResult { Points = m_from.Length, Bytes = 8L * m_from.Length };
        }

        public void Dispose()
        {
            if (!m_from.IsCreated)
                return;
            m_from.Dispose();
            m_to.Dispose();
        }

        /// <summary>The loop that both workloads run: a multiply, an add and a shift an element.</summary>
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
}
