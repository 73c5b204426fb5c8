using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Streaming
{
    // What the parts of a stream have in common: clouds, the nodes that have memory, and failures. Main thread.
    internal sealed unsafe class StreamState : IDisposable
    {
        const int MaxFailures = 1000;

        NativeList<CloudPages> m_cloudPages = new NativeList<CloudPages>(Allocator.Persistent);
        readonly Queue<StreamFailure> m_failures = new Queue<StreamFailure>();

        public StreamState(NodePool pool) => Pool = pool;

        public StreamSettings Settings { get; } = new StreamSettings();
        public NodePool Pool { get; }
        public NodeCache Cache { get; } = new NodeCache();
        public StreamFiles Files { get; } = new StreamFiles();
        public LodSelector Selector { get; } = new LodSelector();

        // Indexed by number; null for a removed cloud.
        public List<StreamedCloud> Clouds { get; } = new List<StreamedCloud>();

        // By number; valid until a page is loaded or a cloud comes or goes.
        public NativeArray<CloudPages> CloudPages
        {
            get
            {
                m_cloudPages.Clear();
                for (int c = 0; c < Clouds.Count; c++)
                    m_cloudPages.Add(new CloudPages { Pages = Clouds[c] != null ? Clouds[c].Pages : null });
                return m_cloudPages.AsArray();
            }
        }

        public bool TryTakeFailure(out StreamFailure failure) => m_failures.TryDequeue(out failure);

        // Evicts nodes that are needed less than one of this rank.
        public bool TryAllocateEvicting(SelectedNode node, int rank, long bytes, ref FrameStats stats, out int slot)
        {
            PoolRange range;
            while (!Pool.TryAllocate(bytes, out range))
            {
                slot = Cache.NextToEvict;
                if (slot == NodeCache.None || bytes > Pool.BankBytes)
                    return false;
                var victim = Cache[slot];
                bool isWantedMore = victim.UsedFrame == Selector.Frame && victim.Rank <= rank;
                if (isWantedMore || victim.Phase == CachePhase.Uploading)
                    return false;
                Release(slot);
                stats.EvictedNodes++;
            }
            slot = Cache.Add(node.Cloud, node.Page, node.Node, range);
            Cache.Touch(slot, Selector.Frame, rank);
            var page = Clouds[node.Cloud].Pages + node.Page;
            page->States[node.Node].Slot = slot;
            page->NodesInCache++;
            return true;
        }

        // No job may be writing to it.
        public void Release(int slot)
        {
            var removed = Cache[slot];
            var page = Clouds[removed.Cloud].Pages + removed.Page;
            page->States[removed.Node].Slot = NodeState.NoSlot;
            page->NodesInCache--;
            Pool.Release(removed.Range);
            Cache.Remove(slot);
        }

        // Its bytes differ from those written: it is retried, then reported and left as a hole.
        public void DropDamaged(int slot, int plane)
        {
            var node = Cache[slot];
            var cloud = Clouds[node.Cloud];
            var source = cloud.Source;
            string path = source.IsComputed(plane) ? source.PathOfComputed(node.Page) : source.PlanesPathOf(node.Page);
            DropDamaged(slot, new StreamFailure(path, cloud.RangeOf(node.Page, node.Node, plane).OffsetBytes,
                "node " + node.Node + " is damaged"));
        }

        public void DropDamaged(int slot, in StreamFailure failure)
        {
            var node = Cache[slot];
            var cloud = Clouds[node.Cloud];
            var state = cloud.Pages[node.Page].States + node.Node;
            Release(slot);
            cloud.Source.Invalidate(node.Page);
            if (!cloud.Source.TranscodesNodes)
                Files.Close(cloud, cloud.Source.PlanesPathOf(node.Page));
            if (cloud.Source.PathOfComputed(node.Page) is string computed)
                Files.Close(cloud, computed);
            if (cloud.IsRemoving || ++state->Failures < Settings.MaxTries)
                return;
            state->Failures = NodeState.HoleFailures;
            Report(failure);
        }

        public bool IsUnwanted(uint usedFrame) => Selector.Frame - usedFrame > (uint)Settings.FramesToCancel;

        public bool IsDue(uint frame) => (int)(Selector.Frame - frame) >= 0;

        public void Report(StreamFailure failure)
        {
            if (m_failures.Count < MaxFailures)
                m_failures.Enqueue(failure);
        }

        public void Dispose()
        {
            Clouds.Clear();
            Files.Dispose();
            m_cloudPages.Dispose();
            Selector.Dispose();
            Cache.Dispose();
            Pool.Dispose();
        }
    }
}
