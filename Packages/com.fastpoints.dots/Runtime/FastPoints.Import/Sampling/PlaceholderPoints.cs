using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>What an unfinished sample shows where it has no point yet: the first point read in each cell that would be empty
    /// (spatial thinning). When there are too many, the cells become larger.</summary>
    sealed class PlaceholderPoints : IDisposable
    {
        /// <summary>Cells along the longest edge, divided by the root of the wanted points: a surface then has about as many
        /// cells as there are points, or a few more.</summary>
        const double CellsPerRootOfPoints = 1.05;

        /// <summary>When this share of their places is taken, they are thinned with cells larger by this factor.</summary>
        const double MaxTaken = 0.9, CoarserCells = 1.2;

        readonly PositionTransform m_transform;
        EmptyCells m_cells;
        NativeArray<ulong> m_table;
        NativeArray<PointColumn> m_columns;
        NativeReference<int> m_count;
        JobHandle m_lastAppended;

        /// <param name="wanted">Number of points in the sample.</param>
        /// <param name="bounds">The bounds of nearly all points.</param>
        public PlaceholderPoints(PointSchema schema, PositionTransform transform, int wanted, BoundsGeo bounds)
        {
            m_transform = transform;
            double edge = bounds.IsEmpty ? 0 : math.cmax(bounds.Size);
            m_cells = new EmptyCells
            {
                Corner = bounds.IsEmpty ? default : bounds.Min,
                CellsPerUnit = edge > 0 ? CellsPerRootOfPoints * Math.Sqrt(wanted) / edge : 0,
            };
            m_table = new NativeArray<ulong>(EmptyCells.Words, Allocator.Persistent);
            // At a half, half of the sample's places are free.
            Points = new PointBatch(schema, Math.Max(1, wanted / 2), Allocator.Persistent);
            m_columns = SampleBuffer.ColumnsOf(Points);
            m_count = new NativeReference<int>(Allocator.Persistent);
        }

        public PointBatch Points { get; }
        public NativeArray<PointColumn> Columns => m_columns;

        /// <summary>Do not read it while anything is in flight.</summary>
        public int Count => m_count.Value;
        public bool AreTooMany => m_count.Value > MaxTaken * Points.Capacity;

        /// <summary>Adds the needed ones of a block's points, in slices, after everything scheduled before.</summary>
        /// <param name="count">The most points that there may be.</param>
        /// <param name="strata">The strata of the sample, which takes some of the points itself.</param>
        public JobHandle ScheduleAppend(PointBatch points, NativeArray<PointColumn> columns, NativeReference<DecodeResult> result,
            int count, long firstPoint, SampleStrata strata, JobHandle inputDeps)
        {
            for (int first = 0; first < count; first += SampleBuffer.PointsPerSlice)
                inputDeps = ScheduleAppend(points, columns, result, first, first + SampleBuffer.PointsPerSlice, firstPoint,
                    strata, inputDeps);
            return inputDeps;
        }

        JobHandle ScheduleAppend(PointBatch points, NativeArray<PointColumn> columns, NativeReference<DecodeResult> result,
            int first, int end, long firstPoint, SampleStrata strata, JobHandle inputDeps)
        {
            m_lastAppended = new AppendEmptyCellsJob
            {
                Block = points.Bytes,
                ColumnsOfBlock = columns,
                Result = result,
                First = first,
                End = end,
                Positions = PositionColumns.Of(points),
                Transform = m_transform,
                FirstPoint = firstPoint,
                Strata = strata,
                Cells = m_cells,
                Table = m_table,
                ColumnsOfSample = m_columns,
                Sample = Points.Bytes,
                Capacity = Points.Capacity,
                Filled = m_count,
            }.Schedule(JobHandle.CombineDependencies(inputDeps, m_lastAppended));
            return m_lastAppended;
        }

        /// <summary>Coroutine: adds the needed ones of a sample's points.</summary>
        public IEnumerator<JobStep> Append(PreviewSample sample)
        {
            var columns = SampleBuffer.ColumnsOf(sample.Points);
            var all = new NativeReference<DecodeResult>(new DecodeResult { Points = sample.Count }, Allocator.Persistent);
            try
            {
                yield return JobStep.Of(Slices.Run(0, sample.Count, SampleBuffer.PointsPerSlice, (first, end, after) =>
                    ScheduleAppend(sample.Points, columns, all, first, end, 0, default, after)));
            }
            finally
            {
                m_lastAppended.Complete();
                columns.Dispose();
                all.Dispose();
            }
        }

        /// <summary>Coroutine: enlarges the cells, then calls <see cref="Thin"/>.</summary>
        public IEnumerator<JobStep> Coarsen(SampleBuffer own)
        {
            m_cells.CellsPerUnit /= CoarserCells;
            return Thin(own);
        }

        /// <summary>Coroutine: marks the sample's own points again, and keeps the placeholders in cells without any of
        /// these.</summary>
        public IEnumerator<JobStep> Thin(SampleBuffer own)
        {
            int count = m_count.Value, places = own.Places;
            var marked = default(JobHandle);
            yield return JobStep.Of(Slices.Schedule(places, SampleBuffer.PlacesPerSlice, (first, end, after) =>
                new MarkCellsJob
            {
                Sample = own.Points.Bytes,
                Filled = own.Filled,
                Positions = PositionColumns.Of(own.Points),
                Transform = m_transform,
                First = first,
                End = end,
                Cells = m_cells,
                Table = m_table,
            }.Schedule(after), 1, default, all => marked = all));
            yield return JobStep.Of(Slices.Run(0, count, SampleBuffer.PointsPerSlice, (first, end, after) => new KeepEmptyCellsJob
            {
                Columns = m_columns,
                Points = Points.Bytes,
                Positions = PositionColumns.Of(Points),
                Transform = m_transform,
                First = first,
                End = end,
                Cells = m_cells,
                Table = m_table,
                Kept = m_count,
            }.Schedule(after), 1, marked));
        }

        public void Dispose()
        {
            if (!m_table.IsCreated)
                return;
            m_lastAppended.Complete();
            Points.Dispose();
            m_table.Dispose();
            m_columns.Dispose();
            m_count.Dispose();
        }
    }
}
