using System;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    // The memory of selections from frame to frame. Main thread.
    internal sealed unsafe class LodSelector : IDisposable
    {
        NativeList<SelectionCloud> m_clouds = new NativeList<SelectionCloud>(Allocator.Persistent);
        NativeList<CloudPlacement> m_placements = new NativeList<CloudPlacement>(Allocator.Persistent);
        NativeList<CloudView> m_views = new NativeList<CloudView>(Allocator.Persistent);
        NativeList<LocalClip> m_clips = new NativeList<LocalClip>(Allocator.Persistent);
        NativeArray<ClipBox> m_clipBoxes;
        NativeList<SelectedNode> m_selected = new NativeList<SelectedNode>(1024, Allocator.Persistent);
        NativeList<SelectedNode> m_prefetched = new NativeList<SelectedNode>(256, Allocator.Persistent);
        NativeList<MissingHierarchyPage> m_missing = new NativeList<MissingHierarchyPage>(Allocator.Persistent);
        NativeList<MissingHierarchyPage> m_missingOfPrefetch = new NativeList<MissingHierarchyPage>(Allocator.Persistent);
        NativeReference<long> m_points = new NativeReference<long>(Allocator.Persistent);
        NativeReference<long> m_pointsOfPrefetch = new NativeReference<long>(Allocator.Persistent);
        SelectionHeap m_heap = new SelectionHeap(Allocator.Persistent);

        // Begins at 2, so that a node's initial 0 is neither this selection's frame nor the one before.
        public uint Frame { get; private set; } = 1;

        public NativeArray<SelectedNode> Selected => m_selected.AsArray();

        // Nodes of the last Prefetch that were not selected already; their parent indices are undefined.
        public NativeArray<SelectedNode> Prefetched => m_prefetched.AsArray();

        public NativeArray<MissingHierarchyPage> Missing => m_missing.AsArray();
        public NativeArray<MissingHierarchyPage> MissingOfPrefetch => m_missingOfPrefetch.AsArray(); // Of the last Prefetch.

        public long Points => m_points.Value;

        // The clip boxes must not change before the frame's last selection.
        public void Begin(NativeArray<ClipBox> clipBoxes = default)
        {
            Frame++;
            m_clipBoxes = clipBoxes;
            m_clouds.Clear();
            m_placements.Clear();
            m_prefetched.Clear();
            m_missingOfPrefetch.Clear();
        }

        // In rising order of clouds. The pages stay in place until the frame's last selection; clouds without volume are left
        // out.
        public void Add(int cloud, HierarchyPage* pages, in CloudPlacement placement, double3 cubeSize = default,
            bool isReplacement = false)
        {
            if (!placement.IsValid)
                return;
            m_clouds.Add(new SelectionCloud
            {
                Cloud = cloud,
                Pages = pages,
                CubeSize = cubeSize,
                IsReplacement = isReplacement,
            });
            m_placements.Add(placement);
        }

        public void Select(NativeArray<StreamView> views, in LodSettings settings, int missingToStopAt = int.MaxValue)
        {
            var job = JobFor(views, settings);
            job.MissingToStopAt = missingToStopAt;
            job.Selected = m_selected;
            job.Missing = m_missing;
            job.Points = m_points;
            job.Run();
        }

        // Selects about so many points of the same clouds for future views, beyond this frame's selection.
        public void Prefetch(NativeArray<StreamView> views, in LodSettings settings, long points)
        {
            var job = JobFor(views, settings);
            job.MissingToStopAt = int.MaxValue;
            job.IsPrefetch = true;
            job.PrefetchPoints = points;
            job.Selected = m_prefetched;
            job.Missing = m_missingOfPrefetch;
            job.Points = m_pointsOfPrefetch;
            job.Run();
        }

        public void Dispose()
        {
            if (!m_clouds.IsCreated)
                return;
            m_clouds.Dispose();
            m_placements.Dispose();
            m_views.Dispose();
            m_clips.Dispose();
            m_selected.Dispose();
            m_prefetched.Dispose();
            m_missing.Dispose();
            m_missingOfPrefetch.Dispose();
            m_points.Dispose();
            m_pointsOfPrefetch.Dispose();
            m_heap.Dispose();
        }

        SelectNodesJob JobFor(NativeArray<StreamView> views, in LodSettings settings)
        {
            m_views.Clear();
            m_clips.Clear();
            for (int c = 0; c < m_clouds.Length; c++)
            {
                for (int v = 0; v < views.Length; v++)
                    m_views.Add(new CloudView(views[v], m_placements[c], m_clouds[c].CubeSize));
                for (int b = 0; b < m_clipBoxes.Length; b++)
                    m_clips.Add(new LocalClip(m_clipBoxes[b], m_placements[c]));
            }
            return new SelectNodesJob
            {
                Clouds = m_clouds.AsArray(),
                Views = m_views.AsArray(),
                ViewCount = views.Length,
                Clips = m_clips.AsArray(),
                ClipCount = m_clipBoxes.Length,
                Settings = settings,
                Frame = Frame,
                Heap = m_heap,
            };
        }
    }
}
