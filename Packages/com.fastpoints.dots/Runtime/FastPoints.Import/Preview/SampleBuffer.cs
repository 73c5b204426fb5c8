using System;
using System.Collections.Generic;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>A sample while it is collected: a place for each point that is wanted, and which of them are filled.</summary>
    sealed class SampleBuffer : IDisposable
    {
        /// <summary>Places of one slice of the closing work: about 2 ms of managed code.</summary>
        const int PlacesPerSlice = 1 << 17;

        NativeArray<byte> m_filled;
        NativeArray<PointColumn> m_columns;
        NativeReference<CompactedSample> m_state;

        public SampleBuffer(PointSchema schema, int places)
        {
            Points = new PointBatch(schema, Math.Max(1, places), Allocator.Persistent);
            Places = places;
            m_filled = new NativeArray<byte>(Math.Max(1, places), Allocator.Persistent);
            m_columns = ColumnsOf(Points);
            m_state = new NativeReference<CompactedSample>(new CompactedSample { Found = PositionBounds.Empty },
                Allocator.Persistent);
        }

        public PointBatch Points { get; private set; }
        public int Places { get; }
        public NativeArray<byte> Filled => m_filled;
        public NativeArray<PointColumn> Columns => m_columns;

        /// <summary>Where the batch keeps its columns, for a job. The caller disposes it.</summary>
        public static NativeArray<PointColumn> ColumnsOf(PointBatch batch)
        {
            var columns = new NativeArray<PointColumn>(batch.Schema.Count, Allocator.Persistent);
            for (int i = 0; i < columns.Length; i++)
                columns[i] = batch.Column(i);
            return columns;
        }

        /// <summary>Work for a pump: closes the gaps; after all that fills.</summary>
        public IEnumerator<JobHandle> Close(PositionTransform transform)
        {
            for (int first = 0; first < Places; first += PlacesPerSlice)
            {
                var slice = new CompactSampleJob
                {
                    Filled = m_filled,
                    Columns = m_columns,
                    Sample = Points.Bytes,
                    Positions = PositionColumns.Of(Points),
                    Transform = transform,
                    First = first,
                    Count = Math.Min(PlacesPerSlice, Places - first),
                    State = m_state,
                }.Schedule();
                try
                {
                    yield return slice;
                }
                finally
                {
                    slice.Complete();
                }
            }
            Points.Count = m_state.Value.Kept;
        }

        /// <summary>Hands the closed sample over; the caller sets what is known beside.</summary>
        public PreviewSample TakeSample(PositionTransform transform)
        {
            var state = m_state.Value;
            var sample = new PreviewSample(Points, transform) { Bounds = state.Found.Bounds, NonFinite = state.Found.NonFinite };
            Points = null;
            return sample;
        }

        public void Dispose()
        {
            Points?.Dispose();
            if (!m_filled.IsCreated)
                return;
            m_filled.Dispose();
            m_columns.Dispose();
            m_state.Dispose();
        }
    }
}
