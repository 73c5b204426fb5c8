using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // Finds the first points of a cloud that a query asks for, among all points on disk and not only those that are shown. It
    // reads or transcodes nodes from the nearest on, until none of the rest can have a nearer hit. Main thread; it waits only
    // when it is disposed or a search is cancelled.
    internal sealed class PointPicker : IDisposable
    {
        const int SlotCount = 8; // Nodes and tables that are read at the same time.
        const long MaxHierarchyBytes = 64 << 20; // Tables of chunks are kept between searches up to this size.

        readonly StreamedCloud m_cloud;
        readonly PickQueue m_queue = new PickQueue();
        readonly List<PickSlot> m_slots = new List<PickSlot>();
        readonly List<PickCandidate> m_taken = new List<PickCandidate>();
        readonly PickDetails m_details;
        readonly int m_classPlane; // Among the streamed planes; -1 if there are no classes.
        readonly int m_normalPlane;
        NativeArray<PickHit> m_hitMemory;
        PointQuery m_query; // State of the search in progress.
        QuerySpace m_space;
        double m_largestScale;
        PickOptions m_options;
        PickResult m_result;
        HitHeap m_hits;

        // Owns the source, which has the planes that NodeSource.OpenForPicking promises.
        public PointPicker(NodeSource source)
        {
            m_cloud = new StreamedCloud(source, default);
            m_classPlane = ResidentArrays.PlaneOf(source, AttributeNames.Classification);
            m_normalPlane = ResidentArrays.PlaneOf(source, StoreLayout.NormalName);
            for (int s = 0; s < SlotCount; s++)
                m_slots.Add(new PickSlot(m_cloud));
            m_details = new PickDetails(m_cloud);
        }

        public NodeSource Source => m_cloud.Source;

        public bool IsSearching { get; private set; } // A picker has one search at a time.

        // Coroutine: the first point of all, with what the cloud knows of it. The options must not change meanwhile.
        public IEnumerator<JobStep> Find(PointQuery query, CloudPlacement placement, PickOptions options, PickResult result)
        {
            try
            {
                yield return JobStep.Of(Search(query, placement, options, result));
                if (m_hits.Totals.Count == 0)
                    yield break;
                var hit = m_hits[0];
                m_details.Begin(hit);
                while (!m_details.TryContinueReads())
                    yield return default;
                yield return m_details.Done;
                m_details.Continue();
                yield return m_details.Done;
                result.Point = new PickedPoint(hit.Position, Source.Grid, WorldOf(hit.Position, placement), hit.Distance,
                    m_details.End());
            }
            finally
            {
                m_details.Abandon();
                TrimHierarchy();
            }
        }

        // Coroutine: leaves the hits in Hits, the first one first, until the next search. A cloud without volume is never hit.
        // Whoever calls it calls ReleaseTables, too.
        public IEnumerator<JobStep> Search(PointQuery query, CloudPlacement placement, PickOptions options, PickResult result)
        {
            if (IsSearching)
                throw new InvalidOperationException(Source.Path + ": is searched already");
            Begin(query, placement, options ?? new PickOptions(), result);
            if (!placement.IsValid)
                yield break;
            IsSearching = true;
            var clips = new NativeArray<LocalClip>(m_options.ClipBoxes.Count, Allocator.Persistent);
            for (int i = 0; i < clips.Length; i++)
                clips[i] = new LocalClip(m_options.ClipBoxes[i], placement);
            try
            {
                m_queue.Clear();
                PushRoots(0, double.PositiveInfinity);
                while (TakeNearest())
                {
                    while (!TryPreparePages())
                        yield return Source.Reading;
                    bool hasMore = BeginTaken(clips);
                    while (!TryContinueReads())
                        yield return default;
                    yield return PendingJobs();
                    if (hasMore)
                    {
                        for (int i = 0; i < m_taken.Count; i++)
                            m_slots[i].Continue();
                        yield return PendingJobs();
                    }
                    End();
                }
                m_hits.Sort();
            }
            finally
            {
                foreach (var slot in m_slots)
                    slot.Abandon();
                clips.Dispose();
                IsSearching = false;
            }
        }

        public HitHeap Hits => m_hits;

        // A search in progress must be ended by its coroutine first.
        public void Dispose()
        {
            foreach (var slot in m_slots)
                slot.Dispose();
            m_details.Dispose();
            m_cloud.Dispose();
            if (m_hitMemory.IsCreated)
                m_hitMemory.Dispose();
        }

        unsafe void Begin(in PointQuery query, in CloudPlacement placement, PickOptions options, PickResult result)
        {
            m_query = query;
            m_space = new QuerySpace(query, placement);
            m_largestScale = math.max(math.length(placement.Linear.c0),
                math.max(math.length(placement.Linear.c1), math.length(placement.Linear.c2)));
            m_options = options;
            m_result = result;
            if (m_hitMemory.IsCreated && m_hitMemory.Length != options.MaxHits)
                m_hitMemory.Dispose();
            if (!m_hitMemory.IsCreated)
                m_hitMemory = new NativeArray<PickHit>(options.MaxHits, Allocator.Persistent);
            m_hits = new HitHeap((PickHit*)m_hitMemory.GetUnsafePtr(), options.MaxHits, options.CountsAll, PickHit.None);
        }

        // Whether a candidate remains that might have a nearer hit.
        bool TakeNearest()
        {
            m_taken.Clear();
            while (m_taken.Count < SlotCount && m_queue.Count > 0 && m_queue.Next.Distance <= m_hits.Limit)
            {
                if (m_result.BytesRead > m_options.MaxBytes)
                {
                    m_result.IsPartial = true;
                    break;
                }
                if (!m_slots[m_taken.Count].TryTake(m_queue.Next))
                    break;
                m_taken.Add(m_queue.Pop());
            }
            return m_taken.Count > 0;
        }

        // Whether all pages that were taken can be built; if not, the source continues to read them.
        bool TryPreparePages()
        {
            bool areKnown = true;
            foreach (var taken in m_taken)
                areKnown &= !taken.IsPage || Source.TryPrepareBuild(taken.Page);
            if (!areKnown && Source.Update() is PointCloudException failure)
                throw failure;
            return areKnown;
        }

        // Whether there is more to do before it can be ended.
        bool BeginTaken(NativeArray<LocalClip> clips)
        {
            bool hasMore = false;
            var search = new PickNodeJob
            {
                Hidden = m_classPlane >= 0 ? m_options.HiddenClasses : default,
                HasNormals = m_normalPlane >= 0 && m_options.FindsNormals,
                Space = m_space,
                Filter = new BlockFilter(m_query, m_space, Source.Grid.Step),
                Clips = clips,
                Step = Source.Grid.Step,
                RootCorner = Source.Root.Corner,
                Cloud = m_options.Cloud,
                Bound = m_hits.Last,
                CountsAll = m_options.CountsAll,
            };
            for (int i = 0; i < m_taken.Count; i++)
            {
                if (m_taken[i].IsPage)
                    m_slots[i].BeginPage();
                else
                    m_slots[i].BeginNode(search, m_classPlane, m_normalPlane, m_options.MaxHits);
                hasMore |= m_slots[i].HasMore;
                m_result.BytesRead += m_slots[i].Bytes;
            }
            return hasMore;
        }

        bool TryContinueReads()
        {
            for (int i = 0; i < m_taken.Count; i++)
                if (!m_slots[i].TryContinueReads())
                    return false;
            return true;
        }

        JobHandle PendingJobs()
        {
            var awaited = default(JobHandle);
            for (int i = 0; i < m_taken.Count; i++)
                awaited = JobHandle.CombineDependencies(awaited, m_slots[i].Done);
            return awaited;
        }

        unsafe void End()
        {
            for (int i = 0; i < m_taken.Count; i++)
            {
                int page = m_taken[i].Page, index = m_taken[i].Node;
                if (m_taken[i].IsPage)
                {
                    m_slots[i].EndPage();
                    PushRoots(page, m_taken[i].SpacingAbove);
                    continue;
                }
                m_slots[i].EndNode(ref m_hits);
                m_result.NodesRead++;
                PushBelow(page, index);
            }
        }

        unsafe void PushBelow(int page, int index)
        {
            var node = m_cloud.Pages[page].Nodes[index];
            for (int child = node.FirstChild; child < node.FirstChild + node.ChildCount; child++)
                PushNode(page, child, node.Spacing);
            for (int below = node.FirstPage; below < node.FirstPage + node.PageCount; below++)
                PushPage(below, node.Spacing);
        }

        unsafe void PushPage(int page, double spacingAbove)
        {
            if (m_cloud.Pages[page].IsLoaded)
                PushRoots(page, spacingAbove);
            else
                Push(page, PickCandidate.WholePage, m_cloud.Pages[page].Center, m_cloud.Pages[page].Half, spacingAbove);
        }

        unsafe void PushRoots(int page, double spacingAbove)
        {
            for (int node = 0; node < m_cloud.Pages[page].RootCount; node++)
                PushNode(page, node, spacingAbove);
        }

        unsafe void PushNode(int page, int index, double spacingAbove)
        {
            var node = m_cloud.Pages[page].Nodes[index];
            // An inlined leaf's points are searched with its parent's.
            if (node.PointCount == 0)
                return;
            // The node only holds others together.
            if (node.BlockCount == 0)
                PushBelow(page, index);
            else
                Push(page, index, node.Center, node.Half, spacingAbove);
        }

        void Push(int page, int node, double3 center, double3 half, double spacingAbove)
        {
            if (!m_space.Intersects(center, half, out double distance) || distance > m_hits.Limit ||
                spacingAbove * m_largestScale < m_options.FinestSpacingShare * m_query.RadiusAt(distance))
                return;
            m_queue.Push(new PickCandidate { Distance = distance, Page = page, Node = node, SpacingAbove = spacingAbove });
        }

        double3 WorldOf(Grid3 position, in CloudPlacement placement)
        {
            var from = position - Source.Root.Corner;
            return math.mul(placement.Linear, new double3(from.X, from.Y, from.Z) * Source.Grid.Step) + placement.OriginWorld;
        }

        public unsafe void TrimHierarchy()
        {
            if (m_cloud.HierarchyBytes <= MaxHierarchyBytes)
                return;
            for (int page = 1; page < m_cloud.PageCount; page++)
                if (m_cloud.Pages[page].IsLoaded)
                    m_cloud.Unload(page);
        }
    }

    internal sealed class PickOptions
    {
        public List<ClipBox> ClipBoxes = new List<ClipBox>(); // What is not shown is not hit.
        public ClassMask HiddenClasses;
        public int MaxHits = 1;
        public bool CountsAll; // Also those behind the first hits.
        public bool FindsNormals; // Of hits, where the cloud has some.
        public int Cloud; // Number of the cloud in its stream, for the hits.

        // Nothing below a node is searched if its points lie nearer to each other than this share of the ray's radius: a screen
        // shows no more. 0 searches every point.
        public double FinestSpacingShare = 0.1;
        public long MaxBytes = 256 << 20; // A search that has read this many bytes ends with what it has found.
    }
}
