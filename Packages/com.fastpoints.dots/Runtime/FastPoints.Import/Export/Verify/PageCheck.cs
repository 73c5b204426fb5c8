using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Export
{
    sealed class PageCheck : IDisposable
    {
        readonly NativeStoreLayout m_store;
        readonly bool m_isRoot;
        readonly RemoteFile m_remote;
        readonly RemoteFile m_remoteOfComputed;
        readonly string m_pathOfComputed;
        readonly ByteRange m_bytes;
        readonly ByteRange m_computedBytes;
        readonly StoreRead m_read = new StoreRead();
        readonly StoreRead m_computed = new StoreRead();
        NativeArray<NodeBlockRange> m_parts;
        NativeArray<NodeCheckResult> m_planeResults;
        NativeArray<NodeCheckResult> m_results;

        /// <summary>Where slices of nodes, and of parts, begin; then their end.</summary>
        readonly List<int> m_nodeSlices = new List<int> { 0 }, m_partSlices = new List<int> { 0 };

        /// <param name="table">The page's table, which this owns unless it is the folder's.</param>
        public PageCheck(CloudFolder folder, int page, NativeStoreLayout store, NodeTable table)
        {
            Table = table;
            m_store = store;
            m_isRoot = page == 0;
            m_remote = folder.PlanesRemoteOf(page);
            Path = folder.PlanesPathOf(page);
            int built = table.PlaneCount - store.Layout.ComputedPlaneCount;
            m_bytes = ByteRange.Of(table, 0, built);
            m_computedBytes = ByteRange.Of(table, built, table.PlaneCount);
            (m_remoteOfComputed, m_pathOfComputed) = built < table.PlaneCount
                ? (folder.RemoteOfComputed(page), folder.PathOfComputed(page)) : (m_remote, Path);
            ListParts();
            m_planeResults = new NativeArray<NodeCheckResult>(table.Nodes.Length, Allocator.Persistent);
            m_results = new NativeArray<NodeCheckResult>(m_parts.Length, Allocator.Persistent);
        }

        public string Path { get; }
        public NodeTable Table { get; }
        public JobHandle Jobs { get; private set; }

        public long Bytes => m_bytes.Count + m_computedBytes.Count;

        /// <summary>Coroutine: begins the read and schedules all jobs; <see cref="Jobs"/> is theirs afterwards.</summary>
        public IEnumerator<JobStep> Begin()
        {
            m_read.Begin(Path, m_bytes.First, m_bytes.Count, m_remote);
            m_computed.Begin(m_pathOfComputed, m_computedBytes.First, m_computedBytes.Count, m_remoteOfComputed);
            while (!m_read.IsFetched || !m_computed.IsFetched)
                yield return default;
            var read = JobHandle.CombineDependencies(m_read.Done, m_computed.Done);
            var job = new VerifyNodesJob
            {
                File = m_read.Bytes,
                FileOffset = m_bytes.First,
                Computed = m_computed.Bytes,
                ComputedOffset = m_computedBytes.First,
                ComputedPlaneCount = m_store.Layout.ComputedPlaneCount,
                Nodes = Table.Nodes,
                Planes = Table.PlaneRanges,
                PlaneCount = Table.PlaneCount,
                Columns = m_store.Columns,
                FirstColumnOfPlane = m_store.FirstColumnOfPlane,
                Shapes = m_store.Shapes,
                AverageOf = m_store.AverageOf,
                AttributeBytes = m_store.Layout.AttributeBytes,
                Ranges = m_parts,
                PlaneResults = m_planeResults,
                Results = m_results,
            };
            foreach (bool isOfPlanes in new[] { true, false })
            {
                var slices = isOfPlanes ? m_nodeSlices : m_partSlices;
                yield return JobStep.Of(Slices.Schedule(slices.Count - 1, 1, (slice, _, after) =>
                {
                    job.ChecksPlanes = isOfPlanes;
                    job.First = slices[slice];
                    job.End = slices[slice + 1];
                    return job.Schedule(after);
                }, Slices.MaxChains, isOfPlanes ? read : Jobs, scheduled => Jobs = scheduled));
            }
            JobHandle.ScheduleBatchedJobs();
        }

        /// <summary>Ends the read, after <see cref="Jobs"/>.</summary>
        /// <exception cref="PointCloudException">The file cannot be read.</exception>
        public void End()
        {
            Jobs.Complete();
            m_read.Complete();
            m_computed.Complete();
        }

        public IEnumerable<NodeCheckResult> NodeResults()
        {
            int part = 0;
            for (int n = 0; n < Table.Nodes.Length; n++)
            {
                var result = NodeCheckResult.Empty;
                for (; part < m_parts.Length && m_parts[part].Node == n; part++)
                    result.Include(m_results[part]);
                if (result.Fault == NodeFault.None && !result.HasBoundsOf(Table.Nodes[n]))
                    result.Fault = NodeFault.Bounds;
                yield return result;
            }
        }

        public void Dispose()
        {
            if (!m_results.IsCreated)
                return;
            Jobs.Complete();
            m_read.Dispose();
            m_computed.Dispose();
            m_parts.Dispose();
            m_planeResults.Dispose();
            m_results.Dispose();
            if (!m_isRoot)
                Table.Dispose();
        }

        struct ByteRange
        {
            public long First;
            public long Count;

            public static ByteRange Of(NodeTable table, int firstPlane, int endPlane)
            {
                long first = long.MaxValue, end = 0;
                for (int i = 0; i < table.PlaneRanges.Length; i++)
                {
                    var range = table.PlaneRanges[i];
                    if (range.LengthBytes == 0 || i % table.PlaneCount < firstPlane || i % table.PlaneCount >= endPlane)
                        continue;
                    first = Math.Min(first, range.OffsetBytes);
                    end = Math.Max(end, range.OffsetBytes + range.LengthBytes);
                }
                return new ByteRange { First = Math.Min(first, end), Count = Math.Max(0, end - first) };
            }
        }

        void ListParts()
        {
            const int max = VerifyNodesJob.PointsPerSlice, blocks = max / PlaneShape.MaxPointsPerBlock;
            var parts = new List<NodeBlockRange>();
            int ofNodes = 0, ofParts = 0;
            for (int n = 0; n < Table.Nodes.Length; n++)
            {
                var node = Table.Nodes[n];
                // Planes take a tenth of what their points take.
                Cut(m_nodeSlices, n, ref ofNodes, node.PointCount, 10 * max);
                for (int b = node.FirstBlock; b < node.FirstBlock + node.BlockCount; b += blocks)
                {
                    var part = new NodeBlockRange { Node = n, FirstBlock = b };
                    part.EndBlock = Math.Min(b + blocks, node.FirstBlock + node.BlockCount);
                    Cut(m_partSlices, parts.Count, ref ofParts, (part.EndBlock - b) * PlaneShape.MaxPointsPerBlock, max);
                    parts.Add(part);
                }
            }
            m_nodeSlices.Add(Table.Nodes.Length);
            m_partSlices.Add(parts.Count);
            m_parts = new NativeArray<NodeBlockRange>(parts.ToArray(), Allocator.Persistent);
        }

        static void Cut(List<int> slices, int at, ref int filled, int added, int max)
        {
            if (filled > 0 && filled + added > max)
            {
                slices.Add(at);
                filled = 0;
            }
            filled += added;
        }
    }
}
