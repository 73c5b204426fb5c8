using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>From the chunks' tops to the upper levels. Where too many tops are in a cube, those of each octant become a
    /// region with a top of its own, and so on: memory is that of one region for any number of chunks.</summary>
    /// <remarks>What becomes a region depends on the tops in the cube around it alone. So a cube's upper levels are the same
    /// whether its octants were collected before, by other builds, or not.</remarks>
    internal sealed unsafe class UpperMerge : IDisposable
    {
        const int MaxReadsInFlight = 8;

        readonly BuildContext m_build;
        readonly NativeStoreLayout m_store;
        readonly CloudManifest m_manifest;
        readonly List<UpperRegion> m_regions = new List<UpperRegion>();
        readonly List<MergeInput> m_added = new List<MergeInput>();
        List<MergeInput> m_unmerged = new List<MergeInput>();
        ChunkIndexer m_indexer;
        IndexWorkspace m_workspace;
        long m_upperBytes;
        long m_upperPoints;

        public UpperMerge(BuildContext build, NativeStoreLayout store, CloudManifest manifest)
        {
            m_build = build;
            m_store = store;
            m_manifest = manifest;
            BytesOfPlane = new long[store.Layout.Planes.Count];
        }

        public int MinSideLog2 { get; private set; } = int.MaxValue;
        public long[] BytesOfPlane { get; }

        public int TopStride => m_build.RecordLayout.ForTops(m_store.HasAverages).StrideBytes;

        public IReadOnlyList<MergeInput> Added => m_added;

        /// <summary>Those that nothing was made above of yet: added ones and tops of regions, in Morton order once they are
        /// collected.</summary>
        public IReadOnlyList<MergeInput> Unmerged => m_unmerged;
        public IReadOnlyList<UpperRegion> Regions => m_regions; // Each after those below it.

        /// <summary>Coroutine: writes the upper levels' containers and the hierarchy's pages, and adds them to the
        /// manifest.</summary>
        /// <param name="chunks">In Morton order, with rising numbers; all, or those that are finished.</param>
        /// <param name="topRecords">By chunk; if there are none, they are in the chunk's file. They stay the caller's.</param>
        public IEnumerator<JobStep> Run(IReadOnlyList<ChunkResult> chunks, NativeArray<byte>[] topRecords, StageProgress progress)
        {
            foreach (var chunk in chunks)
                Add(chunk, topRecords[chunk.Number]);
            yield return JobStep.Of(Collect(m_manifest.Root, progress));
            yield return JobStep.Of(MergeRoot());
            yield return JobStep.Of(WriteHierarchy());
            progress?.Report(1, m_upperPoints, m_upperBytes);
        }

        /// <param name="topRecords">They stay the caller's; if there are none, they are in the chunk's file.</param>
        public void Add(ChunkResult chunk, NativeArray<byte> topRecords) => Add(new MergeInput
        {
            Cube = chunk.Container.Cube,
            Top = chunk.Top,
            TopPoints = chunk.TopPoints,
            Chunk = chunk,
            Records = topRecords,
            Path = topRecords.IsCreated ? null : m_build.Folder.PathOf(BuildFiles.TopPath(chunk.Number)),
            RecordsOffset = chunk.RecordsOffset,
        });

        public void Add(MergeInput item)
        {
            m_added.Add(item);
            m_unmerged.Add(item);
        }

        /// <summary>Coroutine: merges regions of a cube that holds all that were added, until the tops left are few enough for
        /// one merge; more are left only of one place.</summary>
        /// <param name="progress">May be null.</param>
        public IEnumerator<JobStep> Collect(GridCube cube, StageProgress progress)
        {
            m_unmerged = InMortonOrder(cube);
            var left = new List<MergeInput>();
            yield return JobStep.Of(Collect(cube, new ArraySegment<MergeInput>(m_unmerged.ToArray()), left, progress));
            m_unmerged = left;
        }

        /// <summary>Coroutine: merges all that are left into the root's region.</summary>
        public IEnumerator<JobStep> MergeRoot()
        {
            if (m_unmerged.Count > 0)
                yield return JobStep.Of(MergeRegion(m_unmerged, m_manifest.Root, true));
            m_unmerged = new List<MergeInput>();
        }

        public void Dispose()
        {
            m_indexer?.Dispose();
            m_workspace?.Dispose();
            foreach (var region in m_regions)
                region.Dispose();
        }

        /// <summary>The order is stable: several chunks of one cube keep theirs.</summary>
        List<MergeInput> InMortonOrder(GridCube cube)
        {
            var order = new int[m_unmerged.Count];
            for (int i = 0; i < order.Length; i++)
                order[i] = i;
            Array.Sort(order, (a, b) =>
            {
                int byPosition =
                    MortonOrder.Compare(m_unmerged[a].Cube.Corner - cube.Corner, m_unmerged[b].Cube.Corner - cube.Corner);
                return byPosition != 0 ? byPosition : a.CompareTo(b);
            });
            return new List<MergeInput>(Array.ConvertAll(order, i => m_unmerged[i]));
        }

        /// <param name="left">Receives what is left of the items, in their order.</param>
        IEnumerator<JobStep> Collect(GridCube cube, ArraySegment<MergeInput> items, List<MergeInput> left, StageProgress progress)
        {
            long limit = m_build.Plan.PointsPerRegion;
            if (items.Count <= 1 || cube.SideLog2 == 0 || PointsOf(items) <= limit)
            {
                left.AddRange(items);
                progress?.Report(0.5 * (items.Offset + items.Count) / items.Array.Length, m_upperPoints, m_upperBytes);
                yield break;
            }
            var ofOctants = new List<(GridCube Cube, List<MergeInput> Left)>();
            long points = 0;
            for (int first = 0, end = 0; first < items.Count; first = end)
            {
                var octant = cube.Child(cube.OctantOf(items[first].Cube.Corner));
                while (end < items.Count && octant.Contains(items[end].Cube.Corner))
                    end++;
                var of = (Cube: octant, Left: new List<MergeInput>());
                ofOctants.Add(of);
                yield return JobStep.Of(Collect(octant, items.Slice(first, end - first), of.Left, progress));
                points += PointsOf(of.Left);
                // A cube around it all does not matter.
                if (end == items.Count && ofOctants.Count == 1 || points <= limit)
                    continue;
                foreach (var done in ofOctants)
                    if (done.Left.Count > 1)
                        yield return JobStep.Of(MergeRegion(done.Left, done.Cube, false));
            }
            foreach (var done in ofOctants)
                left.AddRange(done.Left);
        }

        static long PointsOf(IReadOnlyList<MergeInput> items)
        {
            long points = 0;
            foreach (var item in items)
                points += item.TopPoints;
            return points;
        }

        /// <summary>Makes the nodes above some tops.</summary>
        /// <param name="members">At the end the region's own top is there in their place, unless it is the root.</param>
        IEnumerator<JobStep> MergeRegion(List<MergeInput> members, GridCube cube, bool isRoot)
        {
            m_indexer ??= m_build.CreateIndexer(m_store, m_manifest);
            m_workspace ??= m_build.CreateWorkspace(m_store);
            var records = new NativeArray<byte>(checked((int)(PointsOf(members) * TopStride)), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            var tops = new NativeArray<TopNode>(members.Count, Allocator.Persistent);
            try
            {
                yield return JobStep.Of(GatherTops(members, records, tops));
                var container = new ContainerRecord { Cube = cube, Kind = ContainerKind.Upper };
                if (m_manifest.IsBuilding)
                    container.Part = checked((int)m_manifest.Generation);
                m_indexer.BeginUpper(records, tops, container, isRoot, m_workspace);
                yield return m_indexer.Job;
                m_indexer.Job.Complete();
                m_build.SliceTimes.TakeFrom(m_indexer.SliceTimes);

                var region = TakeRegion(container);
                bool hasNodes = Attach(members, tops, region) || region.Subtree.NodeCount > 0;
                members.Clear();
                if (!isRoot)
                    members.Add(region.Item = TopOf(region, cube, hasNodes));
                yield return JobStep.Of(WriteNodes(region.Subtree));
            }
            finally
            {
                m_indexer.Job.Complete();
                tops.Dispose();
                records.Dispose();
            }
        }

        IEnumerator<JobStep> GatherTops(List<MergeInput> members, NativeArray<byte> records, NativeArray<TopNode> tops)
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
                        StoreFile.CheckHash(member.Path, member.RecordsOffset, reads[i].Bytes, member.RecordsHash);
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

        /// <summary>Reads a top back; null if it is in memory.</summary>
        StoreRead BeginRead(MergeInput member)
        {
            if (member.Records.IsCreated)
                return null;
            var read = new StoreRead();
            read.Begin(member.Path, member.RecordsOffset, member.TopPoints * TopStride);
            return read;
        }

        /// <summary>Records the region's node that each member is attached to.</summary>
        /// <returns>Whether one of them has nodes.</returns>
        bool Attach(List<MergeInput> members, NativeArray<TopNode> tops, UpperRegion region)
        {
            bool hasNodes = false;
            for (int i = 0; i < members.Count; i++)
            {
                hasNodes |= tops[i].HasNodes;
                members[i].AttachPoint.Above = region;
                members[i].AttachPoint.AttachDraft = tops[i].AttachNode;
            }
            return hasNodes;
        }

        /// <summary>Writes a region's container, unless it has no nodes.</summary>
        IEnumerator<JobStep> WriteNodes(Subtree subtree)
        {
            var file = m_indexer.File.AsArray();
            if (subtree.NodeCount == 0)
                yield break;
            yield return JobStep.Of(CloudFolderWriter.Await(m_build.Folder.Write(StoreFormat.PathOf(subtree.Container), file)));
            m_upperBytes += file.Length;
            m_upperPoints += PointsIn(file);
        }

        static long PointsIn(NativeArray<byte> file) => ((FileHeader*)file.GetUnsafeReadOnlyPtr())->PointCount;

        UpperRegion TakeRegion(ContainerRecord container)
        {
            var region = new UpperRegion { NodeOfDraft = m_indexer.NodeOfDraft.AsArray().ToArray() };
            region.Subtree.Cube = container.Cube;
            region.Subtree.Table = new NativeArray<byte>(m_indexer.Table.AsArray(), Allocator.Persistent);
            region.Subtree.NodeCount = m_indexer.Table.Length / ChunkResult.BytesPerNode(BytesOfPlane.Length);
            if (region.Subtree.NodeCount > 0)
                region.Subtree.Container = ((FileHeader*)m_indexer.File.GetUnsafeReadOnlyPtr())->Container;
            foreach (var draft in m_indexer.Drafts.AsArray())
                MinSideLog2 = Math.Min(MinSideLog2, draft.SideLog2);
            for (int p = 0; p < BytesOfPlane.Length; p++)
                BytesOfPlane[p] += m_indexer.BytesOfPlane[p];
            m_regions.Add(region);
            return region;
        }

        MergeInput TopOf(UpperRegion region, GridCube cube, bool hasNodes)
        {
            var top = m_indexer.Drafts[0];
            return new MergeInput(region)
            {
                Cube = cube,
                TopPoints = top.OwnCount,
                Records = new NativeArray<byte>(m_indexer.Top.AsArray(), Allocator.Persistent),
                Top = TopNode.Of(top, hasNodes),
            };
        }

        /// <summary>Coroutine: when the root is merged.</summary>
        public IEnumerator<JobStep> WriteHierarchy()
        {
            m_manifest.ChunkCount = 0;
            foreach (var item in m_added)
                m_manifest.ChunkCount += item.Top.HasNodes ? 1 : 0;
            return HierarchyFile.Write(m_build.Folder, m_manifest, JoinSubtrees());
        }

        Subtree JoinSubtrees()
        {
            foreach (var region in m_regions)
                if (region.Above != null && region.Subtree.NodeCount > 0)
                    region.Attach(region.Subtree);
            foreach (var item in m_added)
                if (item.Top.HasNodes)
                    item.AttachPoint.Attach(item.ToSubtree());
            foreach (var region in m_regions)
                region.Subtree.SortChildren(m_manifest.Root.Corner);
            return m_regions.Count > 0 ? m_regions[m_regions.Count - 1].Subtree : new Subtree();
        }
    }

    /// <summary>Where the nodes of a chunk or a region are attached: to a draft of the region above.</summary>
    internal class UpperAttachPoint
    {
        public UpperRegion Above; // Null as long as nothing is made above it, and of the root.
        public int AttachDraft;

        /// <summary>The place, here or further above, whose draft is a node; the last one if there is none yet.</summary>
        public UpperAttachPoint OfNode()
        {
            var attachPoint = this;
            while (attachPoint.Above != null && attachPoint.Node < 0)
                attachPoint = attachPoint.Above;
            return attachPoint;
        }

        public int Node => Above.NodeOfDraft[AttachDraft];

        public void Attach(Subtree subtree)
        {
            var attachPoint = OfNode();
            attachPoint.Above.Subtree.Children.Add((attachPoint.Node, subtree));
        }
    }

    /// <summary>Upper nodes of one merge: those above a few chunks, or above other regions. The top node of a
    /// region, like a chunk's, belongs to the region above; the root's has none above. Owns its table, and its top's
    /// records.</summary>
    internal sealed class UpperRegion : UpperAttachPoint, IDisposable
    {
        public readonly Subtree Subtree = new Subtree();
        public int[] NodeOfDraft; // For each draft, its node in the table, or -1 for the top that belongs to the region above.
        public MergeInput Item; // Its top; null of the root.

        public void Dispose()
        {
            Subtree.DisposeTable();
            if (Item != null && Item.Records.IsCreated)
                Item.Records.Dispose();
        }
    }

    /// <summary>The merge's next input: a chunk's top, or a region's, also of another build.</summary>
    internal sealed class MergeInput
    {
        public GridCube Cube;
        public TopNode Top;
        public int TopPoints;
        public ChunkResult Chunk; // The chunk or the region whose top it is; the others are null, both if another build made it.
        public readonly UpperRegion Region;

        public readonly UpperAttachPoint AttachPoint;
        public NativeArray<byte> Records; // The top's records, if they are in memory; otherwise where they are.
        public string Path;
        public long RecordsOffset;
        public ulong RecordsHash; // What the records in the file must have; 0 if they were checked.

        /// <param name="region">Null if it is not a region's of this build.</param>
        public MergeInput(UpperRegion region = null)
        {
            Region = region;
            AttachPoint = region ?? new UpperAttachPoint();
        }

        public Subtree ToSubtree() => new Subtree
        {
            Cube = Cube,
            Container = Chunk.Container,
            NodeCount = Chunk.FileNodeCount,
            Table = Chunk.Table,
            Path = Path,
            TableOffset = Chunk.TableOffset,
        };
    }
}
