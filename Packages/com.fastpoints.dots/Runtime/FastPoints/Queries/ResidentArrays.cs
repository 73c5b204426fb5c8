using System;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // The copied nodes, cloud by cloud and in each by level and along the Morton curve, with a tree over each cloud's. Main
    // thread; no job may read them when they change.
    sealed unsafe class ResidentArrays : IDisposable
    {
        const int CellBits = 16; // Of the cells that nodes of one level are ordered by.

        readonly StreamContext m_stream;
        NativeList<ResidentCloud> m_clouds = new NativeList<ResidentCloud>(Allocator.Persistent);
        NativeList<ResidentNode> m_nodes = new NativeList<ResidentNode>(256, Allocator.Persistent);
        NativeList<int> m_children = new NativeList<int>(256, Allocator.Persistent);
        NativeList<EightBoxes> m_eights = new NativeList<EightBoxes>(64, Allocator.Persistent); // Of the trees over nodes.
        NativeList<int> m_nodeOfSlot = new NativeList<int>(1024, Allocator.Persistent); // One more than the index.
        NativeList<ulong> m_keys = new NativeList<ulong>(256, Allocator.Persistent);
        NativeList<uint> m_order = new NativeList<uint>(256, Allocator.Persistent);

        public ResidentArrays(StreamContext stream) => m_stream = stream;

        public ResidentPoints Points => new ResidentPoints
        {
            Clouds = m_clouds.AsArray(),
            Nodes = m_nodes.AsArray(),
            ChildrenOfNodes = m_children.AsArray(),
        };

        public void Fill(NativeArray<CopiedNode> copied)
        {
            m_clouds.Clear();
            m_nodes.Clear();
            m_children.Clear();
            m_nodeOfSlot.Clear();
            m_nodeOfSlot.Resize(m_stream.Cache.SlotCount, NativeArrayOptions.ClearMemory);
            for (int c = 0; c < m_stream.Clouds.Count; c++)
                if (m_stream.Clouds[c] != null && Order(c, copied) > 0)
                    AddNodes(c, copied);
            for (int n = 0; n < m_nodes.Length; n++)
                AddChildren(n);
            int eights = 0;
            foreach (var cloud in m_clouds)
                eights += BoxTree.EightsOf(cloud.Tree.LeafCount);
            m_eights.ResizeUninitialized(eights);
            var next = m_eights.GetUnsafePtr();
            for (int c = 0; c < m_clouds.Length; c++)
                next += BuildTree(ref m_clouds.ElementAt(c), next);
        }

        // Where the clouds stand now.
        public void Place()
        {
            for (int c = 0; c < m_clouds.Length; c++)
            {
                ref var cloud = ref m_clouds.ElementAt(c);
                var streamed = m_stream.Clouds[cloud.Number];
                if (streamed == null)
                    continue;
                var linear = streamed.Placement.Linear;
                cloud.Placement = streamed.Placement;
                cloud.LargestScale =
                    math.max(math.length(linear.c0), math.max(math.length(linear.c1), math.length(linear.c2)));
                cloud.NormalsToWorld = DrawListCloud.NormalsToWorld(linear, cloud.Metres);
            }
        }

        public void Dispose()
        {
            if (!m_clouds.IsCreated)
                return;
            m_clouds.Dispose();
            m_nodes.Dispose();
            m_children.Dispose();
            m_eights.Dispose();
            m_nodeOfSlot.Dispose();
            m_keys.Dispose();
            m_order.Dispose();
        }

        // Leaves the cloud's nodes in m_order. Returns how many there are.
        int Order(int cloud, NativeArray<CopiedNode> copied)
        {
            m_keys.Clear();
            m_order.Clear();
            var streamed = m_stream.Clouds[cloud];
            int shift = math.max(0, streamed.Source.Root.SideLog2 - CellBits);
            for (int i = 0; i < copied.Length; i++)
            {
                if (copied[i].Cloud != cloud || copied[i].BlockCount == 0)
                    continue;
                var address = streamed.Pages[copied[i].Page].Addresses[copied[i].Node];
                uint x = CellOf(address.Corner.X, shift), y = CellOf(address.Corner.Y, shift);
                uint z = CellOf(address.Corner.Z, shift);
                m_keys.Add((ulong)address.Level << 3 * CellBits | Morton.Encode(x, y, z));
                m_order.Add((uint)i);
            }
            int count = m_keys.Length;
            m_keys.ResizeUninitialized(2 * count);
            m_order.ResizeUninitialized(2 * count);
            RadixSort.Sort(m_keys.GetUnsafePtr(), m_order.GetUnsafePtr(), m_keys.GetUnsafePtr() + count,
                m_order.GetUnsafePtr() + count, count);
            m_order.ResizeUninitialized(count);
            return count;
        }

        static uint CellOf(long corner, int shift) => (uint)(corner >> shift) & ((1u << CellBits) - 1);

        void AddNodes(int cloud, NativeArray<CopiedNode> copied)
        {
            var streamed = m_stream.Clouds[cloud];
            m_clouds.Add(new ResidentCloud
            {
                Number = cloud,
                Grid = streamed.Source.Grid,
                RootCorner = streamed.Source.Root.Corner,
                Metres = streamed.Source.Crs.Units.MetresAt(streamed.Source.Grid.ToGeo(streamed.Source.Root.Corner), UpAxis.Z),
                FirstNode = m_nodes.Length,
                Tree = new BoxTree { LeafCount = m_order.Length },
            });
            int normals = PlaneOf(streamed.Source, StoreLayout.NormalName);
            for (int i = 0; i < m_order.Length; i++)
            {
                var node = copied[(int)m_order[i]];
                var stored = streamed.Pages[node.Page].Nodes[node.Node];
                var corner = streamed.Pages[node.Page].Addresses[node.Node].Corner;
                var tree = node.Tree;
                tree.Corner = new double3(corner.X, corner.Y, corner.Z) * streamed.Source.Grid.Step;
                m_nodes.Add(new ResidentNode
                {
                    Slot = node.Slot,
                    Version = node.Version,
                    Positions = node.PlaneOf(streamed, StoreLayout.PositionPlane),
                    Normals = normals > 0 ? node.PlaneOf(streamed, normals) : default,
                    Corner = corner,
                    Tree = tree,
                    Runs = node.Runs,
                    Center = stored.Center,
                    Half = stored.Half,
                    Spacing = stored.Spacing,
                });
                m_nodeOfSlot.ElementAt(node.Slot) = m_nodes.Length;
            }
        }

        // Index among the streamed planes, or -1.
        internal static int PlaneOf(NodeSource source, string name)
        {
            int plane = source.Layout.PlaneOf(name);
            for (int p = 0; p < source.Planes.Length; p++)
                if (source.Planes[p] == plane)
                    return p;
            return -1;
        }

        void AddChildren(int index)
        {
            ref var node = ref m_nodes.ElementAt(index);
            var cached = m_stream.Cache[node.Slot];
            node.FirstChild = m_children.Length;
            node.HasAllBelow = AddBelow(m_stream.Clouds[cached.Cloud].Pages, cached.Page, cached.Node);
            node.ChildCount = m_children.Length - node.FirstChild;
        }

        // Nodes that only hold others together are left out. Returns whether none is missing.
        bool AddBelow(HierarchyPage* pages, int page, int node)
        {
            var stored = pages[page].Nodes[node];
            bool hasAll = true;
            for (int child = stored.FirstChild; child < stored.FirstChild + stored.ChildCount; child++)
                hasAll &= AddBelowOrSelf(pages, page, child);
            for (int below = stored.FirstPage; below < stored.FirstPage + stored.PageCount; below++)
            {
                hasAll &= pages[below].IsLoaded;
                for (int root = 0; pages[below].IsLoaded && root < pages[below].RootCount; root++)
                    hasAll &= AddBelowOrSelf(pages, below, root);
            }
            return hasAll;
        }

        bool AddBelowOrSelf(HierarchyPage* pages, int page, int node)
        {
            int slot = pages[page].States[node].Slot;
            if (slot != NodeState.NoSlot && m_nodeOfSlot[slot] > 0)
            {
                m_children.Add(m_nodeOfSlot[slot] - 1);
                return true;
            }
            // The points of an inlined leaf are its parent's.
            var stored = pages[page].Nodes[node];
            return stored.PointCount == 0 || slot == NodeState.NoSlot && stored.BlockCount == 0 && AddBelow(pages, page, node);
        }

        // Returns how many boxes it has, by eights.
        int BuildTree(ref ResidentCloud cloud, EightBoxes* eights)
        {
            cloud.Tree.Eights = eights;
            for (int n = 0; n < cloud.Tree.LeafCount; n++)
            {
                var tree = m_nodes[cloud.FirstNode + n].Tree;
                tree.GetBounds(out var middle, out var half);
                middle += tree.Corner;
                eights[n / BoxTree.FanOut].Set(n % BoxTree.FanOut, middle - half, middle + half);
            }
            cloud.Tree.Build();
            return BoxTree.EightsOf(cloud.Tree.LeafCount);
        }
    }
}
