using System;
using System.Collections.Generic;
using FastPoints.Files;
using FastPoints.Octree;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Pipeline
{
    /// <summary>Takes every block of a source into the chunks of a partition. Owns the records until they are handed over.</summary>
    public sealed class ScatterPoints : IBlockConsumer, IDisposable
    {
        /// <summary>What one block in flight needs.</summary>
        sealed class Slot : IDisposable
        {
            public NativeArray<byte> Records;
            public NativeArray<int> FirstOfChunk;
            public NativeArray<int> ChunkOfPoint;
            public NativeArray<RecordField> Fields;
            public NativeReference<PointFindings> Findings;
            public NativeArray<AttributeFindings> Attributes;

            public Slot(int capacity, int strideBytes, int chunks, PointSchema attributes, PointBatch batch)
            {
                Records = new NativeArray<byte>(checked(Math.Max(1, capacity) * strideBytes), Allocator.Persistent,
                    NativeArrayOptions.UninitializedMemory);
                FirstOfChunk = new NativeArray<int>(chunks + 1, Allocator.Persistent);
                ChunkOfPoint = new NativeArray<int>(Math.Max(1, capacity), Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
                Findings = new NativeReference<PointFindings>(PointFindings.None, Allocator.Persistent);
                Attributes = new NativeArray<AttributeFindings>(attributes.Count, Allocator.Persistent);
                Fields = new NativeArray<RecordField>(attributes.Count, Allocator.Persistent);
                int offset = 0;
                for (int a = 0; a < attributes.Count; a++)
                {
                    Attributes[a] = AttributeFindings.None;
                    Fields[a] = new RecordField
                    {
                        Column = batch.Column(batch.Schema.IndexOf(attributes[a].Name)),
                        RecordOffset = offset,
                        Attribute = a,
                    };
                    offset += attributes[a].Type.SizeOf();
                }
            }

            public void Dispose()
            {
                Records.Dispose();
                FirstOfChunk.Dispose();
                ChunkOfPoint.Dispose();
                Fields.Dispose();
                Findings.Dispose();
                Attributes.Dispose();
            }
        }

        readonly PointSchema m_attributes;
        readonly RecordLayout m_layout;
        readonly PartitionMap m_map;
        readonly CellFinder m_cells;
        readonly List<Slot> m_slots = new List<Slot>();
        NativeArray<RecordPages> m_chunks;
        SourceGrid m_grid;
        int m_capacity;
        JobHandle m_lastAppend;

        public ScatterPoints(PointSchema attributes, RecordLayout layout, PartitionMap map)
        {
            m_attributes = attributes;
            m_layout = layout;
            m_map = map;
            m_cells = new CellFinder(map.Cube, map.Levels);
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
                m_slots.Add(new Slot(m_capacity, m_layout.StrideBytes, m_map.Chunks.Length + 1, m_attributes, read.Points));
            var s = m_slots[slot];
            var batch = read.Points;
            var grouped = new GroupRecordsJob
            {
                Columns = batch.Bytes,
                Decoded = read.Result,
                X = batch.Column(batch.Schema.IndexOf(AttributeNames.X)),
                Y = batch.Column(batch.Schema.IndexOf(AttributeNames.Y)),
                Z = batch.Column(batch.Schema.IndexOf(AttributeNames.Z)),
                Fields = s.Fields,
                Grid = m_grid,
                Layout = m_layout,
                Cells = m_cells,
                ChunkOfCell = m_map.ChunkOfCell,
                Records = s.Records,
                FirstOfChunk = s.FirstOfChunk,
                ChunkOfPoint = s.ChunkOfPoint,
                Findings = s.Findings,
                Attributes = s.Attributes,
            }.Schedule(decoded);
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
