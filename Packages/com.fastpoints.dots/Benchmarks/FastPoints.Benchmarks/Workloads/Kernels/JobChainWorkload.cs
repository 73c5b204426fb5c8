using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>1,000 empty slices in a chain, scheduled at once: what a slice costs beside its work. Points are
    /// slices.</summary>
    public struct JobChainWorkload : IWorkload
    {
        const int Slices = 1000;

        NativeReference<int> m_count;
        JobHandle m_last;

        public string Name => "job chain of 1,000 slices";
        public string LimitName => null;

        public void Prepare(WorkloadContext context) => m_count = new NativeReference<int>(Allocator.Persistent);

        public WorkloadResult Run()
        {
            m_count.Value = 0;
            m_last = default;
            for (int i = 0; i < Slices; i++)
                m_last = new CountSliceJob { Count = m_count }.Schedule(m_last);
            JobHandle.ScheduleBatchedJobs();
            m_last.Complete();
            return new WorkloadResult { Points = m_count.Value };
        }

        public void Dispose()
        {
            m_last.Complete();
            if (m_count.IsCreated)
                m_count.Dispose();
        }

        [BurstCompile]
        struct CountSliceJob : IJob
        {
            public NativeReference<int> Count;

            public void Execute() => Count.Value++;
        }
    }
}
