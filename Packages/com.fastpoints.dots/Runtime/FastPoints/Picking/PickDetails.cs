using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Picking
{
    /// <summary>Reads all that a cloud has of one point: each plane of its node but the position's, at once.</summary>
    sealed class PickDetails : IDisposable
    {
        readonly StreamedCloud m_cloud;
        readonly List<Plane> m_planes = new List<Plane>();
        PickHit m_hit;

        sealed class Plane
        {
            /// <summary>Counted among the planes that are streamed.</summary>
            public int Streamed;
            public StoreLayout.Plane Of;
            public StoreRead Read = new StoreRead();
            public NativeArray<ulong> Values;
            public NativeReference<bool> IsDamaged;
        }

        public PickDetails(StreamedCloud cloud)
        {
            m_cloud = cloud;
            for (int p = 1; p < cloud.Source.Planes.Length; p++)
                m_planes.Add(new Plane
                {
                    Streamed = p,
                    Of = cloud.Source.Layout.Planes[cloud.Source.Planes[p]],
                    Values = new NativeArray<ulong>(PlaneShape.MaxColumns, Allocator.Persistent),
                    IsDamaged = new NativeReference<bool>(Allocator.Persistent),
                });
        }

        /// <summary>Awaited before <see cref="End"/>.</summary>
        public JobHandle Done { get; private set; }

        public unsafe void Begin(in PickHit hit)
        {
            m_hit = hit;
            Done = default;
            foreach (var plane in m_planes)
            {
                var range = m_cloud.RangeOf(hit.Page, hit.Node, plane.Streamed);
                plane.Read.Begin(m_cloud.Source.PathOf(hit.Page), range.OffsetBytes, range.LengthBytes);
                Done = JobHandle.CombineDependencies(Done, new ReadPointJob
                {
                    Plane = plane.Read.Bytes,
                    Shape = plane.Of.Shape,
                    Hash = range.Hash,
                    BlockCount = m_cloud.Pages[hit.Page].Nodes[hit.Node].BlockCount,
                    Block = hit.Block,
                    Index = hit.Index,
                    Values = plane.Values,
                    IsDamaged = plane.IsDamaged,
                }.Schedule(plane.Read.Done));
            }
        }

        /// <returns>In the order of the source's attributes.</returns>
        /// <exception cref="PointCloudException">A plane cannot be read, or is damaged.</exception>
        public PickedAttribute[] End()
        {
            Done.Complete();
            var layout = m_cloud.Source.Layout;
            var attributes = new PickedAttribute[layout.Attributes.Count];
            foreach (var plane in m_planes)
            {
                plane.Read.Complete();
                if (plane.IsDamaged.Value)
                    throw new PointCloudException(FailureCode.BadInput, m_cloud.Source.PathOf(m_hit.Page),
                        m_cloud.RangeOf(m_hit.Page, m_hit.Node, plane.Streamed).OffsetBytes,
                        "node " + m_hit.Node + ", plane \"" + plane.Of.Name + "\": is damaged");
                for (int c = 0; c < plane.Of.ColumnCount; c++)
                {
                    int column = plane.Of.FirstColumn + c, attribute = layout.AttributeOfColumn[column];
                    attributes[attribute] = new PickedAttribute(layout.Attributes[attribute], plane.Values[c],
                        layout.Columns[column]);
                }
            }
            return attributes;
        }

        /// <summary>Awaits what is under way, which nobody wants any more.</summary>
        public void Abandon()
        {
            Done.Complete();
            foreach (var plane in m_planes)
                plane.Read.Abandon();
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
        }
    }
}
