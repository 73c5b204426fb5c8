using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>Everything that streaming keeps from frame to frame: clouds are added and removed, <see cref="FrameStep"/> runs
    /// each frame, and Dispose ends it (on a domain reload or on quitting): it awaits reads and frees all memory. Main
    /// thread.</summary>
    public sealed unsafe class StreamContext : IDisposable
    {
        const uint FramesToUnload = 300; // A hierarchy page must be out of view for this many frames before it is unloaded.
        const int MaxRoundTripFrames = 60; // Farther ahead no motion goes on as it is.

        readonly StreamState m_state;
        int m_unloadCloud;
        int m_unloadPage;

        /// <param name="pool">This context owns it.</param>
        public StreamContext(NodePool pool)
        {
            m_state = new StreamState(pool);
            Uploads = new NodeUploads(m_state);
            Reads = new NodeReadQueue(m_state);
        }

        public StreamSettings Settings => m_state.Settings;
        public NodePool Pool => m_state.Pool;
        internal NodeCache Cache => m_state.Cache;
        internal LodSelector Selector => m_state.Selector;
        internal NodeReadQueue Reads { get; }
        internal StreamFiles Files => m_state.Files;
        internal NodeUploads Uploads { get; }
        internal NativeArray<CloudPages> CloudPages => m_state.CloudPages;
        internal NativeReference<DrawnTotals> DrawnTotals { get; } = new NativeReference<DrawnTotals>(Allocator.Persistent);
        internal CameraMotion Motion { get; } = new CameraMotion();
        internal IReadOnlyList<StreamedCloud> Clouds => m_state.Clouds; // Indexed by number; null for a removed cloud.

        /// <summary>Nothing outside is selected, loaded or drawn. They may change from frame to frame.</summary>
        public NativeList<ClipBox> ClipBoxes { get; } = new NativeList<ClipBox>(Allocator.Persistent);

        /// <summary>What to draw after the last frame: parents before children.</summary>
        public NativeList<DrawnNode> Drawn { get; } = new NativeList<DrawnNode>(1024, Allocator.Persistent);

        /// <summary>By selected node: its index in Drawn, or NotDrawn, or NotLoaded.</summary>
        public NativeList<int> DrawnOfSelected { get; } = new NativeList<int>(1024, Allocator.Persistent);

        /// <summary>The node is a hole or hidden, but what is below it can be drawn.</summary>
        public const int NotDrawn = -1;

        /// <summary>The node, or one above it, is not loaded yet.</summary>
        public const int NotLoaded = -2;

        /// <summary>Seconds from the last frame to this one, as the caller counts them: nodes appear and leave at this
        /// pace.</summary>
        public float FrameSeconds { get; set; }

        // A table and then nodes take a round trip each where they are on a web server.
        internal int FramesToPredict => Settings.PrefetchFrames == 0 || FrameSeconds <= 0 ? Settings.PrefetchFrames
            : Settings.PrefetchFrames + (int)Math.Min(MaxRoundTripFrames, 2 * RoundTrip / FrameSeconds);

        // A server's connections are busy all the time only if enough is known that will be wanted.
        internal long PointsToPrefetch =>
            (long)(Settings.Selection.PointBudget * (RoundTrip > 0 ? 2 : 1) * Settings.PrefetchShare);

        double RoundTrip
        {
            get
            {
                double roundTrip = 0;
                foreach (var cloud in m_state.Clouds)
                    roundTrip = Math.Max(roundTrip, cloud == null ? 0 : cloud.Source.RoundTrip);
                return roundTrip;
            }
        }

        /// <summary>Whether the last frame listed nodes of which some points are drawn.</summary>
        internal bool IsFading => DrawnTotals.Value.FadingNodes > 0;

        // Scratch of the list.
        internal NativeList<DrawnNode> LastDrawn { get; } = new NativeList<DrawnNode>(Allocator.Persistent);

        public bool IsDisposed { get; private set; }

        /// <summary>Whether a removed cloud still has reads or uploads in flight.</summary>
        public bool IsRemovingAny => m_state.Clouds.Exists(c => c != null && c.IsRemoving);

        // Whether a source reads what its pages are built of, which no read of the stream's is.
        internal bool IsReadingHierarchy => m_state.Clouds.Exists(c => c != null && c.Source.IsReading);

        /// <summary>Replaces <see cref="ClipBoxes"/>.</summary>
        public void SetClipBoxes(List<ClipBox> boxes)
        {
            ClipBoxes.Clear();
            foreach (var box in boxes)
                ClipBoxes.Add(box);
        }

        /// <summary>Owns the source. Returns the cloud's number until it is removed.</summary>
        public int Add(NodeSource source, CloudPlacement placement)
        {
            var cloud = new StreamedCloud(source, placement);
            int free = m_state.Clouds.IndexOf(null);
            if (free < 0)
                m_state.Clouds.Add(cloud);
            else
                m_state.Clouds[free] = cloud;
            return free < 0 ? m_state.Clouds.Count - 1 : free;
        }

        /// <summary>The cloud's reads and uploads are cancelled; its source is disposed when these have ended.</summary>
        public void Remove(int cloud)
        {
            var removing = m_state.Clouds[cloud];
            if (removing == null || removing.IsRemoving)
                return;
            removing.IsRemoving = true;
            Reads.Cancel(removing);
            for (int slot = 0; slot < Cache.SlotCount; slot++)
                if (Cache[slot].Phase != CachePhase.Free && Cache[slot].Cloud == cloud)
                    ReleaseIfIdle(slot);
            Drawn.Clear();
        }

        /// <summary>Takes the oldest failure that was not taken yet.</summary>
        public bool TryTakeFailure(out StreamFailure failure) => m_state.TryTakeFailure(out failure);

        /// <summary>Lets sources continue work of their own.</summary>
        public void UpdateSources()
        {
            for (int c = 0; c < m_state.Clouds.Count; c++)
                if (m_state.Clouds[c] != null && !m_state.Clouds[c].IsRemoving &&
                    m_state.Clouds[c].Source.Update() is PointCloudException failure)
                    Report(new StreamFailure(failure.Path, failure.ByteOffset, failure.What));
        }

        /// <summary>Ends clouds that leave and frees what exceeds limits, except memory that a job writes to.</summary>
        public void Trim()
        {
            for (int c = 0; c < m_state.Clouds.Count; c++)
                if (m_state.Clouds[c] != null && m_state.Clouds[c].IsRemoving)
                    EndRemoval(c);
            m_state.Files.CloseIdle(Selector.Frame);
            if (Pool.AllocatedBytes > Pool.LimitBytes)
                VacateBanks();
            UnloadPage();
        }

        /// <summary>Frees a node's memory; no job may be writing to it.</summary>
        public void Release(int slot) => m_state.Release(slot);

        public void Report(StreamFailure failure) => m_state.Report(failure);

        public void Dispose()
        {
            if (IsDisposed)
                return;
            IsDisposed = true;
            Reads.Cancel(null);
            Uploads.Await();
            Reads.Await();
            Reads.Dispose();
            Uploads.Dispose();
            foreach (var cloud in m_state.Clouds)
                cloud?.Dispose();
            m_state.Dispose();
            Motion.Dispose();
            ClipBoxes.Dispose();
            Drawn.Dispose();
            LastDrawn.Dispose();
            DrawnOfSelected.Dispose();
            DrawnTotals.Dispose();
        }

        void ReleaseIfIdle(int slot)
        {
            if (Cache[slot].Phase != CachePhase.Uploading)
                Release(slot);
        }

        void EndRemoval(int index)
        {
            var cloud = m_state.Clouds[index];
            bool isUsed = Reads.IsUsing(cloud);
            for (int slot = 0; slot < Cache.SlotCount; slot++)
            {
                if (Cache[slot].Phase == CachePhase.Free || Cache[slot].Cloud != index)
                    continue;
                isUsed |= Cache[slot].Phase == CachePhase.Uploading;
                ReleaseIfIdle(slot);
            }
            if (isUsed)
                return;
            m_state.Files.Close(cloud);
            cloud.Dispose();
            m_state.Clouds[index] = null;
            // With the last one its memory goes: the next level may have none.
            if (m_state.Clouds.TrueForAll(other => other == null))
                Pool.FreeEmptyBanks(0);
        }

        void VacateBanks()
        {
            int limit = Pool.BankLimit;
            for (int slot = 0; slot < Cache.SlotCount; slot++)
                if (Cache[slot].Phase != CachePhase.Free && Cache[slot].Range.Bank >= limit)
                    ReleaseIfIdle(slot);
            Pool.FreeEmptyBanks();
        }

        // Examines one page each frame while there are more than there should be.
        void UnloadPage()
        {
            long bytes = 0;
            for (int c = 0; c < m_state.Clouds.Count; c++)
                bytes += m_state.Clouds[c] != null ? m_state.Clouds[c].HierarchyBytes : 0;
            HierarchyBytes = bytes;
            if (bytes <= Settings.MaxHierarchyBytes)
                return;
            if (m_unloadCloud >= m_state.Clouds.Count || m_state.Clouds[m_unloadCloud] == null ||
                ++m_unloadPage >= m_state.Clouds[m_unloadCloud].PageCount)
            {
                m_unloadCloud = m_unloadCloud + 1 >= m_state.Clouds.Count ? 0 : m_unloadCloud + 1;
                m_unloadPage = 0;
                return;
            }
            var page = m_state.Clouds[m_unloadCloud].Pages + m_unloadPage;
            if (page->IsLoaded && page->NodesInCache == 0 && Selector.Frame - page->VisitedFrame > FramesToUnload)
                m_state.Clouds[m_unloadCloud].Unload(m_unloadPage);
        }

        /// <summary>Bytes of all loaded pages.</summary>
        public long HierarchyBytes { get; private set; }
    }

    internal sealed class CameraMotion : IDisposable
    {
        const double MaxSpeedUp = 4; // A step this many times as long as the one before is a cut, not a motion.

        NativeList<StreamView> m_last = new NativeList<StreamView>(Allocator.Persistent);
        NativeList<StreamView> m_predicted = new NativeList<StreamView>(Allocator.Persistent);
        double m_lastStep;

        public NativeArray<StreamView> Predicted => m_predicted.AsArray();

        // False if the views stand still, cut, or changed in number.
        public bool RecordAndTryPredict(NativeArray<StreamView> views, int frames)
        {
            double step = 0;
            bool isKnown = views.Length == m_last.Length && frames > 0;
            m_predicted.Clear();
            for (int v = 0; v < views.Length && isKnown; v++)
            {
                var view = views[v];
                var motion = view.EyeWorld - m_last[v].EyeWorld;
                // A light's moves with the cameras, but by leaps.
                if (view.IsLight)
                    motion = 0;
                step = math.max(step, math.length(motion));
                view.EyeWorld += motion * frames;
                m_predicted.Add(view);
            }
            m_last.Clear();
            m_last.AddRange(views);
            bool isMoving = isKnown && step > 0 && step <= MaxSpeedUp * m_lastStep;
            m_lastStep = step;
            return isMoving;
        }

        public void Dispose()
        {
            if (!m_last.IsCreated)
                return;
            m_last.Dispose();
            m_predicted.Dispose();
        }
    }
}
