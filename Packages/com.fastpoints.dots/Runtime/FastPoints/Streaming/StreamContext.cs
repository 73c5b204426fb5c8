using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Base;
using Unity.Collections;

namespace FastPoints.Streaming
{
    /// <summary>
    /// Everything that streaming keeps from frame to frame, and its life: clouds come and go, <see cref="FrameStep"/> runs each
    /// frame, and <see cref="Dispose"/> ends it (a domain reload, quitting): reads are called off and awaited, all memory
    /// is freed. Main thread.
    /// </summary>
    public sealed unsafe class StreamContext : IDisposable
    {
        /// <summary>What is only foreseen is less needed than all that is selected.</summary>
        public const int FirstForecastRank = 1 << 30;

        /// <summary>Failures that are kept until somebody takes them.</summary>
        const int MostFailures = 1000;

        /// <summary>Frames that a hierarchy page must be out of view for until it is given up.</summary>
        const uint FramesToUnload = 300;

        readonly List<StreamedCloud> m_clouds = new List<StreamedCloud>();
        readonly Queue<StreamFailure> m_failures = new Queue<StreamFailure>();
        int m_unloadCloud;
        int m_unloadPage;

        /// <param name="pool">Becomes this context's.</param>
        public StreamContext(NodePool pool)
        {
            Pool = pool;
            Reads = new NodeReads(this);
            Uploads = new NodeUploads(this);
            ClipBoxes = new NativeList<ClipBox>(Allocator.Persistent);
            Drawn = new NativeList<DrawnNode>(1024, Allocator.Persistent);
            DrawnOfSelected = new NativeList<int>(1024, Allocator.Persistent);
        }

        public StreamSettings Settings { get; } = new StreamSettings();
        public NodePool Pool { get; }
        internal NodeCache Cache { get; } = new NodeCache();
        internal NodeSelector Selector { get; } = new NodeSelector();
        internal NodeReads Reads { get; }
        internal NodeUploads Uploads { get; }
        internal CameraMotion Motion { get; } = new CameraMotion();

        /// <summary>By number; null where a cloud is gone.</summary>
        internal IReadOnlyList<StreamedCloud> Clouds => m_clouds;

        /// <summary>What all clouds are clipped by: nothing outside is selected, loaded or drawn. May be changed from frame to
        /// frame.</summary>
        public NativeList<ClipBox> ClipBoxes { get; }

        /// <summary>What to draw after the last frame: parents before children.</summary>
        public NativeList<DrawnNode> Drawn { get; }

        /// <summary>By selected node: its place in <see cref="Drawn"/>; <see cref="NotDrawn"/>; or <see
        /// cref="NotShown"/>.</summary>
        public NativeList<int> DrawnOfSelected { get; }

        /// <summary>A hole, or hidden: what is below it can be drawn.</summary>
        public const int NotDrawn = -1;

        /// <summary>It, or something above it, is not there yet.</summary>
        public const int NotShown = -2;

        public bool IsDisposed { get; private set; }

        /// <summary>Whether a cloud that was removed still has reads or uploads under way.</summary>
        public bool HasLeaving
        {
            get
            {
                for (int c = 0; c < m_clouds.Count; c++)
                    if (m_clouds[c] != null && m_clouds[c].IsLeaving)
                        return true;
                return false;
            }
        }

        /// <summary>Replaces <see cref="ClipBoxes"/>.</summary>
        public void SetClipBoxes(List<ClipBox> boxes)
        {
            ClipBoxes.Clear();
            foreach (var box in boxes)
                ClipBoxes.Add(box);
        }

        /// <param name="source">Becomes this context's.</param>
        /// <returns>The cloud's number until it is removed.</returns>
        public int Add(NodeSource source, CloudPlacement placement)
        {
            var cloud = new StreamedCloud(source, placement);
            int free = m_clouds.IndexOf(null);
            if (free < 0)
                m_clouds.Add(cloud);
            else
                m_clouds[free] = cloud;
            return free < 0 ? m_clouds.Count - 1 : free;
        }

        /// <summary>The cloud is not shown any more; what is under way for it is called off, and its source is disposed when
        /// that has ended.</summary>
        public void Remove(int cloud)
        {
            var leaving = m_clouds[cloud];
            if (leaving == null || leaving.IsLeaving)
                return;
            leaving.IsLeaving = true;
            Reads.Cancel(leaving);
            for (int slot = 0; slot < Cache.SlotCount; slot++)
                if (Cache[slot].Phase != CachePhase.Free && Cache[slot].Cloud == cloud)
                    ReleaseIfStill(slot);
            Drawn.Clear();
        }

        /// <summary>Takes the oldest failure that nobody took yet.</summary>
        public bool TryTakeFailure(out StreamFailure failure) => m_failures.TryDequeue(out failure);

        /// <summary>Lets sources go on with what they do of their own.</summary>
        public void UpdateSources()
        {
            for (int c = 0; c < m_clouds.Count; c++)
                if (m_clouds[c] != null && !m_clouds[c].IsLeaving && m_clouds[c].Source.Update() is PointCloudException failure)
                    Report(new StreamFailure(failure.Path, failure.ByteOffset, failure.What));
        }

        /// <summary>Ends clouds that leave, and gives back what is beyond limits: at once, but for what a job writes
        /// to.</summary>
        public void TidyUp()
        {
            for (int c = 0; c < m_clouds.Count; c++)
                if (m_clouds[c] != null && m_clouds[c].IsLeaving)
                    EndLeaving(c);
            if (Pool.AllocatedBytes > Pool.LimitBytes)
                LeaveBanks();
            UnloadPage();
        }

        /// <summary>Finds room for a node, by giving up what is less useful.</summary>
        /// <param name="rank">Its place among what is needed.</param>
        public bool TryPlace(SelectedNode node, int rank, long bytes, ref FrameStats stats, out int slot)
        {
            PoolRange run;
            while (!Pool.TryTake(bytes, out run))
            {
                slot = Cache.LeastUseful;
                if (slot == NodeCache.None || bytes > Pool.BankBytes)
                    return false;
                var victim = Cache[slot];
                bool isWantedMore = victim.UsedFrame == Selector.Frame && victim.Rank <= rank;
                if (isWantedMore || victim.Phase == CachePhase.Uploading)
                    return false;
                Release(slot);
                stats.EvictedNodes++;
            }
            slot = Cache.Add(node.Cloud, node.Page, node.Node, run);
            Cache.Use(slot, Selector.Frame, rank);
            var page = m_clouds[node.Cloud].Pages + node.Page;
            page->States[node.Node].Slot = slot;
            page->NodesInCache++;
            return true;
        }

        /// <summary>Gives a node's memory back; no job writes to it.</summary>
        public void Release(int slot)
        {
            var gone = Cache[slot];
            var page = m_clouds[gone.Cloud].Pages + gone.Page;
            page->States[gone.Node].Slot = NodeState.NoSlot;
            page->NodesInCache--;
            Pool.Give(gone.Run);
            Cache.Remove(slot);
        }

        /// <summary>A node whose bytes are not those that were written: tried again, then reported and left as a hole.</summary>
        public void DropDamaged(int slot)
        {
            var node = Cache[slot];
            var cloud = m_clouds[node.Cloud];
            DropDamaged(slot, new StreamFailure(cloud.Source.PathOf(node.Page),
                cloud.RangeOf(node.Page, node.Node, 0).OffsetBytes, "node " + node.Node + " is damaged"));
        }

        /// <param name="failure">What is reported in the end.</param>
        public void DropDamaged(int slot, in StreamFailure failure)
        {
            var node = Cache[slot];
            var cloud = m_clouds[node.Cloud];
            var state = cloud.Pages[node.Page].States + node.Node;
            Release(slot);
            if (cloud.IsLeaving || ++state->Failures < Settings.MostTries)
                return;
            state->Failures = NodeState.IsHole;
            Report(failure);
        }

        /// <summary>Whether something was not wanted for so long that its read is called off.</summary>
        public bool IsOld(uint usedFrame) => Selector.Frame - usedFrame > (uint)Settings.FramesToCancel;

        /// <summary>Whether a frame has come.</summary>
        public bool IsTime(uint frame) => (int)(Selector.Frame - frame) >= 0;

        public void Report(StreamFailure failure)
        {
            if (m_failures.Count < MostFailures)
                m_failures.Enqueue(failure);
        }

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
            foreach (var cloud in m_clouds)
                cloud?.Dispose();
            m_clouds.Clear();
            Motion.Dispose();
            Selector.Dispose();
            Cache.Dispose();
            Pool.Dispose();
            ClipBoxes.Dispose();
            Drawn.Dispose();
            DrawnOfSelected.Dispose();
        }

        void ReleaseIfStill(int slot)
        {
            if (Cache[slot].Phase != CachePhase.Uploading)
                Release(slot);
        }

        void EndLeaving(int index)
        {
            var cloud = m_clouds[index];
            bool isUsed = Reads.IsUsing(cloud);
            for (int slot = 0; slot < Cache.SlotCount; slot++)
            {
                if (Cache[slot].Phase == CachePhase.Free || Cache[slot].Cloud != index)
                    continue;
                isUsed |= Cache[slot].Phase == CachePhase.Uploading;
                ReleaseIfStill(slot);
            }
            if (isUsed)
                return;
            cloud.Dispose();
            m_clouds[index] = null;
        }

        void LeaveBanks()
        {
            int limit = Pool.BankLimit;
            for (int slot = 0; slot < Cache.SlotCount; slot++)
                if (Cache[slot].Phase != CachePhase.Free && Cache[slot].Run.Bank >= limit)
                    ReleaseIfStill(slot);
            Pool.FreeEmptyBanks();
        }

        /// <summary>Looks at one page a frame, while there is more of them than there should be.</summary>
        void UnloadPage()
        {
            long bytes = 0;
            for (int c = 0; c < m_clouds.Count; c++)
                bytes += m_clouds[c] != null ? m_clouds[c].HierarchyBytes : 0;
            HierarchyBytes = bytes;
            if (bytes <= Settings.HierarchyBytes)
                return;
            if (m_unloadCloud >= m_clouds.Count || m_clouds[m_unloadCloud] == null ||
                ++m_unloadPage >= m_clouds[m_unloadCloud].PageCount)
            {
                m_unloadCloud = m_unloadCloud + 1 >= m_clouds.Count ? 0 : m_unloadCloud + 1;
                m_unloadPage = 0;
                return;
            }
            var page = m_clouds[m_unloadCloud].Pages + m_unloadPage;
            if (page->IsLoaded && page->NodesInCache == 0 && Selector.Frame - page->SeenFrame > FramesToUnload)
                m_clouds[m_unloadCloud].Unload(m_unloadPage);
        }

        /// <summary>Of all pages that are loaded.</summary>
        public long HierarchyBytes { get; private set; }
    }

    /// <summary>A node to draw: complete, as are all above it.</summary>
    public struct DrawnNode
    {
        public int Cloud;
        public int Page;
        public int Node;

        /// <summary>Place of the node above it among those that are drawn; -1 where that one is not drawn, or there is
        /// none.</summary>
        public int Parent;

        /// <summary>Its place in the <see cref="NodeCache"/>.</summary>
        public int Slot;

        /// <summary>See <see cref="CachedNode.Tint"/>.</summary>
        public uint Tint;

        /// <summary>Its planes, one after the other in the order of <see cref="NodeSource.Planes"/>.</summary>
        public PoolRange Range;
    }

    /// <summary>Something that could not be shown, after all tries.</summary>
    public readonly struct StreamFailure
    {
        public readonly string Path;

        /// <summary>Byte in the file; -1 where the whole of it is meant.</summary>
        public readonly long OffsetBytes;
        public readonly string What;

        public StreamFailure(string path, long offsetBytes, string what)
        {
            Path = path;
            OffsetBytes = offsetBytes;
            What = what;
        }

        public override string ToString() =>
            Path + (OffsetBytes >= 0 ? " at " + OffsetBytes.ToString(CultureInfo.InvariantCulture) : "") + ": " + What;
    }
}
