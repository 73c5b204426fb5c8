using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Queries
{
    // Follows which nodes of a stream are resident, with packed copies in ordinary memory: those on the graphics card cannot be
    // read. It changes only while no job reads it. Main thread; only Dispose waits.
    sealed unsafe class ResidentCopy : IDisposable
    {
        const int SlotCount = 8; // Nodes that are read at the same time.
        const int MaxFailures = 3;

        static readonly Predicate<CopySlot> s_isBusy = slot => !slot.IsIdle;

        readonly StreamContext m_stream;
        readonly List<CopySlot> m_slots = new List<CopySlot>();
        readonly ResidentArrays m_arrays;
        NativeList<CopiedNode> m_copied = new NativeList<CopiedNode>(256, Allocator.Persistent);
        NativeList<Known> m_known = new NativeList<Known>(1024, Allocator.Persistent); // By slot of the cache.
        NativeList<bool> m_isLeaving = new NativeList<bool>(256, Allocator.Persistent); // By copied node.
        JobHandle m_readers;
        bool m_lacksRoom; // For a node that a camera wants.

        // Of the version of a slot that was looked at last.
        struct Known
        {
            public int Version;
            public bool IsKnown; // In flight, copied, or impossible to copy.
            public int Copied; // One more than the index of its copy.
            public int Failures;
        }

        public ResidentCopy(StreamContext stream)
        {
            m_stream = stream;
            m_arrays = new ResidentArrays(stream);
            for (int s = 0; s < SlotCount; s++)
                m_slots.Add(new CopySlot());
        }

        public long Bytes { get; private set; }

        public bool IsComplete { get; private set; } // Whether all that was resident in the last frame is in the copy.

        public bool IsReading => m_slots.Exists(s_isBusy);

        public ResidentPoints Points => m_arrays.Points;

        public void AddReader(JobHandle job) => m_readers = JobHandle.CombineDependencies(m_readers, job);

        // Once a frame.
        public void Update(long budgetBytes)
        {
            while (m_known.Length < m_stream.Cache.SlotCount)
                m_known.Add(default);
            bool hasChanged = MarkLeaving(budgetBytes);
            foreach (var slot in m_slots)
            {
                slot.Update(HasCloud(slot));
                hasChanged |= slot.HasEnded;
            }
            if (JobCoroutine.HasEnded(m_readers))
            {
                m_readers.Complete();
                m_readers = default;
                if (hasChanged)
                    Change();
                m_arrays.Place();
            }
            IsComplete = BeginReading(budgetBytes) == 0 && !IsAnyGivenUp();
            JobHandle.ScheduleBatchedJobs();
        }

        // The packed value of one column of a hit's plane; the plane is an index among the streamed ones.
        public bool TryRead(in PointHit hit, int plane, int column, out ulong packed)
        {
            packed = 0;
            var known = hit.Slot < 0 || hit.Slot >= m_known.Length ? default : m_known[hit.Slot];
            // The cloud's number may be another's by now.
            if (known.Version != hit.Version || known.Copied == 0 || !m_stream.Cache.IsValid(hit.Slot, hit.Version))
                return false;
            var node = m_copied[known.Copied - 1];
            var view = node.PlaneOf(m_stream.Clouds[node.Cloud], plane);
            if (view.Words != null)
                packed = view.ValueAt(hit.Block, column, hit.Index);
            return view.Words != null;
        }

        public void Dispose()
        {
            if (!m_copied.IsCreated)
                return;
            m_readers.Complete();
            foreach (var slot in m_slots)
            {
                if (!HasCloud(slot))
                    slot.Update(false);
                slot.Dispose();
            }
            for (int i = 0; i < m_copied.Length; i++)
                m_copied.ElementAt(i).Free();
            m_arrays.Dispose();
            m_copied.Dispose();
            m_known.Dispose();
            m_isLeaving.Dispose();
        }

        bool IsValid(in CopiedNode node) => m_stream.Cache.IsValid(node.Slot, node.Version);

        bool HasCloud(CopySlot slot) => !slot.IsIdle && slot.IsOf(m_stream);

        // Copies of nodes that are not resident any more and, beyond the budget, of those that no camera wants.
        bool MarkLeaving(long budgetBytes)
        {
            bool isAny = false;
            long bytes = Bytes;
            m_isLeaving.Clear();
            m_isLeaving.Resize(m_copied.Length, NativeArrayOptions.ClearMemory);
            for (int i = 0; i < m_copied.Length; i++)
                if (!IsValid(m_copied[i]))
                    isAny = Leave(i, ref bytes);
            for (int i = 0; i < m_copied.Length && (bytes > budgetBytes || m_lacksRoom); i++)
                if (!m_isLeaving[i] && (bytes > budgetBytes || !IsWanted(m_stream.Cache[m_copied[i].Slot])))
                    isAny = Leave(i, ref bytes);
            return isAny;
        }

        bool Leave(int copied, ref long bytes)
        {
            m_isLeaving.ElementAt(copied) = true;
            bytes -= m_copied[copied].Bytes;
            return true;
        }

        bool IsWanted(in CachedNode node) => node.UsedFrame == m_stream.Selector.Frame;

        void Change()
        {
            for (int i = m_copied.Length - 1; i >= 0; i--)
            {
                if (!m_isLeaving[i])
                    continue;
                Bytes -= m_copied[i].Bytes;
                if (m_known[m_copied[i].Slot].Version == m_copied[i].Version)
                    m_known.ElementAt(m_copied[i].Slot) = default;
                m_copied.ElementAt(i).Free();
                m_copied.RemoveAtSwapBack(i);
            }
            foreach (var slot in m_slots)
            {
                if (!slot.HasEnded)
                    continue;
                var node = slot.Take();
                if (IsValid(node) && node.IsMade)
                {
                    Bytes += node.Bytes;
                    m_copied.Add(node);
                }
                else
                {
                    node.Free();
                    if (IsValid(node))
                        m_known.ElementAt(node.Slot).IsKnown = ++m_known.ElementAt(node.Slot).Failures >= MaxFailures;
                }
            }
            for (int i = 0; i < m_copied.Length; i++)
                if (m_known[m_copied[i].Slot].Version == m_copied[i].Version)
                    m_known.ElementAt(m_copied[i].Slot).Copied = i + 1;
            m_arrays.Fill(m_copied.AsArray());
        }

        // The most needed first. Returns how many are left.
        int BeginReading(long budgetBytes)
        {
            int left = 0;
            long bytes = Bytes;
            m_lacksRoom = false;
            foreach (var slot in m_slots)
            {
                bytes += slot.Bytes;
                left += slot.IsIdle ? 0 : 1;
            }
            foreach (var slot in m_slots)
            {
                if (!slot.IsIdle)
                    continue;
                int next = NextToCopy();
                if (next < 0)
                    break;
                left++;
                var node = m_stream.Cache[next];
                var cloud = m_stream.Clouds[node.Cloud];
                long more = CopySlot.BytesOf(cloud, node);
                if (bytes + more > budgetBytes)
                {
                    m_lacksRoom = IsWanted(node);
                    break;
                }
                if (!slot.TryBegin(cloud, next, node))
                    break;
                bytes += more;
                int failures = m_known[next].Version == node.Version ? m_known[next].Failures : 0;
                m_known[next] = new Known { Version = node.Version, IsKnown = true, Failures = failures };
            }
            return left;
        }

        bool IsAnyGivenUp()
        {
            for (int s = 0; s < m_known.Length; s++)
                if (m_known[s].Failures >= MaxFailures && m_stream.Cache.IsValid(s, m_known[s].Version))
                    return true;
            return false;
        }

        int NextToCopy()
        {
            int best = -1;
            var slots = m_stream.Cache.Nodes;
            for (int s = 0; s < slots.Length; s++)
                if (slots[s].Phase == CachePhase.Resident && !(m_known[s].IsKnown && m_known[s].Version == slots[s].Version) &&
                    !m_stream.Clouds[slots[s].Cloud].IsRemoving && (best < 0 || IsNeededMore(slots[s], slots[best])))
                    best = s;
            return best;
        }

        bool IsNeededMore(in CachedNode a, in CachedNode b) =>
            IsWanted(a) != IsWanted(b) ? IsWanted(a) : a.UsedFrame != b.UsedFrame ? a.UsedFrame > b.UsedFrame : a.Rank < b.Rank;
    }
}
