using System;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Nodes
{
    /// <summary>The working memory of chunks that become nodes one after another: the jobs of one workspace never run side by
    /// side. It is as large as the workspace's largest chunk needs.</summary>
    internal sealed class IndexWorkspace : IDisposable
    {
        readonly int m_strideBytes;
        readonly bool m_hasAverages;
        int m_capacity;

        internal OrderScratch Ordering;
        internal NativeArray<uint> Numbers;
        internal NativeArray<byte> Sorted;
        internal NativeArray<byte> Common;
        internal NativeArray<uint> Priority;
        internal NativeArray<int> NodeOfPoint;
        internal NativeArray<int> AverageOfPoint;
        internal NativeList<PointAverage> Averages;
        internal WriteScratch Writing;
        internal SampleScratch Sampling;

        public IndexWorkspace(RecordLayout records, NativeStoreLayout store)
        {
            m_strideBytes = records.StrideBytes;
            m_hasAverages = store.HasAverages;
            Ordering = new OrderScratch(Allocator.Persistent);
            Sampling = new SampleScratch(Allocator.Persistent);
            Writing = new WriteScratch(Allocator.Persistent);
            Averages = new NativeList<PointAverage>(16, Allocator.Persistent);
        }

        /// <summary>The last of the jobs so far.</summary>
        public JobHandle Last { get; internal set; }

        /// <summary>Points of the chunks that are in the workspace.</summary>
        public long Points { get; set; }

        /// <summary>Makes room for chunks of so many points. Waits for the jobs so far if there is too little: the largest
        /// comes first.</summary>
        public void Reserve(int count)
        {
            if (count <= m_capacity && Numbers.IsCreated)
                return;
            Last.Complete();
            FreePoints();
            m_capacity = Math.Max(1, count);
            const NativeArrayOptions raw = NativeArrayOptions.UninitializedMemory;
            Numbers = new NativeArray<uint>(m_capacity, Allocator.Persistent, raw);
            Sorted = new NativeArray<byte>(checked(m_capacity * m_strideBytes), Allocator.Persistent, raw);
            Common = new NativeArray<byte>(m_capacity, Allocator.Persistent, raw);
            Priority = new NativeArray<uint>(m_capacity, Allocator.Persistent, raw);
            NodeOfPoint = new NativeArray<int>(m_capacity, Allocator.Persistent, raw);
            AverageOfPoint = new NativeArray<int>(m_hasAverages ? m_capacity : 0, Allocator.Persistent, raw);
        }

        /// <summary>Schedules what the first job of the next chunk comes behind.</summary>
        public JobHandle Begin(int count, JobHandle ready)
        {
            Reserve(count);
            return new ResetWorkspaceJob
            {
                Ordering = Ordering.Progress,
                Sampling = Sampling.Progress,
                Writing = Writing.Progress,
            }.Schedule(JobHandle.CombineDependencies(ready, Last));
        }

        public void Dispose()
        {
            Last.Complete();
            if (!Averages.IsCreated)
                return;
            FreePoints();
            Ordering.Dispose();
            Averages.Dispose();
            Writing.Dispose();
            Sampling.Dispose();
        }

        void FreePoints()
        {
            if (!Numbers.IsCreated)
                return;
            Numbers.Dispose();
            Sorted.Dispose();
            Common.Dispose();
            Priority.Dispose();
            NodeOfPoint.Dispose();
            AverageOfPoint.Dispose();
        }

        /// <summary>The jobs of the next chunk begin at their first stage.</summary>
        [BurstCompile]
        struct ResetWorkspaceJob : IJob
        {
            public NativeReference<OrderScratch.State> Ordering;
            public NativeReference<SampleScratch.State> Sampling;
            public NativeReference<WriteScratch.State> Writing;

            public void Execute()
            {
                Ordering.Value = default;
                Sampling.Value = default;
                Writing.Value = default;
            }
        }
    }
}
