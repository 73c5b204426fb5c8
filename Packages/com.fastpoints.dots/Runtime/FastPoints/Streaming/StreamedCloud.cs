using System;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Streaming
{
    internal sealed unsafe class StreamedCloud : IDisposable
    {
        NativeList<HierarchyPage> m_pages;

        public StreamedCloud(NodeSource source, CloudPlacement placement)
        {
            Source = source;
            Placement = placement;
            m_pages = new NativeList<HierarchyPage>(source.PageCount, Allocator.Persistent);
            m_pages.Resize(source.PageCount, NativeArrayOptions.ClearMemory);
            try
            {
                source.CreatePages(Pages);
            }
            catch
            {
                m_pages.Dispose();
                throw;
            }
            HierarchyBytes = BytesOf(Pages[0]);
            AddNewPages();
        }

        public NodeSource Source { get; }
        public CloudPlacement Placement { get; set; }

        public bool IsRemoving { get; set; } // It goes when its reads and uploads have ended.

        // It loads what another shows of the same nodes, and will replace it: it is not drawn, and takes nothing of the budget.
        public bool IsReplacement { get; set; }

        public int PageCount => m_pages.Length;
        public long HierarchyBytes { get; private set; }

        public HierarchyPage* Pages => m_pages.GetUnsafePtr(); // Valid until a page is loaded.

        public long BytesOf(int page, int node)
        {
            long bytes = 0;
            for (int p = 0; p < Source.Planes.Length; p++)
                bytes += RangeOf(page, node, p).LengthBytes;
            return bytes;
        }

        public PlaneRange RangeOf(int page, int node, int plane) => Pages[page].Planes[node * Source.Planes.Length + plane];

        public PlaneShape ShapeOf(int page, int node, int plane) => plane == 0 && Pages[page].Addresses[node].IsWide
            ? new PlaneShape(3, 7)
            : Source.Shapes[Source.Planes[plane]];

        public void SetTranscoded(int page, int node, NodeTranscoder made)
        {
            for (int p = 0; p < Source.Planes.Length; p++)
                Pages[page].Planes[node * Source.Planes.Length + p].LengthBytes = made.LengthOf(p);
            ref var changed = ref Pages[page].Nodes[node];
            ref var state = ref Pages[page].States[node];
            made.CorrectCounts(ref changed.BlockCount, ref changed.PointCount);
            state.WasTranscoded = true;
            if (changed.BlockCount > 0)
                return;
            // A count of 0 would mark an inlined leaf.
            changed.PointCount = 1;
            state.Failures = NodeState.HoleFailures;
        }

        public void InstallPage(int page, in HierarchyPage built, NativeArray<byte> table)
        {
            Source.RegisterPage(page, built, table);
            var to = Pages + page;
            to->Nodes = built.Nodes;
            to->States = built.States;
            to->Addresses = built.Addresses;
            to->Planes = built.Planes;
            to->NodeCount = built.NodeCount;
            to->RootCount = built.RootCount;
            to->Failures = 0;
            to->Status = HierarchyPageStatus.Loaded;
            HierarchyBytes += BytesOf(built);
            AddNewPages();
        }

        // None of its nodes may be in the cache.
        public void Unload(int page)
        {
            HierarchyBytes -= BytesOf(Pages[page]);
            Pages[page].Free();
        }

        public void Dispose()
        {
            if (!m_pages.IsCreated)
                return;
            for (int p = 0; p < m_pages.Length; p++)
                Pages[p].Free();
            m_pages.Dispose();
            Source.Dispose();
        }

        void AddNewPages()
        {
            while (m_pages.Length < Source.PageCount)
                m_pages.Add(Source.EmptyPage(m_pages.Length));
        }

        long BytesOf(in HierarchyPage page) => HierarchyPage.BytesFor(page.NodeCount, Source.Planes.Length);
    }
}
