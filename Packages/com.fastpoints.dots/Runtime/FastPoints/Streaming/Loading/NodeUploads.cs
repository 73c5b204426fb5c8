using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    // Moves nodes from reads into the pool: one job at a time, with as much as a frame may copy.
    internal sealed unsafe class NodeUploads : IDisposable
    {
        readonly StreamState m_state;
        readonly List<NodeFetch> m_copied = new List<NodeFetch>();
        NativeList<int> m_slots = new NativeList<int>(256, Allocator.Persistent);
        NativeList<UploadPart> m_parts = new NativeList<UploadPart>(512, Allocator.Persistent);
        NativeList<bool> m_isDamaged = new NativeList<bool>(512, Allocator.Persistent);
        JobHandle m_job;

        public NodeUploads(StreamState state) => m_state = state;

        public bool IsInFlight { get; private set; }

        public void EndIfCompleted(ref FrameStats stats)
        {
            if (IsInFlight && JobCoroutine.HasEnded(m_job))
                End(ref stats);
        }

        // The oldest reads first, within the frame's budget.
        public void Begin(List<NodeFetch> fetches)
        {
            if (IsInFlight)
                return;
            m_slots.Clear();
            m_parts.Clear();
            long bytes = 0;
            while (m_slots.Length < m_state.Settings.MaxUploadNodesPerFrame)
            {
                var fetch = OldestWaiting(fetches);
                if (fetch == null)
                    break;
                var node = fetch.Nodes[fetch.FirstWaiting];
                if (!m_state.Cache.IsValid(node.Slot, node.Version))
                {
                    fetch.FirstWaiting++;
                    continue;
                }
                long size = fetch.Cloud.BytesOf(fetch.Page, node.Node);
                if (m_slots.Length > 0 && bytes + size > m_state.Settings.MaxUploadBytesPerFrame)
                    break;
                if (m_slots.Length == 0 && !m_state.Pool.TryBeginUpload(m_state.Settings.MaxUploadBytesPerFrame))
                    return;
                byte* to = m_state.Pool.ReserveForUpload(m_state.Cache[node.Slot].Range, size);
                if (to == null)
                    break;
                bytes += size;
                fetch.AddUploadParts(fetch.FirstWaiting++, to, m_slots.Length, m_parts);
                m_slots.Add(node.Slot);
                m_state.Cache.SetPhase(node.Slot, CachePhase.Uploading);
                if (!fetch.IsBeingCopied)
                    m_copied.Add(fetch);
                fetch.IsBeingCopied = true;
            }
            if (m_slots.Length == 0)
                return;
            m_isDamaged.ResizeUninitialized(m_parts.Length);
            m_job = new UploadPlanesJob { Parts = m_parts.AsArray(), IsDamaged = m_isDamaged.AsArray() }
                .ScheduleParallel(m_parts.Length, 1, default);
            IsInFlight = true;
        }

        public void Await()
        {
            var stats = new FrameStats();
            m_job.Complete();
            if (IsInFlight)
                End(ref stats);
        }

        public void Dispose()
        {
            if (!m_slots.IsCreated)
                return;
            m_job.Complete();
            m_slots.Dispose();
            m_parts.Dispose();
            m_isDamaged.Dispose();
        }

        void End(ref FrameStats stats)
        {
            m_job.Complete();
            IsInFlight = false;
            m_state.Pool.EndUpload();
            foreach (var fetch in m_copied)
                fetch.IsBeingCopied = false;
            m_copied.Clear();
            for (int part = 0, upload = 0; upload < m_slots.Length; upload++)
            {
                int damaged = -1;
                var node = m_state.Cache[m_slots[upload]];
                var source = m_state.Clouds[node.Cloud].Source;
                for (int plane = 0; part < m_parts.Length && m_parts[part].Upload == upload; part++, plane++)
                {
                    damaged = m_isDamaged[part] ? plane : damaged;
                    stats.UploadedBytes += m_parts[part].LengthBytes;
                    if (m_parts[part].Check == UploadCheck.Hash && !m_isDamaged[part])
                        source.SetVerified(node.Page, node.Node, plane);
                }
                stats.UploadedNodes++;
                m_state.Cache.SetPhase(m_slots[upload], CachePhase.Resident);
                if (damaged >= 0)
                    m_state.DropDamaged(m_slots[upload], damaged);
            }
        }

        static NodeFetch OldestWaiting(List<NodeFetch> fetches)
        {
            NodeFetch oldest = null;
            for (int i = 0; i < fetches.Count; i++)
            {
                var fetch = fetches[i];
                if (fetch.Phase == FetchPhase.Arrived && fetch.FirstWaiting < fetch.Nodes.Length &&
                    (oldest == null || fetch.SequenceNumber < oldest.SequenceNumber))
                    oldest = fetch;
            }
            return oldest;
        }
    }

    internal unsafe struct UploadPart
    {
        public byte* From;
        public byte* To;
        public long LengthBytes;
        public ulong Hash;
        public UploadCheck Check;
        public PlaneShape Shape;
        public int BlockCount;
        public int Upload;
    }

    internal enum UploadCheck : byte
    {
        None, // It was just transcoded in memory.
        // Its hash was right before. Even if the file has changed since, its bytes must not lead outside of it.
        Shape,
        Hash,
    }

    // Copies planes into the pool unchanged, and reports whether each is intact and can be drawn.
    [BurstCompile]
    internal unsafe struct UploadPlanesJob : IJobFor
    {
        [ReadOnly] public NativeArray<UploadPart> Parts;
        public NativeArray<bool> IsDamaged;

        public void Execute(int index)
        {
            var part = Parts[index];
            bool isValid = true;
            if (part.Check == UploadCheck.Hash)
                isValid = ContentHash.CopyAndHash(part.To, part.From, part.LengthBytes) == part.Hash;
            else
                UnsafeUtility.MemCpy(part.To, part.From, part.LengthBytes);
            IsDamaged[index] = !isValid || part.Check != UploadCheck.None &&
                !PlaneView.IsValid(part.From, part.LengthBytes, part.Shape, part.BlockCount);
        }
    }
}
