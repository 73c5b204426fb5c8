using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>A sample while it is being collected: a place for each wanted point, and which places are filled.</summary>
    sealed class SampleBuffer : IDisposable
    {
        /// <summary>Places in one slice of such work: about 2 ms of managed code.</summary>
        public const int PlacesPerSlice = 1 << 17;

        /// <summary>Points in one slice that looks each up in a table: about as much.</summary>
        public const int PointsPerSlice = 1 << 16;

        NativeArray<byte> m_filled;
        NativeArray<PointColumn> m_columns;
        NativeReference<CompactedSample> m_state;
        bool m_isShared;

        public SampleBuffer(PointSchema schema, int places)
        {
            Points = new PointBatch(schema, Math.Max(1, places), Allocator.Persistent);
            Places = places;
            m_filled = new NativeArray<byte>(Math.Max(1, places), Allocator.Persistent);
            m_columns = ColumnsOf(Points);
            m_state = new NativeReference<CompactedSample>(new CompactedSample { Found = PositionBounds.Empty },
                Allocator.Persistent);
        }

        public PointBatch Points { get; }
        public int Places { get; }
        public NativeArray<byte> Filled => m_filled;
        public NativeArray<PointColumn> Columns => m_columns;

        /// <summary>The location of the batch's columns, for a job. The caller disposes it.</summary>
        public static NativeArray<PointColumn> ColumnsOf(PointBatch batch)
        {
            var columns = new NativeArray<PointColumn>(batch.Schema.Count, Allocator.Persistent);
            for (int i = 0; i < columns.Length; i++)
                columns[i] = batch.Column(i);
            return columns;
        }

        /// <summary>Schedules the choice of a range's points that stand for their strata, in slices.</summary>
        /// <param name="columns">The columns of the read's points.</param>
        public JobHandle Schedule(BlockRead read, NativeArray<PointColumn> columns, SampleStrata strata, JobHandle decoded)
        {
            for (int first = 0; first < read.Range.Count; first += PlacesPerSlice)
                decoded = new SampleBlockJob
                {
                    Block = read.Points.Bytes,
                    ColumnsOfBlock = columns,
                    Result = read.Result,
                    First = first,
                    End = Math.Min(read.Range.Count, first + PlacesPerSlice),
                    FirstPoint = read.FirstPoint,
                    Strata = strata,
                    ColumnsOfSample = m_columns,
                    Sample = Points.Bytes,
                    Filled = m_filled,
                }.Schedule(decoded);
            return decoded;
        }

        /// <summary>Coroutine: closes the gaps, after everything that fills places.</summary>
        public IEnumerator<JobStep> Close(PositionTransform transform)
        {
            var all = default(JobHandle);
            try
            {
                yield return JobStep.Of(ScheduleClose(transform, 0, Places, default, closed => all = closed));
                yield return all;
            }
            finally
            {
                all.Complete();
            }
            EndClose();
        }

        /// <summary>Coroutine: schedules the same for the places after those that are closed.</summary>
        /// <param name="after">What its jobs come behind.</param>
        /// <param name="scheduled">Receives the handle of all; when it has ended, call <see cref="EndClose"/>.</param>
        public IEnumerator<JobStep> ScheduleClose(PositionTransform transform, int begin, int end, JobHandle after,
            Action<JobHandle> scheduled) => Slices.Schedule(end - begin, PlacesPerSlice, (first, stop, before) =>
                new CompactSampleJob
                {
                    Filled = m_filled,
                    Columns = m_columns,
                    Sample = Points.Bytes,
                    Positions = PositionColumns.Of(Points),
                    Transform = transform,
                    First = begin + first,
                    Count = stop - first,
                    State = m_state,
                }.Schedule(before), 1, after, scheduled);

        public void EndClose() => Points.Count = m_state.Value.Kept;

        /// <summary>Coroutine: runs of places become runs of points; after
        /// <see cref="Close(PositionTransform)"/>.</summary>
        /// <param name="runs">Runs within the closed places.</param>
        /// <param name="max">The most that there may be of them.</param>
        /// <param name="end">The end of these places.</param>
        /// <param name="after">What its jobs come behind; it is complete in the end.</param>
        public IEnumerator<JobStep> MoveRuns(NativeList<SampleRun> runs, int max, int end, JobHandle after)
        {
            var pointOfPlace = new NativeArray<int>(end + 1, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            pointOfPlace[0] = 0;
            try
            {
                yield return JobStep.Of(Slices.Schedule(end, PlacesPerSlice, (first, stop, before) => new NumberPlacesJob
                {
                    Filled = m_filled,
                    First = first,
                    End = stop,
                    PointOfPlace = pointOfPlace,
                }.Schedule(before), 1, after, numbered => after = numbered));
                yield return JobStep.Of(Slices.Run(0, max, PlacesPerSlice, (first, stop, before) => new MoveRunsJob
                {
                    PointOfPlace = pointOfPlace,
                    First = first,
                    End = stop,
                    Runs = runs,
                }.Schedule(before), 1, after));
            }
            finally
            {
                after.Complete();
                pointOfPlace.Dispose();
            }
        }

        /// <summary>Hands over the closed sample; the caller sets what else is known.</summary>
        public PreviewSample TakeSample(PositionTransform transform)
        {
            var sample = ShareSample(transform);
            Measure(sample);
            return sample;
        }

        /// <summary>A sample of what is closed so far, for <see cref="Measure"/>; the sample owns the points from now
        /// on.</summary>
        public PreviewSample ShareSample(PositionTransform transform)
        {
            m_isShared = true;
            return new PreviewSample(Points, transform);
        }

        /// <summary>Updates a sample of these points after more were closed.</summary>
        public void Measure(PreviewSample sample)
        {
            var state = m_state.Value;
            sample.Bounds = state.Found.Bounds;
            sample.NonFinite = state.Found.NonFinite;
        }

        public void Dispose()
        {
            if (!m_isShared)
                Points.Dispose();
            if (!m_filled.IsCreated)
                return;
            m_filled.Dispose();
            m_columns.Dispose();
            m_state.Dispose();
        }
    }

    /// <summary>Turns runs of places into runs of the points that remained when gaps were closed.</summary>
    [BurstCompile]
    struct MoveRunsJob : IJob
    {
        /// <summary>Has one entry more than there are places.</summary>
        [ReadOnly] public NativeArray<int> PointOfPlace;

        public int First;

        /// <summary>It may be behind the last run.</summary>
        public int End;
        public NativeList<SampleRun> Runs;

        public void Execute()
        {
            for (int i = First; i < End && i < Runs.Length; i++)
            {
                var run = Runs[i];
                int end = PointOfPlace[run.First + run.Count];
                run.First = PointOfPlace[run.First];
                run.Count = end - run.First;
                Runs[i] = run;
            }
        }
    }

    /// <summary>Finds the point at or behind each place after gaps have been closed. Slices go from front to back.</summary>
    [BurstCompile]
    struct NumberPlacesJob : IJob
    {
        /// <summary>1 at each place whose point was kept.</summary>
        [ReadOnly] public NativeArray<byte> Filled;

        public int First;
        public int End;

        /// <summary>Has one entry more than there are places; that of <see cref="First"/> is known.</summary>
        public NativeArray<int> PointOfPlace;

        public void Execute()
        {
            int kept = PointOfPlace[First];
            for (int place = First; place < End; place++)
            {
                kept += Filled[place];
                PointOfPlace[place + 1] = kept;
            }
        }
    }
}
