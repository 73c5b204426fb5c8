using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>Checks all nodes of one file, and then the distances of its sampled points, level by level: one chain of jobs
    /// behind the read.</summary>
    sealed class FileCheck : IDisposable
    {
        const int PositionBytes = 24;

        readonly CloudManifest m_manifest;
        readonly NativeStoreLayout m_store;

        /// <summary>Contains all of the file's points.</summary>
        readonly GridCube m_cube;
        readonly bool m_isUpper;
        readonly long m_fileBytes;
        readonly StoreRead m_read = new StoreRead();
        NativeArray<SampledGroup> m_groups;
        NativeArray<int> m_firstSampled;
        NativeArray<double3> m_sampled;
        NativeArray<NodePart> m_parts;
        NativeArray<NodeCheckResult> m_planeResults;
        NativeArray<NodeCheckResult> m_results;
        NativeReference<SpacingState> m_state;
        NativeArray<int> m_scratch;
        NativeList<double3> m_atSides;

        /// <summary>Where slices of nodes, and of parts, begin; then their end.</summary>
        readonly List<int> m_nodeSlices = new List<int> { 0 }, m_partSlices = new List<int> { 0 };

        /// <param name="chunk">The chunk; negative for the upper levels, which are not sampled in one go.</param>
        /// <param name="table">The file's table, which this owns unless it is that of the upper levels.</param>
        public FileCheck(CloudFolder folder, int chunk, NativeStoreLayout store, NodeTable table)
        {
            Table = table;
            m_manifest = folder.Manifest;
            m_store = store;
            m_isUpper = chunk < 0;
            Path = m_isUpper ? folder.UpperPath : folder.ChunkPath(chunk);
            m_fileBytes = m_isUpper ? m_manifest.UpperBytes : folder.Chunks[chunk].FileBytes;
            m_cube = m_isUpper ? m_manifest.Root : folder.Chunks[chunk].Cube;
            int sampled = ListGroups(out int largest);
            m_sampled = new NativeArray<double3>(sampled, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            m_scratch = new NativeArray<int>(checked((int)ClosestPair.ScratchOf(largest)), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            m_atSides = new NativeList<double3>(Allocator.Persistent);
            m_state = new NativeReference<SpacingState>(Allocator.Persistent);
            ListParts();
            m_planeResults = new NativeArray<NodeCheckResult>(table.Nodes.Length, Allocator.Persistent);
            m_results = new NativeArray<NodeCheckResult>(m_parts.Length, Allocator.Persistent);
        }

        public string Path { get; }
        public NodeTable Table { get; }
        public JobHandle Done { get; private set; }

        /// <summary>Memory that it takes, about.</summary>
        public long Bytes => m_fileBytes + (long)m_sampled.Length * (PositionBytes + (m_isUpper ? PositionBytes : 0)) +
            4L * m_scratch.Length;

        /// <summary>Coroutine: begins the read and schedules all jobs; <see cref="Done"/> is theirs afterwards.</summary>
        public IEnumerator<JobStep> Begin()
        {
            m_read.Begin(Path, 0, m_fileBytes);
            var job = new VerifyNodesJob
            {
                File = m_read.Bytes,
                Nodes = Table.Nodes,
                Planes = Table.Planes,
                PlaneCount = Table.PlaneCount,
                Columns = m_store.Columns,
                FirstColumnOfPlane = m_store.FirstColumnOfPlane,
                Shapes = m_store.Shapes,
                AverageOf = m_store.AverageOf,
                AttributeBytes = m_store.Layout.AttributeBytes,
                Step = m_manifest.Grid.Step,
                Origin = m_manifest.Root.Corner,
                FirstSampled = m_firstSampled,
                Sampled = m_sampled,
                Parts = m_parts,
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
                }, Slices.MaxChains, isOfPlanes ? m_read.Done : Done, scheduled => Done = scheduled));
            }
            var corner = m_cube.Corner - m_manifest.Root.Corner;
            var min = new double3(corner.X, corner.Y, corner.Z) * m_manifest.Grid.Step;
            var measure = new MeasureSpacingJob
            {
                Groups = m_groups,
                Points = m_sampled,
                PlaneResults = m_planeResults,
                Results = m_results,
                CubeMin = min,
                CubeMax = min + m_manifest.Grid.Step * (double)m_cube.Side,
                IsWhole = m_isUpper,
                State = m_state,
                Scratch = m_scratch,
                AtSides = m_atSides,
            };
            yield return JobStep.Of(Slices.Schedule(MeasureSpacingJob.SlicesOf(m_groups), 1,
                (_, __, after) => measure.Schedule(after), 1, Done, scheduled => Done = scheduled));
            JobHandle.ScheduleBatchedJobs();
        }

        /// <summary>Ends the read, after <see cref="Done"/>.</summary>
        /// <returns>What is wrong with the file as a whole, or null.</returns>
        /// <exception cref="PointCloudException">The file cannot be read.</exception>
        public string FindProblem()
        {
            Done.Complete();
            m_read.Complete();
            var header = m_read.Bytes.GetSubArray(0, FileHeader.SizeBytes).Reinterpret<FileHeader>(1)[0];
            ulong magic = m_isUpper ? StoreFormat.UpperMagic : StoreFormat.ChunkMagic;
            return StoreFile.FindProblem(header, magic, m_fileBytes) ??
                (header.CloudId != m_manifest.CloudId ? "is of another cloud" : null);
        }

        /// <summary>What each node's points showed, in the nodes' order.</summary>
        public IEnumerable<NodeCheckResult> NodeResults()
        {
            int part = 0;
            for (int n = 0; n < Table.Nodes.Length; n++)
            {
                var result = NodeCheckResult.Empty;
                for (; part < m_parts.Length && m_parts[part].Node == n; part++)
                    result.Include(m_results[part]);
                if (result.What == NodeCheckResult.Fault.None && !result.HasBoundsOf(Table.Nodes[n]))
                    result.What = NodeCheckResult.Fault.Bounds;
                yield return result;
            }
        }

        /// <summary>Takes the distances of a sound file.</summary>
        /// <param name="atSides">Receives the points at the cube's sides for each level.</param>
        public void TakeDistances(List<VerifyResult.Level> levels, List<NativeList<double3>> atSides)
        {
            int first = 0;
            for (int g = 0; g < m_groups.Length; g++)
            {
                var group = m_groups[g];
                while (atSides.Count <= group.Level)
                    atSides.Add(new NativeList<double3>(16, Allocator.Persistent));
                if (group.AtSides > 0)
                    atSides[group.Level].AddRange(m_atSides.AsArray().GetSubArray(first, group.AtSides));
                first += group.AtSides;
                var level = levels[group.Level];
                if (!group.IsTop)
                    level.MinDistance = Math.Min(level.MinDistance, group.MinDistance);
                levels[group.Level] = level;
            }
        }

        public void Dispose()
        {
            if (!m_results.IsCreated)
                return;
            Done.Complete();
            m_read.Dispose();
            m_groups.Dispose();
            m_firstSampled.Dispose();
            m_sampled.Dispose();
            m_parts.Dispose();
            m_planeResults.Dispose();
            m_results.Dispose();
            m_state.Dispose();
            m_scratch.Dispose();
            m_atSides.Dispose();
            if (!m_isUpper)
                Table.Dispose();
        }

        /// <summary>Finds which points were sampled together, and where they go.</summary>
        /// <returns>The number of all of them.</returns>
        int ListGroups(out int largest)
        {
            var groups = new SortedDictionary<(int Level, bool IsTop, int SampledWith), SampledGroup>();
            for (int n = 0; n < Table.Nodes.Length; n++)
            {
                var node = Table.Nodes[n];
                if (!node.HasSpacing)
                    continue;
                var key = KeyOf(node);
                groups.TryGetValue(key, out var group);
                double spacing = math.cmin(m_manifest.Grid.Step) * math.pow(2.0, node.CellLog2);
                group.Level = key.Level;
                group.Spacing = group.Count == 0 ? spacing : Math.Min(group.Spacing, spacing);
                group.Count += node.PointCount;
                group.IsTop = key.IsTop;
                groups[key] = group;
            }
            int points = 0, count = 0;
            largest = 0;
            var next = new Dictionary<(int Level, bool IsTop, int SampledWith), int>();
            m_groups = new NativeArray<SampledGroup>(groups.Count, Allocator.Persistent);
            foreach (var entry in groups)
            {
                var group = entry.Value;
                group.First = points;
                next[entry.Key] = points;
                points = checked(points + group.Count);
                largest = Math.Max(largest, group.Count);
                m_groups[count++] = group;
            }
            m_firstSampled = new NativeArray<int>(Table.Nodes.Length, Allocator.Persistent);
            for (int n = 0; n < Table.Nodes.Length; n++)
            {
                var node = Table.Nodes[n];
                m_firstSampled[n] = node.HasSpacing ? next[KeyOf(node)] : -1;
                if (node.HasSpacing)
                    next[KeyOf(node)] += node.PointCount;
            }
            return points;
        }

        void ListParts()
        {
            const int max = VerifyNodesJob.PointsPerSlice, blocks = max / PlaneShape.MaxPointsPerBlock;
            var parts = new List<NodePart>();
            int ofNodes = 0, ofParts = 0;
            for (int n = 0; n < Table.Nodes.Length; n++)
            {
                var node = Table.Nodes[n];
                // Planes take a tenth of what their points take.
                Cut(m_nodeSlices, n, ref ofNodes, node.PointCount, 10 * max);
                for (int b = node.FirstBlock; b < node.FirstBlock + node.BlockCount; b += blocks)
                {
                    var part = new NodePart { Node = n, FirstBlock = b };
                    part.EndBlock = Math.Min(b + blocks, node.FirstBlock + node.BlockCount);
                    Cut(m_partSlices, parts.Count, ref ofParts, (part.EndBlock - b) * PlaneShape.MaxPointsPerBlock, max);
                    parts.Add(part);
                }
            }
            m_nodeSlices.Add(Table.Nodes.Length);
            m_partSlices.Add(parts.Count);
            m_parts = new NativeArray<NodePart>(parts.ToArray(), Allocator.Persistent);
        }

        /// <summary>Begins another slice if what is added does not fit into the last one.</summary>
        static void Cut(List<int> slices, int at, ref int filled, int added, int max)
        {
            if (filled > 0 && filled + added > max)
            {
                slices.Add(at);
                filled = 0;
            }
            filled += added;
        }

        (int Level, bool IsTop, int SampledWith) KeyOf(in NodeRecord node) =>
            (m_manifest.Root.SideLog2 - node.SideLog2, (node.Flags & NodeRecord.IsTop) != 0, node.SampledWith);
    }
}
