using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>From the chunks' tops to the upper levels. If there are too many tops for one merge, neighbours become
    /// regions with their own tops, and so on: memory is that of one region for any number of chunks.</summary>
    internal sealed unsafe class UpperMerge : IDisposable
    {
        /// <summary>Eight neighbours are merged into a region of at least this many points: each round leaves fewer.</summary>
        const int MinPointsPerRegion = 8 * StoreFormat.MaxPointsPerNode;

        /// <summary>Tops that are read from files at the same time.</summary>
        const int MaxReadsInFlight = 8;

        readonly BuildContext m_build;
        readonly NativeStoreLayout m_store;
        readonly CloudManifest m_manifest;
        readonly List<UpperRegion> m_regions = new List<UpperRegion>();
        readonly List<UpperItem> m_items = new List<UpperItem>();
        ChunkIndexer m_indexer;
        IndexWorkspace m_workspace;
        UpperRegion[] m_regionOfChunk;
        int[] m_draftOfChunk;
        WriteTicket m_whole;
        long m_upperBytes;
        long m_upperPoints;

        public UpperMerge(BuildContext build, NativeStoreLayout store, CloudManifest manifest)
        {
            m_build = build;
            m_store = store;
            m_manifest = manifest;
            BytesOfPlane = new long[store.Layout.Planes.Count];
        }

        /// <summary>The most points of tops in one merge: more are merged in regions first.</summary>
        public static long MaxPointsOf(MemoryPlan plan) => Math.Max(plan.PointsPerChunk, MinPointsPerRegion);

        public int LowestSideLog2 { get; private set; } = int.MaxValue;
        public long[] BytesOfPlane { get; }

        /// <summary>Coroutine: writes upper.bin and hierarchy.bin, and adds them to the manifest.</summary>
        /// <param name="chunks">In Morton order, with rising numbers; all, or those that are finished.</param>
        /// <param name="topRecords">By chunk; if there are none, they are in the chunk's file. They stay the caller's.</param>
        public IEnumerator<JobStep> Run(IReadOnlyList<ChunkResult> chunks, NativeArray<byte>[] topRecords, StageProgress progress)
        {
            m_indexer = m_build.CreateIndexer(m_store, m_manifest);
            m_workspace = m_build.CreateWorkspace(m_store);
            int last = chunks.Count > 0 ? chunks[chunks.Count - 1].Record.Number : -1;
            m_regionOfChunk = new UpperRegion[last + 1];
            m_draftOfChunk = new int[last + 1];
            long left = 0;
            for (int i = 0; i < chunks.Count; i++)
            {
                left += chunks[i].TopPoints;
                m_items.Add(new UpperItem
                {
                    Cube = chunks[i].Record.Cube,
                    Top = chunks[i].Top,
                    TopPoints = chunks[i].TopPoints,
                    Chunk = chunks[i].Record.Number,
                    Records = topRecords[chunks[i].Record.Number],
                });
            }

            long pointsPerRegion = MaxPointsOf(m_build.Plan);
            m_upperBytes = FileHeader.SizeBytes;
            while (left > pointsPerRegion)
            {
                var groups = CubeGroups.Of(m_manifest.Root, m_items, i => i.Cube, i => i.TopPoints, pointsPerRegion);
                if (groups.Count == m_items.Count)
                    break;
                var below = m_items.ToArray();
                m_items.Clear();
                left = 0;
                foreach (var group in groups)
                {
                    if (group.Count == 1)
                    {
                        m_items.Add(below[group.First]);
                    }
                    else
                    {
                        var members = new List<UpperItem>(new ArraySegment<UpperItem>(below, group.First, group.Count));
                        yield return JobStep.Of(MergeRegion(members, group.Cube, false));
                    }
                    left += m_items[m_items.Count - 1].TopPoints;
                    progress?.Report(0.5 * (group.First + group.Count) / below.Length, 0, 0);
                }
            }
            if (m_items.Count > 0)
                yield return JobStep.Of(MergeRegion(new List<UpperItem>(m_items), m_manifest.Root, true));
            yield return JobStep.Of(WriteHierarchy(chunks));
            progress?.Report(1, m_upperPoints, m_upperBytes);
        }

        public void Dispose()
        {
            m_whole?.Wait();
            m_indexer?.Dispose();
            m_workspace?.Dispose();
            foreach (var region in m_regions)
                region.Dispose();
            foreach (var item in m_items)
                if (item.Region != null && item.Records.IsCreated)
                    item.Records.Dispose();
            m_items.Clear();
        }

        /// <summary>Makes the nodes above some tops. The region's own top is added to the items, unless it is the root.</summary>
        IEnumerator<JobStep> MergeRegion(List<UpperItem> members, GridCube cube, bool isRoot)
        {
            long points = 0;
            foreach (var member in members)
                points += member.TopPoints;
            var records = new NativeArray<byte>(checked((int)(points * TopStride)), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            var tops = new NativeArray<ChunkTop>(members.Count, Allocator.Persistent);
            try
            {
                yield return JobStep.Of(GatherTops(members, records, tops));
                m_indexer.BeginUpper(records, tops, cube, isRoot, m_workspace);
                yield return m_indexer.Job;
                m_indexer.Job.Complete();
                m_build.Slices.Take(m_indexer.SliceTimes);

                var region = TakeRegion();
                bool hasNodes = Attach(members, tops, region) || region.NodeCount > 0;
                if (!isRoot)
                    m_items.Add(TopOf(region, cube, hasNodes));
                yield return JobStep.Of(WriteNodes(region, isRoot));
            }
            finally
            {
                m_indexer.Job.Complete();
                tops.Dispose();
                records.Dispose();
            }
        }

        int TopStride => m_build.Records.ForTops(m_store.HasAverages).StrideBytes;

        /// <summary>Gathers the members' records from memory or from the chunks' files.</summary>
        IEnumerator<JobStep> GatherTops(List<UpperItem> members, NativeArray<byte> records, NativeArray<ChunkTop> tops)
        {
            int stride = TopStride, at = 0, begun = 0;
            var reads = new StoreRead[members.Count];
            try
            {
                for (int i = 0; i < members.Count; i++)
                {
                    var member = members[i];
                    int bytes = member.TopPoints * stride;
                    for (; begun < members.Count && begun - i < MaxReadsInFlight; begun++)
                        reads[begun] = BeginRead(members[begun]);
                    if (member.Records.IsCreated)
                    {
                        NativeArray<byte>.Copy(member.Records, 0, records, at, bytes);
                        if (member.Region != null)
                            member.Records.Dispose();
                        member.Records = default;
                    }
                    else
                    {
                        yield return reads[i].Done;
                        reads[i].Complete();
                        NativeArray<byte>.Copy(reads[i].Bytes, 0, records, at, bytes);
                        reads[i].Dispose();
                    }
                    var top = member.Top;
                    top.First = at / stride;
                    at += bytes;
                    top.End = at / stride;
                    tops[i] = top;
                    yield return default;
                }
            }
            finally
            {
                foreach (var read in reads)
                    read?.Dispose();
            }
        }

        /// <summary>Reads a chunk's top back; null if it is in memory.</summary>
        StoreRead BeginRead(UpperItem member)
        {
            if (member.Records.IsCreated)
                return null;
            var read = new StoreRead();
            read.Begin(m_build.Folder.PathOf(BuildFiles.TopPath(member.Chunk)), ChunkResult.RecordsOffset(BytesOfPlane.Length),
                member.TopPoints * TopStride);
            return read;
        }

        /// <summary>Records the region's node that each member is attached to.</summary>
        /// <returns>Whether one of them has nodes.</returns>
        bool Attach(List<UpperItem> members, NativeArray<ChunkTop> tops, UpperRegion region)
        {
            bool hasNodes = false;
            for (int i = 0; i < members.Count; i++)
            {
                hasNodes |= tops[i].HasNodes;
                if (members[i].Region != null)
                {
                    members[i].Region.Above = region;
                    members[i].Region.AttachDraft = tops[i].AttachNode;
                }
                else
                {
                    m_regionOfChunk[members[i].Chunk] = region;
                    m_draftOfChunk[members[i].Chunk] = tops[i].AttachNode;
                }
            }
            return hasNodes;
        }

        /// <summary>Appends the region's nodes to those of upper.bin. The root comes last and completes the
        /// header.</summary>
        IEnumerator<JobStep> WriteNodes(UpperRegion region, bool isRoot)
        {
            WriteTicket ticket = null;
            try
            {
                var file = m_indexer.File.AsArray();
                if (isRoot && m_upperPoints == 0)
                {
                    m_upperBytes = file.Length;
                    m_upperPoints = file.Length > 0 ? PointsOf(file) : 0;
                    // The hierarchy is queued after it, and awaited.
                    m_whole = m_build.Folder.Write(m_manifest.UpperName, file);
                    yield break;
                }
                if (file.Length > 0)
                {
                    region.PlaneShift = m_upperBytes - FileHeader.SizeBytes;
                    var planes = file.GetSubArray(FileHeader.SizeBytes, file.Length - FileHeader.SizeBytes);
                    ticket = m_build.Folder.WritePiece(m_manifest.UpperName, planes, m_upperBytes);
                    m_upperBytes += planes.Length;
                    m_upperPoints += PointsOf(file);
                }
                while (ticket != null && !ticket.IsDone(1))
                    yield return default;
                if (!isRoot || region.PlaneShift == 0)
                    yield break;
                DescribeAll(file);
                ticket = m_build.Folder.Seal(m_manifest.UpperName, file.GetSubArray(0, FileHeader.SizeBytes));
                while (!ticket.IsDone(1))
                    yield return default;
            }
            finally
            {
                ticket?.Wait();
            }
        }

        static long PointsOf(NativeArray<byte> file) => ((FileHeader*)file.GetUnsafeReadOnlyPtr())->PointCount;

        /// <summary>Turns the header of one region's file into that of the whole file.</summary>
        void DescribeAll(NativeArray<byte> file)
        {
            var header = (FileHeader*)file.GetUnsafePtr();
            header->PointCount = m_upperPoints;
            header->TableOffset = header->FileBytes = m_upperBytes;
            header->HeaderHash = ContentHash.Of(header, FileHeader.SizeBytes - sizeof(ulong));
        }

        UpperRegion TakeRegion()
        {
            var region = new UpperRegion
            {
                Table = new NativeArray<byte>(m_indexer.Table.AsArray(), Allocator.Persistent),
                NodeOfDraft = m_indexer.NodeOfDraft.AsArray().ToArray(),
            };
            foreach (int node in region.NodeOfDraft)
                region.NodeCount += node >= 0 ? 1 : 0;
            foreach (var draft in m_indexer.Drafts.AsArray())
                LowestSideLog2 = Math.Min(LowestSideLog2, draft.SideLog2);
            for (int p = 0; p < BytesOfPlane.Length; p++)
                BytesOfPlane[p] += m_indexer.BytesOfPlane[p];
            m_regions.Add(region);
            return region;
        }

        UpperItem TopOf(UpperRegion region, GridCube cube, bool hasNodes)
        {
            var top = m_indexer.Drafts[0];
            return new UpperItem
            {
                Cube = cube,
                Region = region,
                TopPoints = top.Count,
                Records = new NativeArray<byte>(m_indexer.Top.AsArray(), Allocator.Persistent),
                Top = new ChunkTop
                {
                    SideLog2 = top.SideLog2,
                    CellLog2 = top.CellLog2,
                    IsLeaf = top.IsLeaf,
                    HasNodes = hasNodes,
                    AttachNode = -1,
                },
            };
        }

        IEnumerator<JobStep> WriteHierarchy(IReadOnlyList<ChunkResult> chunks)
        {
            // The last one is the root: others come after what is above them.
            m_regions.Reverse();
            int planeCount = BytesOfPlane.Length;
            var table = UpperTable.Join(m_regions, planeCount, out int[] indexOfNode);
            var hierarchy = default(NativeArray<byte>);
            WriteTicket ticket = null;
            try
            {
                m_manifest.NodeCount = indexOfNode.Length;
                m_manifest.UpperBytes = indexOfNode.Length > 0 ? m_upperBytes : 0;
                var records = new List<ChunkRecord>();
                foreach (var chunk in chunks)
                {
                    if (!chunk.Top.HasNodes)
                        continue;
                    var record = chunk.Record;
                    record.AttachNode = indexOfNode[m_regionOfChunk[record.Number].NodeOf(m_draftOfChunk[record.Number])];
                    m_manifest.NodeCount += record.NodeCount;
                    records.Add(record);
                }
                m_manifest.ChunkCount = records.Count;
                hierarchy = HierarchyFile.Create(table, indexOfNode.Length, planeCount, records, m_manifest);
                ticket = m_build.Folder.Write(m_manifest.HierarchyName, hierarchy);
                while (!ticket.IsDone(1))
                    yield return default;
            }
            finally
            {
                ticket?.Wait();
                if (hierarchy.IsCreated)
                    hierarchy.Dispose();
                table.Dispose();
            }
        }
    }
}
