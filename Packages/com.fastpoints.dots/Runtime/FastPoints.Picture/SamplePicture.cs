using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Picture
{
    static class SamplePicture
    {
        const int PointsPerSlice = 1 << 17; // About 4 ms of managed code.

        public static IEnumerator<JobStep> Draw(PictureCanvas canvas, PointBatch points, PicturePlan plan, StageProgress progress,
            Func<JobHandle, JobHandle> then = null)
        {
            var drawing = plan.DrawingOf(points, canvas);
            var shadows = canvas.Shadows;
            var shadowDrawing = shadows == null ? default : plan.ShadowDrawingOf(points, canvas);
            var all = default(JobHandle);
            try
            {
                yield return JobStep.Of(Slices.Schedule(points.Count, PointsPerSlice, (first, end, after) =>
                {
                    after = canvas.ScheduleDraw(points, first, end - first, drawing, after);
                    return shadows == null ? after
                        : shadows.ScheduleDraw(points, first, end - first, shadowDrawing, after);
                }, 1, default, drawn => all = drawn));
                all = then == null ? all : then(all);
                yield return all;
            }
            finally
            {
                all.Complete();
            }
            progress?.Report(1, points.Count, 0);
        }

        // Coroutine: chooses the point size if the options leave it open, from the sample drawn with single pixels. The canvas
        // is empty before and after.
        public static IEnumerator<JobStep> ChooseSize(PictureCanvas canvas, PointBatch points, PicturePlan plan,
            long pointsToDraw)
        {
            canvas.UseSize(plan.SizePx);
            if (!plan.UsesAutoSize || points.Count == 0)
                yield break;
            if (canvas.SamplesPerEdge > 1)
            {
                using var coarse = new PictureCanvas(canvas.WidthPx / canvas.SamplesPerEdge,
                    canvas.HeightPx / canvas.SamplesPerEdge, Allocator.Persistent);
                yield return JobStep.Of(ChooseSize(coarse, points, plan, pointsToDraw));
                canvas.UseSizesOf(coarse);
                yield break;
            }
            yield return JobStep.Of(Draw(canvas, points, plan, null,
                drawn => canvas.ScheduleChooseSizes(pointsToDraw / (double)points.Count, drawn)));
            plan.SizePx = canvas.TypicalSizePx;
            canvas.Clear();
        }

        public static IEnumerator<JobStep> DrawAndResolve(PictureCanvas canvas, PointBatch points, PicturePlan plan,
            StageProgress progress) => Draw(canvas, points, plan, progress, drawn =>
                canvas.ScheduleResolve(plan.ResolveFor(plan.Camera, canvas), drawn));
    }
}
