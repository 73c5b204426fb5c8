using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>The points that an unfinished sample shows in cells that would be empty: the first one read in each
    /// (spatial thinning). If there are too many, the cells become larger.</summary>
    sealed class PlaceholderPoints : IDisposable
    {
        /// <summary>Cells along the longest edge, divided by the root of the wanted points: a surface then has about as many
        /// cells as there are points, or a few more.</summary>
        const double CellsPerRootOfPoints = 1.05;

        /// <summary>When this share of their entries is taken, they are thinned with cells larger by this factor.</summary>
        const double MaxTaken = 0.9, CoarserCells = 1.2;

        readonly PositionTransform m_transform;
        CellHashing m_cells;
        NativeArray<ulong> m_table;
        NativeReference<int> m_count;
        JobHandle m_lastAppended;

        public PlaceholderPoints(PointSchema schema, PositionTransform transform, int wanted, BoundsGeo bounds)
        {
            m_transform = transform;
            double edge = bounds.IsEmpty ? 0 : math.cmax(bounds.Size);
            m_cells = new CellHashing
            {
                Corner = bounds.IsEmpty ? default : bounds.Min,
                CellsPerUnit = edge > 0 ? CellsPerRootOfPoints * Math.Sqrt(wanted) / edge : 0,
            };
            m_table = new NativeArray<ulong>(CellHashing.Words, Allocator.Persistent);
            // At a half, half of the sample's entries are free.
            Points = new SampleBuffer(schema, transform, Math.Max(1, wanted / 2));
            Points.MarkAllFilled();
            m_count = new NativeReference<int>(Allocator.Persistent);
        }

        public SampleBuffer Points { get; } // The first Count entries hold the points; all count as filled.
        public int Count => m_count.Value; // Not to be read while anything is in flight.
        public bool AreTooMany => m_count.Value > MaxTaken * Points.EntryCount;

        /// <summary>Adds the needed ones of a block's points, in slices, after everything scheduled before.</summary>
        /// <param name="columns">The columns of the read's points.</param>
        /// <param name="strata">The strata of the sample, which takes some of the points itself.</param>
        public JobHandle ScheduleAppend(BlockRead read, NativeArray<PointColumn> columns, SampleStrata strata, JobHandle decoded)
        {
            for (int first = 0; first < read.Range.Count; first += SampleBuffer.PointsPerSlice)
                decoded = ScheduleKeep(new AppendPlaceholdersJob
                {
                    From = read.Points.Bytes,
                    ColumnsOfSource = columns,
                    Result = read.Result,
                    First = first,
                    End = first + SampleBuffer.PointsPerSlice,
                    Positions = PositionColumns.Of(read.Points),
                    RangeFirstPoint = read.FirstPoint,
                    Strata = strata,
                }, decoded);
            return decoded;
        }

        JobHandle ScheduleKeep(AppendPlaceholdersJob job, JobHandle inputDeps)
        {
            job.Transform = m_transform;
            job.Cells = m_cells;
            job.Table = m_table;
            job.To = Points.Points.Bytes;
            job.ColumnsOfTarget = Points.Columns;
            job.Capacity = Points.EntryCount;
            job.Kept = m_count;
            return m_lastAppended = job.Schedule(JobHandle.CombineDependencies(inputDeps, m_lastAppended));
        }

        public IEnumerator<JobStep> Append(PointBatch points, int count)
        {
            var columns = SampleBuffer.ColumnsOf(points);
            var all = new NativeReference<DecodeResult>(new DecodeResult { Points = count }, Allocator.Persistent);
            try
            {
                yield return JobStep.Of(Slices.Run(0, count, SampleBuffer.PointsPerSlice, (first, end, before) =>
                    ScheduleKeep(new AppendPlaceholdersJob
                    {
                        From = points.Bytes,
                        ColumnsOfSource = columns,
                        Result = all,
                        First = first,
                        End = end,
                        Positions = PositionColumns.Of(points),
                    }, before)));
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
            yield return JobStep.Of(Slices.Run(0, own.EntryCount, SampleBuffer.EntriesPerSlice, (first, end, after) =>
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
                }.Schedule(after)));
            int count = m_count.Value;
            m_count.Value = 0;
            yield return JobStep.Of(Append(Points.Points, count));
        }

        public void Dispose()
        {
            if (!m_table.IsCreated)
                return;
            m_lastAppended.Complete();
            Points.Dispose();
            m_table.Dispose();
            m_count.Dispose();
        }
    }
}
