using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // The normals of points that were found: reads that plane of each of their nodes once, or has it transcoded, if the cloud has
    // one.
    sealed class PickNormals : IDisposable
    {
        readonly StreamedCloud m_cloud;
        readonly int m_plane; // Among the streamed planes; -1 for none.
        readonly StoreRead m_read = new StoreRead();
        readonly HashSet<(int Page, int Node)> m_nodes = new HashSet<(int Page, int Node)>();
        NativeReference<bool> m_isDamaged = new NativeReference<bool>(Allocator.Persistent);
        NativeArray<ushort> m_codes;
        NodeTranscoder m_transcoder;

        public PickNormals(StreamedCloud cloud)
        {
            m_cloud = cloud;
            m_plane = ResidentArrays.PlaneOf(cloud.Source, StoreLayout.NormalName);
        }

        // Coroutine. The hits do not change meanwhile.
        public IEnumerator<JobStep> Read(NativeArray<PickHit> hits)
        {
            m_nodes.Clear();
            if (m_plane < 0 || hits.Length == 0)
                yield break;
            if (m_codes.Length < hits.Length)
            {
                if (m_codes.IsCreated)
                    m_codes.Dispose();
                m_codes = new NativeArray<ushort>(hits.Length, Allocator.Persistent);
            }
            for (int i = 0; i < hits.Length; i++)
                if (m_nodes.Add((hits[i].Page, hits[i].Node)))
                    yield return JobStep.Of(ReadNode(hits, hits[i].Page, hits[i].Node));
        }

        // Of a hit that was read last; 0 if it is unknown.
        public float3 NormalAt(int hit, in double3x3 toWorld) => m_nodes.Count == 0 || m_codes[hit] == OctahedralNormal.None
            ? default : (float3)math.normalize(math.mul(toWorld, (double3)OctahedralNormal.Decode(m_codes[hit])));

        public void Dispose()
        {
            m_read.Dispose();
            m_transcoder?.Dispose();
            if (m_isDamaged.IsCreated)
                m_isDamaged.Dispose();
            if (m_codes.IsCreated)
                m_codes.Dispose();
        }

        unsafe JobHandle ScheduleCopy(NativeArray<PickHit> hits, int page, int node, int blocks, bool isTranscoded) =>
            new CopyNormalsJob
            {
                Plane = isTranscoded ? m_transcoder.PlaneOf(m_plane) : m_read.Bytes,
                Shape = m_cloud.ShapeOf(page, node, m_plane),
                Hash = m_cloud.RangeOf(page, node, m_plane).Hash,
                IsTranscoded = isTranscoded,
                BlockCount = blocks > 0 ? blocks : m_cloud.Pages[page].Nodes[node].BlockCount,
                Page = page,
                Node = node,
                Hits = hits,
                Codes = m_codes,
                IsDamaged = m_isDamaged,
            }.Schedule();

        IEnumerator<JobStep> ReadNode(NativeArray<PickHit> hits, int page, int node)
        {
            var source = m_cloud.Source;
            var range = m_cloud.RangeOf(page, node, m_plane);
            bool isTranscoded = source.Transcodes(page, node), isTranscoding = isTranscoded;
            int blocks = 0, points = 0;
            var copied = default(JobHandle);
            try
            {
                if (isTranscoded)
                {
                    m_transcoder ??= source.CreateFullTranscoder();
                    Begin(page, node);
                    while (!m_transcoder.TryScheduleDecode())
                        yield return default;
                    yield return m_transcoder.Done;
                    isTranscoding = false;
                    m_transcoder.EndOrThrow();
                    m_transcoder.CorrectCounts(ref blocks, ref points);
                }
                else
                {
                    m_read.Begin(source.PathOfComputed(page), range.OffsetBytes, range.LengthBytes,
                        source.RemoteOfComputed(page));
                    while (!m_read.IsFetched)
                        yield return default;
                    yield return m_read.Done;
                    m_read.Complete();
                }
                copied = ScheduleCopy(hits, page, node, blocks, isTranscoded);
                yield return copied;
                copied.Complete();
                if (m_isDamaged.Value)
                    throw new PointCloudException(FailureCode.BadInput, source.PathOfComputed(page), range.OffsetBytes,
                        "node " + node + ", plane \"" + StoreLayout.NormalName + "\": is damaged");
            }
            finally
            {
                copied.Complete();
                m_read.Abandon();
                if (isTranscoding && m_transcoder != null)
                {
                    m_transcoder.Cancel();
                    m_transcoder.End(out _);
                }
            }
        }

        unsafe void Begin(int page, int node) => m_transcoder.Begin(m_cloud.Pages[page], node);
    }

    [BurstCompile]
    internal unsafe struct CopyNormalsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Plane;
        public PlaneShape Shape;
        public ulong Hash;
        public bool IsTranscoded; // Built in memory, so there is no hash.
        public int BlockCount;
        public int Page;
        public int Node;
        [ReadOnly] public NativeArray<PickHit> Hits;
        public NativeArray<ushort> Codes; // By hit, of those in the node.
        public NativeReference<bool> IsDamaged;

        public void Execute()
        {
            void* start = Plane.GetUnsafeReadOnlyPtr();
            IsDamaged.Value = !IsTranscoded && ContentHash.Of(start, Plane.Length) != Hash ||
                !PlaneView.IsValid(start, Plane.Length, Shape, BlockCount);
            if (IsDamaged.Value)
                return;
            var view = new PlaneView(start, Shape, BlockCount);
            for (int i = 0; i < Hits.Length; i++)
                if (Hits[i].Page == Page && Hits[i].Node == Node)
                    Codes[i] = (ushort)(view.ValueAt(Hits[i].Block, 0, Hits[i].Index) |
                        view.ValueAt(Hits[i].Block, 1, Hits[i].Index) << 8);
        }
    }
}
