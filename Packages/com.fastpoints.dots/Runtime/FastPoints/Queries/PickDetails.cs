using System;
using System.Collections.Generic;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Queries
{
    // Reads the attributes of one point: every plane of its node that has some, at once; or transcodes them.
    sealed class PickDetails : IDisposable
    {
        readonly StreamedCloud m_cloud;
        readonly List<Plane> m_planes = new List<Plane>();
        PickHit m_hit;
        NodeTranscoder m_transcoder;
        bool m_isTranscoding;
        bool m_isTranscoded;
        int m_blockCount;
        JobHandle m_done;

        sealed class Plane
        {
            public int Number; // Among the planes that are streamed or transcoded.
            public StoreLayout.Plane Layout;
            public StoreRead Read = new StoreRead();
            public NativeArray<ulong> Values;
            public NativeReference<bool> IsDamaged;
        }

        public PickDetails(StreamedCloud cloud)
        {
            m_cloud = cloud;
            int count = Source.TranscodesNodes ? Source.Layout.Planes.Count : Source.Planes.Length;
            for (int p = 1; p < count && (Source.TranscodesNodes || !Source.IsComputed(p)); p++)
                m_planes.Add(new Plane
                {
                    Number = p,
                    Layout = Source.Layout.Planes[Source.TranscodesNodes ? p : Source.Planes[p]],
                    Values = new NativeArray<ulong>(PlaneShape.MaxColumns, Allocator.Persistent),
                    IsDamaged = new NativeReference<bool>(Allocator.Persistent),
                });
        }

        public JobHandle Done => m_isTranscoding ? m_transcoder.Done : m_done; // To await before the next call.

        public bool TryContinueReads() =>
            m_isTranscoding ? m_transcoder.TryScheduleDecode() : m_planes.TrueForAll(plane => plane.Read.IsFetched);

        NodeSource Source => m_cloud.Source;

        public unsafe void Begin(in PickHit hit)
        {
            m_hit = hit;
            m_done = default;
            m_blockCount = m_cloud.Pages[hit.Page].Nodes[hit.Node].BlockCount;
            m_isTranscoded = Source.Transcodes(hit.Page, hit.Node);
            if (m_isTranscoded)
            {
                m_transcoder ??= Source.CreateFullTranscoder();
                m_transcoder.Begin(m_cloud.Pages[hit.Page], hit.Node);
                m_isTranscoding = true;
                return;
            }
            foreach (var plane in m_planes)
            {
                var range = m_cloud.RangeOf(hit.Page, hit.Node, plane.Number);
                var remote = Source.PlanesRemoteOf(hit.Page);
                plane.Read.Begin(Source.PlanesPathOf(hit.Page), range.OffsetBytes, range.LengthBytes, remote);
                if (remote == null)
                    Schedule(plane, plane.Read.Bytes, range.Hash, plane.Read.Done);
            }
        }

        // Reads the transcoded or fetched planes, if any. Call End after Done.
        public void Continue()
        {
            foreach (var plane in m_planes)
                if (Source.PlanesRemoteOf(m_hit.Page) != null)
                {
                    plane.Read.Complete();
                    Schedule(plane, plane.Read.Bytes, m_cloud.RangeOf(m_hit.Page, m_hit.Node, plane.Number).Hash, default);
                }
            if (!m_isTranscoding)
                return;
            m_isTranscoding = false;
            m_transcoder.EndOrThrow();
            int points = 0;
            m_transcoder.CorrectCounts(ref m_blockCount, ref points);
            m_done = default;
            foreach (var plane in m_planes)
                Schedule(plane, m_transcoder.PlaneOf(plane.Number), 0, default);
        }

        // In the order of the source's attributes.
        public PickedAttribute[] End()
        {
            Done.Complete();
            var layout = Source.Layout;
            var attributes = new PickedAttribute[layout.Attributes.Count];
            foreach (var plane in m_planes)
            {
                plane.Read.Complete();
                if (plane.IsDamaged.Value)
                    throw new PointCloudException(FailureCode.BadInput, Source.PlanesPathOf(m_hit.Page),
                        m_cloud.RangeOf(m_hit.Page, m_hit.Node, plane.Number).OffsetBytes,
                        "node " + m_hit.Node + ", plane \"" + plane.Layout.Name + "\": is damaged");
                for (int c = 0; c < plane.Layout.ColumnCount; c++)
                {
                    int column = plane.Layout.FirstColumn + c, attribute = layout.AttributeOfColumn[column];
                    attributes[attribute] = new PickedAttribute(layout.Attributes[attribute], plane.Values[c],
                        layout.Columns[column]);
                }
            }
            return attributes;
        }

        public void Abandon()
        {
            Done.Complete();
            foreach (var plane in m_planes)
                plane.Read.Abandon();
            if (m_isTranscoding)
            {
                m_transcoder.Cancel();
                m_transcoder.End(out _);
            }
            m_isTranscoding = false;
        }

        public void Dispose()
        {
            Abandon();
            foreach (var plane in m_planes)
            {
                plane.Read.Dispose();
                plane.Values.Dispose();
                plane.IsDamaged.Dispose();
            }
            m_planes.Clear();
            m_transcoder?.Dispose();
        }

        unsafe void Schedule(Plane plane, NativeArray<byte> bytes, ulong hash, JobHandle inputDeps) =>
            m_done = JobHandle.CombineDependencies(Done, new ReadPointJob
            {
                Plane = bytes,
                Shape = plane.Layout.Shape,
                Hash = hash,
                IsTranscoded = m_isTranscoded,
                BlockCount = m_blockCount,
                Block = m_hit.Block,
                Index = m_hit.Index,
                Values = plane.Values,
                IsDamaged = plane.IsDamaged,
            }.Schedule(inputDeps));
    }

    [BurstCompile]
    internal unsafe struct ReadPointJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Plane;
        public PlaneShape Shape;
        public ulong Hash;
        public bool IsTranscoded; // Built in memory, so there is no hash.
        public int BlockCount;
        public int Block;
        public int Index; // In its block.
        public NativeArray<ulong> Values; // Packed, of each column.
        public NativeReference<bool> IsDamaged;

        public void Execute()
        {
            void* start = Plane.GetUnsafeReadOnlyPtr();
            IsDamaged.Value = (!IsTranscoded && ContentHash.Of(start, Plane.Length) != Hash) ||
                !PlaneView.IsValid(start, Plane.Length, Shape, BlockCount);
            if (IsDamaged.Value)
                return;
            var view = new PlaneView(start, Shape, BlockCount);
            for (int c = 0; c < Shape.ColumnCount; c++)
                Values[c] = view.ValueAt(Block, c, Index);
        }
    }
}
