using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Build
{
    internal static class NormalEstimator
    {
        /// <summary>Coroutine.</summary>
        /// <param name="batch">Positions in grid steps from the root's corner, those in the region's margin too.</param>
        /// <param name="normals">By point of the batch; those of the region's own points are set.</param>
        /// <param name="workers">The most to keep busy; 0 for all.</param>
        public static IEnumerator<JobStep> Run(PointBatch batch, NormalRegion region, NativeArray<ushort> normals,
            SliceTimes slices, int workers = 0)
        {
            int chains = workers > 0 ? Math.Min(workers, Slices.MaxChains) : Slices.MaxChains;
            var points = new RegionPoints(Math.Max(1, batch.Count), region);
            var done = default(JobHandle);
            try
            {
                NativeArray<double> x = batch.Column<double>(AttributeNames.X), y = batch.Column<double>(AttributeNames.Y),
                    z = batch.Column<double>(AttributeNames.Z);
                yield return JobStep.Of(Slices.Run(0, batch.Count, ListRegionJob.PointsPerSlice, (first, end, after) =>
                    done = new ListRegionJob
                    {
                        First = first,
                        End = end,
                        Region = region,
                        X = x,
                        Y = y,
                        Z = z,
                        Points = points,
                        SliceTimes = slices,
                    }.Schedule(after)));
                int count = points.Count.Value;
                yield return JobStep.Of(Slices.Run(0, count, ScatterRegionJob.PointsPerSlice, (first, end, after) =>
                    done = new ScatterRegionJob { First = first, End = end, Points = points, SliceTimes = slices }
                        .Schedule(after)));
                yield return JobStep.Of(Slices.Run(0, count, SortRegionJob.PointsPerSlice, (first, end, after) =>
                    new SortRegionJob { First = first, End = end, Region = region, X = x, Y = y, Z = z, Points = points }
                        .Schedule(after), chains));
                yield return JobStep.Of(Slices.Run(0, count, EstimateNormalsJob.PointsPerSlice, (first, end, after) =>
                    new EstimateNormalsJob { First = first, End = end, Region = region, Points = points, Normals = normals }
                        .Schedule(after), chains));
            }
            finally
            {
                done.Complete();
                points.Dispose();
            }
        }
    }
}
