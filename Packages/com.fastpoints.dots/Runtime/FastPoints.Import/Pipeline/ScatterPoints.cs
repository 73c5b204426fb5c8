using System;
using System.Collections.Generic;
using FastPoints.Files;
using FastPoints.Octree;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Pipeline
{
    /// <summary>Takes every block of a source into the chunks of a partition. Owns the records until they are handed
    /// over.</summary>
    public sealed class ScatterPoints : IBlockConsumer, IDisposable
    {
        readonly PointSchema m_attributes;
        readonly RecordLayout m_layout;
        readonly PartitionMap m_map;
        readonly List<RecordSlot> m_slots = new List<RecordSlot>();
        NativeArray<RecordPages> m_chunks;
        SourceGrid m_grid;
        int m_capacity;
        JobHandle m_lastAppend;

        public ScatterPoints(PointSchema attributes, RecordLayout layout, PartitionMap map)
        {
            m_attributes = attributes;
            m_layout = layout;
            m_map = map;
            m_chunks = new NativeArray<RecordPages>(map.Chunks.Length + 1, Allocator.Persistent);
            Attributes = new AttributeFindings[attributes.Count];
            for (int a = 0; a < Attributes.Length; a++)
                Attributes[a] = AttributeFindings.None;
        }

        /// <summary>Of all sources that have ended.</summary>
        public PointFindings Findings { get; private set; } = PointFindings.None;

        /// <summary>By attribute, of all sources that have ended.</summary>
        public AttributeFindings[] Attributes { get; }

        /// <summary>Records by chunk of the partition, the last those outside. Elements may be taken over and emptied.</summary>
        public NativeArray<RecordPages> Chunks => m_chunks;

        /// <summary>Before a source's scan.</summary>
        /// <param name="capacity">Points of its largest block.</param>
        public void BeginSource(in SourceGrid grid, int capacity)
        {
            m_grid = grid;
            m_capacity = capacity;
        }

        public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            while (m_slots.Count <= slot)
                m_slots.Add(new RecordSlot(m_capacity, m_attributes, m_layout, m_map, read.Points));
            var s = m_slots[slot];
            var grouped = s.ScheduleGrouping(read, m_grid, decoded);
            m_lastAppend = new AppendRecordsJob
            {
                Records = s.Records,
                FirstOfChunk = s.FirstOfChunk,
                StrideBytes = m_layout.StrideBytes,
                Chunks = m_chunks,
            }.Schedule(JobHandle.CombineDependencies(grouped, m_lastAppend));
            return m_lastAppend;
        }

        public void Completed(BlockRead read, int slot)
        {
        }

        /// <summary>After a source's scan: takes in what it showed.</summary>
        /// <returns>Of this source.</returns>
        public PointFindings EndSource()
        {
            m_lastAppend.Complete();
            m_lastAppend = default;
            var source = PointFindings.None;
            foreach (var slot in m_slots)
            {
                source.Include(slot.Findings.Value);
                for (int a = 0; a < Attributes.Length; a++)
                    Attributes[a].Include(slot.Attributes[a]);
                slot.Dispose();
            }
            m_slots.Clear();
            var all = Findings;
            all.Include(source);
            Findings = all;
            return source;
        }

        public void Dispose()
        {
            m_lastAppend.Complete();
            foreach (var slot in m_slots)
                slot.Dispose();
            m_slots.Clear();
            if (!m_chunks.IsCreated)
                return;
            for (int c = 0; c < m_chunks.Length; c++)
            {
                var pages = m_chunks[c];
                pages.Free();
            }
            m_chunks.Dispose();
        }
    }
}
