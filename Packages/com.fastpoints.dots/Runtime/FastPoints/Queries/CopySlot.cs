using System;
using System.Collections.Generic;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Queries
{
    // Makes the copy of one node at a time: reads its streamed planes again, or transcodes them, checks them and puts a tree
    // over its blocks. Main thread; only Dispose waits.
    sealed unsafe class CopySlot : IDisposable
    {
        readonly List<StoreRead> m_reads = new List<StoreRead>();
        NativeList<UploadPart> m_parts = new NativeList<UploadPart>(8, Allocator.Persistent);
        NativeList<bool> m_isDamaged = new NativeList<bool>(8, Allocator.Persistent);
        StreamedCloud m_cloud;
        NodeTranscoder m_transcoder;
        CopiedNode m_node;
        JobHandle m_job;
        Phase m_phase;

        enum Phase : byte
        {
            Idle,
            Reading,
            Transcoding,
            Building,
            Ended,
        }

        public bool IsIdle => m_phase == Phase.Idle;

        public bool HasEnded => m_phase == Phase.Ended;

        public bool IsOf(StreamContext stream) =>
            !stream.IsDisposed && m_node.Cloud < stream.Clouds.Count && stream.Clouds[m_node.Cloud] == m_cloud;

        public long Bytes => m_phase == Phase.Idle ? 0 : m_node.Bytes; // Bytes that the node will have, or has.

        public static long BytesOf(StreamedCloud cloud, in CachedNode node) => cloud.BytesOf(node.Page, node.Node) +
            CopiedNode.BytesOfTree(cloud.Pages[node.Page].Nodes[node.Node].BlockCount);

        // False if a transcoder is needed and all are busy.
        public bool TryBegin(StreamedCloud cloud, int slot, in CachedNode node)
        {
            var source = cloud.Source;
            var found = cloud.Pages[node.Page].Nodes[node.Node];
            if (source.Transcodes(node.Page, node.Node) && (m_transcoder = source.TryRentTranscoder(found.PointCount)) == null)
                return false;
            m_cloud = cloud;
            m_node = new CopiedNode
            {
                Slot = slot,
                Version = node.Version,
                Cloud = node.Cloud,
                Page = node.Page,
                Node = node.Node,
                BlockCount = found.BlockCount,
                Bytes = BytesOf(cloud, node),
            };
            m_phase = m_transcoder != null ? Phase.Transcoding : Phase.Reading;
            if (m_transcoder != null)
            {
                m_transcoder.Begin(cloud.Pages[node.Page], node.Node);
                return true;
            }
            for (int p = 0; p < source.Planes.Length; p++)
            {
                if (m_reads.Count == p)
                    m_reads.Add(new StoreRead());
                var range = cloud.RangeOf(node.Page, node.Node, p);
                bool isComputed = source.IsComputed(p);
                m_reads[p].Begin(isComputed ? source.PathOfComputed(node.Page) : source.PlanesPathOf(node.Page),
                    range.OffsetBytes, range.LengthBytes,
                    isComputed ? source.RemoteOfComputed(node.Page) : source.PlanesRemoteOf(node.Page));
            }
            return true;
        }

        // Once a frame: whether the stream still has the cloud.
        public void Update(bool hasCloud)
        {
            if (!hasCloud && m_phase == Phase.Transcoding)
            {
                // It went with its source.
                m_transcoder = null;
                m_phase = Phase.Ended;
            }
            else if (m_phase == Phase.Reading && IsRead)
            {
                EndReading(hasCloud);
            }
            else if (m_phase == Phase.Transcoding && m_transcoder.TryScheduleDecode() && JobCoroutine.HasEnded(m_transcoder.Done))
            {
                EndTranscoding();
            }
            else if (m_phase == Phase.Building && JobCoroutine.HasEnded(m_job))
            {
                m_job.Complete();
                m_phase = Phase.Ended;
                foreach (bool isDamaged in m_isDamaged)
                    if (isDamaged)
                        m_node.Free();
            }
        }

        // What became of the node: without memory if it could not be read. The caller owns it.
        public CopiedNode Take()
        {
            m_phase = Phase.Idle;
            m_cloud = null;
            var taken = m_node;
            m_node = default;
            return taken;
        }

        public void Dispose()
        {
            if (!m_parts.IsCreated)
                return;
            m_job.Complete();
            foreach (var read in m_reads)
                read.Dispose();
            if (m_transcoder != null)
            {
                m_transcoder.Cancel();
                m_transcoder.End(out _);
                m_cloud.Source.ReturnTranscoder(m_transcoder);
                m_transcoder = null;
            }
            m_node.Free();
            m_parts.Dispose();
            m_isDamaged.Dispose();
        }

        bool IsRead
        {
            get
            {
                for (int p = 0; p < m_reads.Count; p++)
                    if (!m_reads[p].IsFetched || !JobCoroutine.HasEnded(m_reads[p].Done))
                        return false;
                return true;
            }
        }

        void EndReading(bool hasCloud)
        {
            m_phase = Phase.Ended;
            for (int p = 0; p < m_reads.Count; p++)
                try
                {
                    m_reads[p].Complete();
                }
                catch (PointCloudException)
                {
                    // Streaming reports what it cannot read itself.
                    hasCloud = false;
                }
            if (hasCloud)
                Build(UploadCheck.Hash);
        }

        void EndTranscoding()
        {
            m_phase = Phase.Ended;
            if (m_transcoder.End(out _) == TranscodeResult.Done)
            {
                m_node.Bytes = CopiedNode.BytesOfTree(m_node.BlockCount);
                for (int p = 0; p < m_cloud.Source.Planes.Length; p++)
                    m_node.Bytes += m_transcoder.LengthOf(p);
                Build(UploadCheck.None);
            }
            m_cloud.Source.ReturnTranscoder(m_transcoder);
            m_transcoder = null;
        }

        // Transcoded planes are copied at once: their memory is needed for the next node.
        void Build(UploadCheck check)
        {
            m_node.Memory = (byte*)UnsafeUtility.Malloc(Math.Max(16, m_node.Bytes), 16, Allocator.Persistent);
            byte* to = m_node.Memory + CopiedNode.BytesOfTree(m_node.BlockCount);
            m_parts.Clear();
            for (int p = 0; p < m_cloud.Source.Planes.Length; p++)
            {
                var range = m_cloud.RangeOf(m_node.Page, m_node.Node, p);
                var from = check == UploadCheck.None ? m_transcoder.PlaneOf(p) : m_reads[p].Bytes;
                if (check == UploadCheck.None)
                    UnsafeUtility.MemCpy(to, from.GetUnsafeReadOnlyPtr(), from.Length);
                else
                    m_parts.Add(new UploadPart
                    {
                        From = (byte*)from.GetUnsafeReadOnlyPtr(),
                        To = to,
                        LengthBytes = from.Length,
                        Hash = range.Hash,
                        Check = check,
                        Shape = m_cloud.ShapeOf(m_node.Page, m_node.Node, p),
                        BlockCount = m_node.BlockCount,
                    });
                m_node.SetPlane(p, to - m_node.Memory);
                to += from.Length;
            }
            m_isDamaged.Resize(m_parts.Length, NativeArrayOptions.ClearMemory);
            var isDamaged = m_isDamaged.AsArray();
            m_job = new UploadPlanesJob { Parts = m_parts.AsArray(), IsDamaged = isDamaged }
                .ScheduleParallel(m_parts.Length, 1, default);
            m_job = new FindRunsJob
            {
                IsDamaged = isDamaged,
                Positions = m_node.PlaneOf(m_cloud, StoreLayout.PositionPlane),
                Tree = m_node.Tree,
                Runs = m_node.Runs,
                Step = m_cloud.Source.Grid.Step,
            }.ScheduleParallel(m_node.BlockCount, FindRunsJob.BlocksPerSlice, m_job);
            m_job = new BuildResidentNodeJob { IsDamaged = isDamaged, Tree = m_node.Tree, Runs = m_node.Runs }.Schedule(m_job);
            m_phase = Phase.Building;
        }
    }

    // The copy of a node: runs of its points, the tree over them, then its streamed planes.
    internal unsafe struct CopiedNode
    {
        const int MaxPlanes = 16; // Streamed planes beyond these cannot be read from the copy.

        public int Slot; // In the cache, with its version.
        public int Version;
        public int Cloud;
        public int Page;
        public int Node;
        public int BlockCount;
        public byte* Memory; // Null if it could not be made.
        public long Bytes;
        fixed long m_offsetOfPlane[MaxPlanes];

        public readonly bool IsMade => Memory != null;

        // Planes begin at multiples of 16 bytes.
        public static long BytesOfTree(int blocks) => blocks * (long)(PointRun.PerBlock * sizeof(PointRun)) +
            BoxTree.EightsOf(blocks * PointRun.PerBlock) * (long)sizeof(EightBoxes);

        public readonly PointRun* Runs => (PointRun*)Memory;

        public readonly BoxTree Tree => new BoxTree
        {
            Eights = (EightBoxes*)(Runs + BlockCount * PointRun.PerBlock),
            LeafCount = BlockCount * PointRun.PerBlock,
        };

        public void SetPlane(int plane, long offset)
        {
            if (plane < MaxPlanes)
                m_offsetOfPlane[plane] = offset;
        }

        public readonly PlaneView PlaneOf(StreamedCloud cloud, int plane) => plane >= MaxPlanes ? default
            : new PlaneView(Memory + m_offsetOfPlane[plane], cloud.ShapeOf(Page, Node, plane), BlockCount);

        public void Free()
        {
            UnsafeUtility.Free(Memory, Allocator.Persistent);
            Memory = null;
            Bytes = 0;
        }
    }
}
