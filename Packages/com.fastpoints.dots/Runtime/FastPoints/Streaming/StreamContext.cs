using System;
using System.Collections.Generic;
using FastPoints.Base;
using Unity.Collections;

namespace FastPoints.Streaming
{
    /// <summary>Everything that streaming keeps from frame to frame, and its lifetime: clouds come and go,
    /// <see cref="FrameStep"/> runs each frame, and <see cref="Dispose"/> ends it (on a domain reload or on quitting): it cancels
    /// and awaits reads and frees all memory. Main thread.</summary>
    public sealed unsafe class StreamContext : IDisposable
    {
        /// <summary>Foreseen nodes rank behind all selected ones.</summary>
        public const int FirstForecastRank = 1 << 30;

        /// <summary>The most failures that are kept until they are taken.</summary>
        const int MostFailures = 1000;

        /// <summary>A hierarchy page must be out of view for this many frames before it is unloaded.</summary>
        const uint FramesToUnload = 300;

        readonly List<StreamedCloud> m_clouds = new List<StreamedCloud>();
        readonly Queue<StreamFailure> m_failures = new Queue<StreamFailure>();
        int m_unloadCloud;
        int m_unloadPage;

        /// <param name="pool">This context owns it.</param>
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

        /// <summary>Indexed by number; null for a removed cloud.</summary>
        internal IReadOnlyList<StreamedCloud> Clouds => m_clouds;

        /// <summary>The boxes that all clouds are clipped by: nothing outside is selected, loaded or drawn. They may change from
        /// frame to frame.</summary>
        public NativeList<ClipBox> ClipBoxes { get; }

        /// <summary>What to draw after the last frame: parents before children.</summary>
        public NativeList<DrawnNode> Drawn { get; }

        /// <summary>For each selected node, its index in <see cref="Drawn"/>, or <see cref="NotDrawn"/>, or
        /// <see cref="NotShown"/>.</summary>
        public NativeList<int> DrawnOfSelected { get; }

        /// <summary>The node is a hole or hidden, but what is below it can be drawn.</summary>
        public const int NotDrawn = -1;

        /// <summary>The node, or one above it, is not loaded yet.</summary>
        public const int NotShown = -2;

        public bool IsDisposed { get; private set; }

        /// <summary>Whether a removed cloud still has reads or uploads in flight.</summary>
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

        /// <param name="source">This context owns it.</param>
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

        /// <summary>Removes a cloud from what is shown. Its reads and uploads are cancelled; its source is disposed when these
        /// have ended.</summary>
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

        /// <summary>Takes the oldest failure that was not taken yet.</summary>
        public bool TryTakeFailure(out StreamFailure failure) => m_failures.TryDequeue(out failure);

        /// <summary>Lets sources continue work of their own.</summary>
        public void UpdateSources()
        {
            for (int c = 0; c < m_clouds.Count; c++)
                if (m_clouds[c] != null && !m_clouds[c].IsLeaving && m_clouds[c].Source.Update() is PointCloudException failure)
                    Report(new StreamFailure(failure.Path, failure.ByteOffset, failure.What));
        }

        /// <summary>Ends clouds that leave and frees what exceeds limits, except memory that a job writes to.</summary>
        public void TidyUp()
        {
            for (int c = 0; c < m_clouds.Count; c++)
                if (m_clouds[c] != null && m_clouds[c].IsLeaving)
                    EndLeaving(c);
            if (Pool.AllocatedBytes > Pool.LimitBytes)
                LeaveBanks();
            UnloadPage();
        }

        /// <summary>Finds room for a node by evicting less useful ones.</summary>
        /// <param name="rank">Its rank among the needed nodes.</param>
        internal bool TryPlace(SelectedNode node, int rank, long bytes, ref FrameStats stats, out int slot)
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

        /// <summary>Frees a node's memory; no job may be writing to it.</summary>
        public void Release(int slot)
        {
            var gone = Cache[slot];
            var page = m_clouds[gone.Cloud].Pages + gone.Page;
            page->States[gone.Node].Slot = NodeState.NoSlot;
            page->NodesInCache--;
            Pool.Give(gone.Run);
            Cache.Remove(slot);
        }

        /// <summary>Drops a node whose bytes differ from those written: it is retried, then reported and left as a
        /// hole.</summary>
        public void DropDamaged(int slot)
        {
            var node = Cache[slot];
            var cloud = m_clouds[node.Cloud];
            DropDamaged(slot, new StreamFailure(cloud.Source.PathOf(node.Page),
                cloud.RangeOf(node.Page, node.Node, 0).OffsetBytes, "node " + node.Node + " is damaged"));
        }

        /// <param name="failure">The failure to report in the end.</param>
        public void DropDamaged(int slot, in StreamFailure failure)
        {
            var node = Cache[slot];
            var cloud = m_clouds[node.Cloud];
            var state = cloud.Pages[node.Page].States + node.Node;
            Release(slot);
            cloud.Source.ForgetChecked(node.Page);
            if (cloud.IsLeaving || ++state->Failures < Settings.MostTries)
                return;
            state->Failures = NodeState.IsHole;
            Report(failure);
        }

        /// <summary>Whether something has not been wanted for so long that its read is cancelled.</summary>
        public bool IsOld(uint usedFrame) => Selector.Frame - usedFrame > (uint)Settings.FramesToCancel;

        /// <summary>Whether a frame number has been reached.</summary>
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

        /// <summary>Examines one page each frame while there are more than there should be.</summary>
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

        /// <summary>Bytes of all loaded pages.</summary>
        public long HierarchyBytes { get; private set; }
    }

    /// <summary>A node to draw: it and all nodes above it are complete.</summary>
    public struct DrawnNode
    {
        public int Cloud;
        public int Page;
        public int Node;

        /// <summary>Index of the node above it among those drawn; -1 if that one is not drawn or does not exist.</summary>
        public int Parent;

        /// <summary>Its slot in the <see cref="NodeCache"/>.</summary>
        public int Slot;

        /// <summary>See <see cref="CachedNode.Tint"/>.</summary>
        public uint Tint;

        /// <summary>Its planes, one after the other in the order of <see cref="NodeSource.Planes"/>.</summary>
        public PoolRange Range;
    }

    /// <summary>Something that could not be shown after all retries.</summary>
    public readonly struct StreamFailure
    {
        public readonly string Path;

        /// <summary>Offset in the file; -1 for the whole file.</summary>
        public readonly long OffsetBytes;
        public readonly string What;

        public StreamFailure(string path, long offsetBytes, string what)
        {
            Path = path;
            OffsetBytes = offsetBytes;
            What = what;
        }

        public override string ToString() =>
            Path + (OffsetBytes >= 0 ? " at " + NumberText.Of(OffsetBytes) : "") + ": " + What;
    }
}
