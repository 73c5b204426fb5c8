using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>63-bit Morton keys of seeded points with an index each, sorted; copying them in is part of it.</summary>
    public struct RadixSortWorkload : IWorkload
    {
        NativeArray<ulong> m_unsorted, m_keys, m_keyScratch;
        NativeArray<uint> m_payload, m_payloadScratch;

        public string Name => "radix sort";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_unsorted = new NativeArray<ulong>(context.Points, Allocator.Persistent);
            m_keys = new NativeArray<ulong>(context.Points, Allocator.Persistent);
            m_keyScratch = new NativeArray<ulong>(context.Points, Allocator.Persistent);
            m_payload = new NativeArray<uint>(context.Points, Allocator.Persistent);
            m_payloadScratch = new NativeArray<uint>(context.Points, Allocator.Persistent);
            var random = new Unity.Mathematics.Random(context.Seed);
            for (int i = 0; i < context.Points; i++)
                m_unsorted[i] = Morton.Encode(random.NextUInt(), random.NextUInt(), random.NextUInt());
        }

        public WorkloadResult Run()
        {
            m_keys.CopyFrom(m_unsorted);
            new RadixSortJob
            {
                Keys = m_keys,
                Payload = m_payload,
                KeyScratch = m_keyScratch,
                PayloadScratch = m_payloadScratch,
            }.Run();
            return new WorkloadResult { Points = m_keys.Length, Bytes = m_keys.Length * 12L };
        }

        public void Dispose()
        {
            m_unsorted.Dispose();
            m_keys.Dispose();
            m_keyScratch.Dispose();
            m_payload.Dispose();
            m_payloadScratch.Dispose();
        }
    }

    [BurstCompile]
    unsafe struct RadixSortJob : IJob
    {
        public NativeArray<ulong> Keys, KeyScratch;
        public NativeArray<uint> Payload, PayloadScratch;

        public void Execute() => RadixSort.Sort((ulong*)Keys.GetUnsafePtr(), (uint*)Payload.GetUnsafePtr(),
            (ulong*)KeyScratch.GetUnsafePtr(), (uint*)PayloadScratch.GetUnsafePtr(), Keys.Length);
    }
}
