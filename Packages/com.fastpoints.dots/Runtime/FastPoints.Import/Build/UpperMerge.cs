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
        /// <summary>Sixteen neighbours are merged into a region of at least this many points: each round leaves fewer, and a
        /// small cloud has one.</summary>
        const int MinPointsPerRegion = 16 * StoreFormat.MaxPointsPerNode;

        /// <summary>Tops that are read from files at the same time.</summary>
        const int MaxReadsInFlight = 8;

        readonly BuildContext m_build;
        readonly NativeStoreLayout m_store;
        readonly CloudManifest m_manifest;
        readonly List<UpperRegion> m_regions = new List<UpperRegion>();
        readonly List<UpperItem> m_items = new List<UpperItem>();
        ChunkIndexer m_indexer;
        IndexWorkspace m_workspace;
        readonly List<UpperItem> m_attached = new List<UpperItem>(); // Chunks with nodes.
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

        /// <summary>Coroutine: writes the upper levels' containers and the hierarchy's pages, and adds them to the
        /// manifest.</summary>
        /// <param name="chunks">In Morton order, with rising numbers; all, or those that are finished.</param>
        /// <param name="topRecords">By chunk; if there are none, they are in the chunk's file. They stay the caller's.</param>
        public IEnumerator<JobStep> Run(IReadOnlyList<ChunkResult> chunks, NativeArray<byte>[] topRecords, StageProgress progress)
        {
            m_indexer = m_build.CreateIndexer(m_store, m_manifest);
            m_workspace = m_build.CreateWorkspace(m_store);
            long left = 0;
            for (int i = 0; i < chunks.Count; i++)
            {
                left += chunks[i].TopPoints;
                m_items.Add(new UpperItem
                {
                    Cube = chunks[i].Container.Cube,
                    Top = chunks[i].Top,
                    TopPoints = chunks[i].TopPoints,
                    Chunk = chunks[i],
                    Records = topRecords[chunks[i].Number],
                });
            }

            long pointsPerRegion = MaxPointsOf(m_build.Plan);
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
            yield return JobStep.Of(WriteHierarchy());
            progress?.Report(1, m_upperPoints, m_upperBytes);
        }

        public void Dispose()
        {
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
                var container = new ContainerRecord { Cube = cube, Kind = ContainerKind.Upper };
                if (m_manifest.IsBuilding)
                    container.Part = checked((int)m_manifest.Generation);
                m_indexer.BeginUpper(records, tops, container, isRoot, m_workspace);
                yield return m_indexer.Job;
                m_indexer.Job.Complete();
                m_build.Slices.Take(m_indexer.SliceTimes);

                var region = TakeRegion(container);
                bool hasNodes = Attach(members, tops, region) || region.Part.NodeCount > 0;
                if (!isRoot)
                    m_items.Add(TopOf(region, cube, hasNodes));
                yield return JobStep.Of(WriteNodes(region.Part));
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
            read.Begin(m_build.Folder.PathOf(BuildFiles.TopPath(member.Chunk.Number)), member.Chunk.RecordsOffset,
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
                var attach = members[i].Region ?? members[i].Above;
                attach.Above = region;
                attach.AttachDraft = tops[i].AttachNode;
                if (members[i].Chunk != null && members[i].Top.HasNodes)
                    m_attached.Add(members[i]);
            }
            return hasNodes;
        }

        /// <summary>Writes a region's container, unless it has no nodes.</summary>
        IEnumerator<JobStep> WriteNodes(HierarchyPart part)
        {
            var file = m_indexer.File.AsArray();
            if (part.NodeCount == 0)
                yield break;
            var ticket = m_build.Folder.Write(StoreFormat.PathOf(part.Container), file);
            try
            {
                while (!ticket.IsDone(1))
                    yield return default;
                m_upperBytes += file.Length;
                m_upperPoints += PointsOf(file);
            }
            finally
            {
                ticket.Wait();
            }
        }

        static long PointsOf(NativeArray<byte> file) => ((FileHeader*)file.GetUnsafeReadOnlyPtr())->PointCount;

        UpperRegion TakeRegion(ContainerRecord container)
        {
            var region = new UpperRegion { NodeOfDraft = m_indexer.NodeOfDraft.AsArray().ToArray() };
            region.Part.Cube = container.Cube;
            region.Part.Table = new NativeArray<byte>(m_indexer.Table.AsArray(), Allocator.Persistent);
            region.Part.NodeCount = m_indexer.Table.Length / ChunkResult.BytesPerNode(BytesOfPlane.Length);
            if (region.Part.NodeCount > 0)
                region.Part.Container = ((FileHeader*)m_indexer.File.GetUnsafeReadOnlyPtr())->Container;
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

        IEnumerator<JobStep> WriteHierarchy()
        {
            var folder = m_build.Folder;
            string name = m_manifest.HierarchyName;
            IEnumerator<JobStep> WritePiece(NativeArray<byte> bytes, long offset) =>
                CloudFolderWriter.Await(folder.WritePiece(name, bytes, offset));
            using var writer =
                new HierarchyWriter(BytesOfPlane.Length, m_manifest.CloudId, FileHeader.SizeBytes, LoadTable, WritePiece);
            yield return JobStep.Of(writer.Write(JoinParts(), root =>
            {
                m_manifest.NodeCount = root.NodeCount;
                m_manifest.RootOffset = root.OffsetBytes;
                m_manifest.RootBytes = root.LengthBytes;
                m_manifest.RootHash = root.Hash;
            }));
            m_manifest.HierarchyBytes = writer.Offset;
            m_manifest.ChunkCount = m_attached.Count;
            using var header = new NativeArray<byte>(HeaderOfHierarchy(), Allocator.Persistent);
            yield return JobStep.Of(CloudFolderWriter.Await(folder.Seal(name, header)));
        }

        /// <summary>Hangs chunks and regions on the nodes that they are attached to.</summary>
        /// <returns>The root.</returns>
        HierarchyPart JoinParts()
        {
            // The last one is the root: others come after what is above them.
            m_regions.Reverse();
            for (int r = 0; r < m_regions.Count; r++)
            {
                var region = m_regions[r];
                region.Part.SampledWith = r;
                if (r > 0 && region.Part.NodeCount > 0)
                    region.Attach(region.Part);
            }
            foreach (var item in m_attached)
                item.Above.Attach(new HierarchyPart
                {
                    Cube = item.Cube,
                    Container = item.Chunk.Container,
                    NodeCount = item.Chunk.NodeCount,
                    Table = item.Chunk.Table,
                    Chunk = item.Chunk,
                });
            foreach (var region in m_regions)
                region.Part.SortBelow(m_manifest.Root.Corner);
            return m_regions.Count > 0 ? m_regions[0].Part : new HierarchyPart();
        }

        /// <summary>Reads a chunk's nodes back.</summary>
        IEnumerator<JobStep> LoadTable(HierarchyPart part)
        {
            using var read = new StoreRead();
            read.Begin(m_build.Folder.PathOf(BuildFiles.TopPath(part.Chunk.Number)), part.Chunk.TableOffset,
                part.Chunk.TableBytes);
            yield return read.Done;
            read.Complete();
            part.Table = new NativeArray<byte>(read.Bytes, Allocator.Persistent);
        }

        byte[] HeaderOfHierarchy()
        {
            var header = new FileHeader
            {
                Magic = StoreFormat.HierarchyMagic,
                Version = StoreFormat.Version,
                PlaneCount = BytesOfPlane.Length,
                Container = new ContainerRecord
                {
                    Cube = m_manifest.Root,
                    Kind = ContainerKind.Hierarchy,
                    FileBytes = m_manifest.HierarchyBytes,
                    Hash = m_manifest.RootHash,
                },
                PointCount = m_manifest.Points,
                CloudId = m_manifest.CloudId,
            };
            header.HeaderHash = StoreFile.HashOf(header);
            return new ReadOnlySpan<byte>(&header, FileHeader.SizeBytes).ToArray();
        }
    }

    /// <summary>Where the nodes of a chunk or a region are attached: to a draft of the region above.</summary>
    internal class UpperPlace
    {
        public UpperRegion Above;
        public int AttachDraft;

        /// <summary>Hangs a part on its node, possibly in a region further above.</summary>
        public void Attach(HierarchyPart part)
        {
            var place = this;
            while (place.Above.NodeOfDraft[place.AttachDraft] < 0)
                place = place.Above;
            place.Above.Part.Below.Add((place.Above.NodeOfDraft[place.AttachDraft], part));
        }
    }

    /// <summary>Upper nodes of one merge: those above a few chunks, or above other regions. The top node of a
    /// region, like a chunk's, belongs to the region above; the root's has none above. Owns its table.</summary>
    internal sealed class UpperRegion : UpperPlace, IDisposable
    {
        public readonly HierarchyPart Part = new HierarchyPart();

        /// <summary>For each draft, its node in the table, or -1 for the top that belongs to the region above.</summary>
        public int[] NodeOfDraft;

        public void Dispose() => Part.DisposeTable();
    }

    /// <summary>The merge's next input: a chunk's top, or a region's.</summary>
    internal sealed class UpperItem
    {
        public GridCube Cube;
        public ChunkTop Top;
        public int TopPoints;

        /// <summary>The chunk or the region whose top it is; the other is null.</summary>
        public ChunkResult Chunk;
        public UpperRegion Region;

        /// <summary>Of a chunk.</summary>
        public readonly UpperPlace Above = new UpperPlace();

        /// <summary>The top's records, if they are in memory.</summary>
        public NativeArray<byte> Records;
    }
}
