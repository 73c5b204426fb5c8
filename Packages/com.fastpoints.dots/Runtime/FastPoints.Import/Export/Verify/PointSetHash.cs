using System;
using System.Collections.Generic;
using FastPoints.Build;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Export
{
    /// <summary>Sums two independent 64-bit hashes over all points of a source, as a converted cloud would have them: 128
    /// bits that do not depend on the order. Two different multisets of points have equal sums with a probability of about
    /// 2^-128, unless they are deliberately constructed against these hashes.</summary>
    internal sealed class PointSetHash : IBlockConsumer, IDisposable
    {
        readonly PointSchema m_attributes;
        readonly RecordLayout m_layout;
        readonly SourceToGrid m_grid;
        readonly int m_capacity;
        readonly PartitionMap m_map;
        readonly List<RecordSlot> m_slots = new List<RecordSlot>();
        readonly List<NativeReference<ulong>> m_sums = new List<NativeReference<ulong>>();
        readonly List<JobHandle> m_jobs = new List<JobHandle>();

        public PointSetHash(PointSchema attributes, in SourceToGrid grid, int capacity)
        {
            m_attributes = attributes;
            m_layout = new RecordLayout(true, default, attributes.BytesPerPoint);
            m_grid = grid;
            m_capacity = capacity;
            using var none = new NativeArray<long>(1, Allocator.Persistent);
            m_map = PartitionMap.Plan(default, 0, none, 0);
        }

        public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            while (m_slots.Count <= slot)
            {
                m_slots.Add(new RecordSlot(m_capacity, m_attributes, m_layout, m_map, read.Points));
                m_sums.Add(new NativeReference<ulong>(Allocator.Persistent));
                m_jobs.Add(default);
            }
            m_jobs[slot] = new SumRecordsJob
            {
                Records = m_slots[slot].Records,
                FirstOfChunk = m_slots[slot].FirstOfChunk,
                Layout = m_layout,
                Sum = m_sums[slot],
            }.Schedule(m_slots[slot].ScheduleGrouping(read.Points, read.Result, m_grid, decoded));
            return m_jobs[slot];
        }

        public void Completed(BlockRead read, int slot) { }

        /// <summary>Takes the statistics after the scan, which include the first sum.</summary>
        public PointStatistics CollectStatistics(out ulong secondSum)
        {
            var all = PointStatistics.None;
            secondSum = 0;
            for (int s = 0; s < m_slots.Count; s++)
            {
                m_jobs[s].Complete();
                all.Include(m_slots[s].Statistics.Value);
                secondSum += m_sums[s].Value;
            }
            return all;
        }

        public void Dispose()
        {
            for (int s = 0; s < m_slots.Count; s++)
            {
                m_jobs[s].Complete();
                m_slots[s].Dispose();
                m_sums[s].Dispose();
            }
            m_slots.Clear();
            m_sums.Clear();
            m_map.Dispose();
        }
    }

    [BurstCompile]
    internal unsafe struct SumRecordsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<int> FirstOfChunk;
        public RecordLayout Layout;

        public NativeReference<ulong> Sum;

        public void Execute()
        {
            var records = (byte*)Records.GetUnsafeReadOnlyPtr();
            int count = FirstOfChunk[FirstOfChunk.Length - 1];
            ulong sum = Sum.Value;
            for (int i = 0; i < count; i++)
                sum += Layout.HashOf(records + (long)i * Layout.StrideBytes, RecordHash.SecondSeed);
            Sum.Value = sum;
        }
    }
}
