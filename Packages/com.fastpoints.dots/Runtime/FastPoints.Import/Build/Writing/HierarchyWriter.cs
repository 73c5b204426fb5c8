using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>Nodes that were made together: those of a chunk, or of upper levels above some chunks or other subtrees. The top
    /// node of a subtree belongs to the subtree above; the root's has none above.</summary>
    internal sealed class Subtree
    {
        public GridCube Cube;
        public ContainerRecord Container;

        /// <summary>Node records, then their planes' ranges, by node and plane; breadth first. Not created if they are to be
        /// loaded.</summary>
        public NativeArray<byte> Table;
        public int NodeCount;
        public string Path; // Where the table is, if it is in a file, and the hash that it must have; 0 if it was checked.
        public long TableOffset;
        public ulong TableHash;

        public int SamplingGroup;

        /// <summary>The subtrees that hang on its nodes, in the order of the nodes, then along the Morton curve.</summary>
        public readonly List<(int Node, Subtree Subtree)> Children = new List<(int, Subtree)>();

        public void SortChildren(Grid3 root) => Children.Sort((a, b) => a.Node != b.Node ? a.Node.CompareTo(b.Node)
            : a.Subtree.Cube.Corner != b.Subtree.Cube.Corner
                ? MortonOrder.Compare(a.Subtree.Cube.Corner - root, b.Subtree.Cube.Corner - root)
            : a.Subtree.Cube.SideLog2 != b.Subtree.Cube.SideLog2 ? b.Subtree.Cube.SideLog2.CompareTo(a.Subtree.Cube.SideLog2)
            : a.Subtree.Container.Part.CompareTo(b.Subtree.Container.Part));

        /// <summary>Coroutine: reads the table.</summary>
        /// <exception cref="PointCloudException">It is damaged.</exception>
        public IEnumerator<JobStep> Load(int planeCount)
        {
            using var read = new StoreRead();
            read.Begin(Path, TableOffset, NodeCount * ChunkResult.BytesPerNode(planeCount));
            yield return read.Done;
            read.Complete();
            StoreFile.CheckHash(Path, TableOffset, read.Bytes, TableHash);
            Table = new NativeArray<byte>(read.Bytes, Allocator.Persistent);
        }

        public void DisposeTable()
        {
            if (Table.IsCreated)
                Table.Dispose();
            Table = default;
        }
    }

    /// <summary>Cuts the nodes of a cloud into pages, and writes them to one file: the pages of what hangs on the same subtree
    /// one after the other, so that one read gets many, each page after those that it links to.</summary>
    internal sealed unsafe class HierarchyWriter : IDisposable
    {
        const int BytesPerPiece = 4 << 20;

        readonly int m_planeCount;
        readonly ulong m_cloudId;
        readonly Func<Subtree, IEnumerator<JobStep>> m_load;
        readonly Func<NativeArray<byte>, long, IEnumerator<JobStep>> m_writePiece;
        NativeList<byte> m_bytes = new NativeList<byte>(1 << 16, Allocator.Persistent);
        long m_written;

        /// <param name="load">Coroutine: makes the table of a subtree that has none.</param>
        /// <param name="writePiece">Coroutine: writes bytes at an offset.</param>
        public HierarchyWriter(int planeCount, ulong cloudId, long firstOffset, Func<Subtree, IEnumerator<JobStep>> load,
            Func<NativeArray<byte>, long, IEnumerator<JobStep>> writePiece)
        {
            m_planeCount = planeCount;
            m_cloudId = cloudId;
            m_load = load;
            m_writePiece = writePiece;
            m_written = firstOffset;
        }

        public long Offset => m_written + m_bytes.Length;

        /// <summary>Coroutine: writes all pages, the root's last.</summary>
        /// <param name="take">Receives the link to the root's page.</param>
        public IEnumerator<JobStep> Write(Subtree root, Action<PageLink> take)
        {
            var cuts = new List<SubtreePages>();
            yield return JobStep.Of(WriteBelow(root, cuts));
            take(WriteRoots(cuts[0])[0]);
            yield return JobStep.Of(Flush());
        }

        public void Dispose()
        {
            if (m_bytes.IsCreated)
                m_bytes.Dispose();
        }

        /// <summary>Coroutine: writes all pages of a subtree and below but those with its roots, and adds its cut.</summary>
        IEnumerator<JobStep> WriteBelow(Subtree subtree, List<SubtreePages> cuts)
        {
            SubtreePages cut;
            var below = new List<SubtreePages>();
            var loaded = new List<Subtree>();
            try
            {
                foreach (var (_, other) in subtree.Children)
                {
                    if (!other.Table.IsCreated)
                    {
                        loaded.Add(other);
                        yield return JobStep.Of(m_load(other));
                    }
                    yield return JobStep.Of(WriteBelow(other, below));
                }
                cut = new SubtreePages(subtree, m_planeCount, below);
                cuts.Add(cut);
                for (int i = 0; i < below.Count; i++)
                    foreach (var link in WriteRoots(below[i]))
                        cut.AddLink(subtree.Children[i].Node, link, below[i].Subtree.Cube);
            }
            finally
            {
                foreach (var other in loaded)
                    other.DisposeTable();
            }
            // The roots are written with those of what hangs on the same subtree.
            for (int page = cut.Pages.Count - 1; page >= cut.RootPages; page--)
                cut.AddLink(cut.Pages[page].Above, WritePage(cut, page), cut.CubeOf(cut.Pages[page].Above));
            if (m_bytes.Length >= BytesPerPiece)
                yield return JobStep.Of(Flush());
            yield return default;
        }

        List<PageLink> WriteRoots(SubtreePages cut)
        {
            var links = new List<PageLink>();
            for (int page = 0; page < cut.RootPages; page++)
                links.Add(WritePage(cut, page));
            return links;
        }

        PageLink WritePage(SubtreePages cut, int page)
        {
            long offset = Offset;
            int length = cut.Write(page, m_cloudId, m_bytes, out var link);
            link.OffsetBytes = offset;
            link.LengthBytes = length;
            link.Container = -1;
            link.Hash = ContentHash.Of(m_bytes.GetUnsafePtr() + m_bytes.Length - length, length);
            return link;
        }

        IEnumerator<JobStep> Flush()
        {
            if (m_bytes.Length == 0)
                yield break;
            yield return JobStep.Of(m_writePiece(m_bytes.AsArray(), m_written));
            m_written += m_bytes.Length;
            m_bytes.Clear();
        }
    }

    internal static unsafe class HierarchyFile
    {
        /// <summary>Coroutine: writes it, and adds it to the manifest.</summary>
        /// <param name="root">The subtree that all others hang on; its table is there.</param>
        public static IEnumerator<JobStep> Write(CloudFolderWriter folder, CloudManifest manifest, Subtree root)
        {
            string name = manifest.HierarchyName;
            int planeCount = manifest.CreateLayout().Planes.Count;
            IEnumerator<JobStep> WritePiece(NativeArray<byte> bytes, long offset) =>
                CloudFolderWriter.Await(folder.WritePiece(name, bytes, offset));
            using var writer = new HierarchyWriter(planeCount, manifest.CloudId, FileHeader.SizeBytes,
                subtree => subtree.Load(planeCount), WritePiece);
            yield return JobStep.Of(writer.Write(root, link =>
            {
                manifest.NodeCount = link.SubtreeNodeCount;
                manifest.RootOffset = link.OffsetBytes;
                manifest.RootBytes = link.LengthBytes;
                manifest.RootHash = link.Hash;
            }));
            manifest.HierarchyFileBytes = writer.Offset;
            using var header = new NativeArray<byte>(HeaderOf(manifest, planeCount), Allocator.Persistent);
            yield return JobStep.Of(CloudFolderWriter.Await(folder.Seal(name, header)));
        }

        public static byte[] HeaderOf(CloudManifest manifest, int planeCount)
        {
            var header = new FileHeader
            {
                Magic = StoreFormat.HierarchyMagic,
                Version = StoreFormat.Version,
                PlaneCount = planeCount,
                Container = new ContainerRecord
                {
                    Cube = manifest.Root,
                    Kind = ContainerKind.Hierarchy,
                    FileBytes = manifest.HierarchyFileBytes,
                    Hash = manifest.RootHash,
                },
                PointCount = manifest.Points,
                CloudId = manifest.CloudId,
            };
            header.HeaderHash = StoreFile.HashOf(header);
            return new ReadOnlySpan<byte>(&header, FileHeader.SizeBytes).ToArray();
        }
    }

    /// <summary>How the nodes of a subtree are cut into pages. A node's children are all in its page, or only the inlined leaves
    /// among them: the others are in pages below.</summary>
    sealed unsafe class SubtreePages
    {
        public struct Page
        {
            public List<int> Nodes;

            public int Above; // The node of the subtree that the roots are children of, or -1.
        }

        readonly int m_planeCount;
        readonly int m_room;
        readonly int[] m_costs; // By node: bytes with the leaves inlined in it, and the links that it has if it is cut.
        readonly int[] m_pagesOfChildren; // By node: links for them if it is cut.
        readonly bool[] m_isCut; // By node.
        readonly int[] m_indexInPage; // By node.
        readonly Dictionary<int, List<PageLink>> m_links = new Dictionary<int, List<PageLink>>(); // By node.

        public SubtreePages(Subtree subtree, int planeCount, List<SubtreePages> below)
        {
            Subtree = subtree;
            m_planeCount = planeCount;
            m_room = StoreFormat.MaxPageBytes - (int)HeaderFor(0, 0).LengthBytes;
            m_costs = new int[subtree.NodeCount];
            m_pagesOfChildren = new int[subtree.NodeCount];
            m_isCut = new bool[subtree.NodeCount];
            m_indexInPage = new int[subtree.NodeCount];
            for (int i = 0; i < below.Count; i++)
                m_costs[subtree.Children[i].Node] += below[i].RootPages * PageLink.SizeBytes;
            // Children come after their parents.
            for (int node = subtree.NodeCount - 1; node >= 0; node--)
                AddCost(node);
            int roots = 0;
            while (roots < subtree.NodeCount && Nodes[roots].Parent < 0)
                roots++;
            Cut(0, roots, -1);
            // An empty cloud has a page, too.
            if (Pages.Count == 0)
                Pages.Add(new Page { Nodes = new List<int>(), Above = -1 });
            RootPages = Pages.Count;
            for (int page = 0; page < Pages.Count; page++)
                foreach (int node in Pages[page].Nodes)
                    if (m_isCut[node])
                        Cut(Nodes[node].FirstChild, Nodes[node].FirstChild + Nodes[node].ChildCount, node);
        }

        public Subtree Subtree { get; }

        public List<Page> Pages { get; } = new List<Page>(); // Pages come after those that their roots hang on.

        public int RootPages { get; }

        NodeRecord* Nodes => (NodeRecord*)Subtree.Table.GetUnsafeReadOnlyPtr();

        PlaneRange* Ranges => (PlaneRange*)(Nodes + Subtree.NodeCount);

        int BytesPerNode => NodeRecord.SizeBytes + m_planeCount * PackedRange.SizeBytes;

        public GridCube CubeOf(int node) => Nodes[node].Cube;

        /// <summary>Adds what a page needs before it is written: a link to a page that is.</summary>
        public void AddLink(int node, PageLink link, GridCube cube)
        {
            (link.Corner, link.SideLog2) = (cube.Corner, cube.SideLog2);
            if (!m_links.TryGetValue(node, out var links))
                m_links.Add(node, links = new List<PageLink>());
            links.Add(link);
        }

        /// <summary>Appends a page.</summary>
        /// <param name="link">Receives its numbers of points and nodes, with those below.</param>
        /// <returns>Its bytes.</returns>
        public int Write(int page, ulong cloudId, NativeList<byte> to, out PageLink link)
        {
            var nodes = Pages[page].Nodes;
            var links = new List<PageLink>();
            var header = HeaderFor(nodes.Count, 0);
            header.CloudId = cloudId;
            var records = new NodeRecord[nodes.Count];
            for (int i = 0; i < nodes.Count; i++)
                m_indexInPage[nodes[i]] = i;
            for (int i = 0, nextChild = RootsOf(nodes, Pages[page].Above); i < nodes.Count; i++)
            {
                records[i] = RecordOf(nodes[i], i, Pages[page].Above, ref nextChild, links);
                header.PointCount += records[i].PointCount;
            }
            header.LinkCount = links.Count;
            link = new PageLink { SubtreePointCount = header.PointCount, SubtreeNodeCount = nodes.Count };
            foreach (var below in links)
            {
                link.SubtreePointCount += below.SubtreePointCount;
                link.SubtreeNodeCount += below.SubtreeNodeCount;
            }
            int start = to.Length, length = (int)header.LengthBytes;
            to.Resize(start + length, NativeArrayOptions.ClearMemory);
            byte* at = to.GetUnsafePtr() + start;
            *(PageHeader*)at = header;
            if (header.ContainerCount > 0)
                *(ContainerRecord*)(at + header.ContainersOffset) = Subtree.Container;
            for (int i = 0; i < nodes.Count; i++)
            {
                ((NodeRecord*)(at + header.NodesOffset))[i] = records[i];
                for (int p = 0; p < m_planeCount; p++)
                    ((PackedRange*)(at + header.RangesOffset))[i * m_planeCount + p] =
                        new PackedRange(Ranges[(long)nodes[i] * m_planeCount + p]);
            }
            for (int l = 0; l < links.Count; l++)
                ((PageLink*)(at + header.LinksOffset))[l] = links[l];
            return length;
        }

        /// <summary>Makes pages of siblings, but inlined leaves if there is a page above, and of what is below them.</summary>
        void Cut(int first, int end, int above)
        {
            for (int next = first; next < end;)
            {
                var nodes = new List<int>();
                int room = m_room;
                for (; next < end; next++)
                {
                    if (above >= 0 && IsInlined(next))
                        continue;
                    if (nodes.Count > 0 && m_costs[next] > room)
                        break;
                    room -= m_costs[next];
                    nodes.Add(next);
                }
                for (int i = 0; i < nodes.Count; i++)
                    AddChildren(nodes[i], nodes, ref room);
                if (nodes.Count > 0)
                    Pages.Add(new Page { Nodes = nodes, Above = above });
            }
        }

        void AddChildren(int node, List<int> nodes, ref int room)
        {
            int first = Nodes[node].FirstChild, end = first + Nodes[node].ChildCount;
            int cost = -m_pagesOfChildren[node] * PageLink.SizeBytes;
            for (int child = first; child < end && cost <= room; child++)
                cost += IsInlined(child) ? 0 : m_costs[child];
            m_isCut[node] = cost > room;
            room -= m_isCut[node] ? 0 : cost;
            for (int child = first; child < end; child++)
                if (!m_isCut[node] || IsInlined(child))
                    nodes.Add(child);
        }

        bool IsInlined(int node) => Nodes[node].PlaneNode != node;

        /// <summary>After those of its children: cuts these into pages as Cut does.</summary>
        void AddCost(int node)
        {
            int room = 0, first = Nodes[node].FirstChild;
            m_costs[node] += BytesPerNode;
            for (int child = first; child < first + Nodes[node].ChildCount; child++)
            {
                if (IsInlined(child))
                {
                    m_costs[node] += BytesPerNode;
                    continue;
                }
                if (m_pagesOfChildren[node] == 0 || m_costs[child] > room)
                {
                    m_pagesOfChildren[node]++;
                    room = m_room;
                }
                room -= m_costs[child];
            }
            m_costs[node] += m_pagesOfChildren[node] * PageLink.SizeBytes;
        }

        int RootsOf(List<int> nodes, int above)
        {
            int roots = 0;
            while (roots < nodes.Count && Nodes[nodes[roots]].Parent == above && !(above >= 0 && IsInlined(nodes[roots])))
                roots++;
            return roots;
        }

        NodeRecord RecordOf(int node, int index, int above, ref int nextChild, List<PageLink> links)
        {
            var record = Nodes[node];
            int children = 0;
            for (int child = record.FirstChild; child < record.FirstChild + record.ChildCount; child++)
                children += !m_isCut[node] || IsInlined(child) ? 1 : 0;
            record.Parent = record.Parent == above ? -1 : m_indexInPage[record.Parent];
            record.PlaneNode = IsInlined(node) ? m_indexInPage[record.PlaneNode] : index;
            record.FirstChild = children > 0 ? nextChild : 0;
            record.ChildCount = children;
            nextChild += children;
            record.SamplingGroup = Subtree.SamplingGroup;
            record.FirstLink = record.LinkCount = 0;
            if (!m_links.TryGetValue(node, out var below))
                return record;
            record.FirstLink = links.Count;
            record.LinkCount = below.Count;
            foreach (var link in below)
            {
                var attached = link;
                attached.AttachNode = index;
                links.Add(attached);
            }
            return record;
        }

        PageHeader HeaderFor(int nodes, int links) => new PageHeader
        {
            Magic = StoreFormat.PageMagic,
            Version = StoreFormat.Version,
            PlaneCount = m_planeCount,
            NodeCount = nodes,
            LinkCount = links,
            ContainerCount = Subtree.NodeCount > 0 ? 1 : 0,
        };
    }
}
