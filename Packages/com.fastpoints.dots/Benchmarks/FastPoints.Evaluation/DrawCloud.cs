using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Picture;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    internal sealed class DrawCloud : IBlockConsumer
    {
        const int PointsToPlanWith = 500_000;

        readonly PointReader m_reader;
        readonly PictureOptions m_options;
        readonly long m_budget;
        PictureCanvas m_canvas;

        /// <param name="budget">The most points to draw; 0 for all. A budget that is less than all is lowered to <see
        /// cref="PreviewSample.MaxPoints"/>.</param>
        public DrawCloud(PointReader reader, PictureOptions options, long budget = 0)
        {
            m_reader = reader;
            m_options = options;
            m_budget = budget;
        }

        public long PointsDrawn { get; private set; }
        public DisplayRanges Ranges { get; private set; }
        public PicturePlan Plan { get; private set; }

        public RgbaImage Image { get; private set; } // Null until the work has ended.

        public IEnumerator<JobStep> Run(StageProgress progress)
        {
            int sampled = m_budget > 0 ? (int)Math.Min(m_budget, int.MaxValue) : PointsToPlanWith;
            using var preview = new PreviewPicture(m_reader, new PreviewOptions { Points = sampled, Picture = m_options });
            yield return JobStep.Of(preview.TakeSample(progress));
            yield return JobStep.Of(preview.PlanPicture());
            var sample = preview.Sample;
            Ranges = preview.Ranges;
            Plan = preview.Plan;
            bool drawSample = sample.HasAllPoints || m_budget > 0 && m_budget < m_reader.PointCount;

            progress?.Begin("draw");
            using (m_canvas = new PictureCanvas(m_options.WidthPx, m_options.HeightPx, Allocator.Persistent,
                m_options.SamplesPerEdge))
            {
                long points = drawSample ? sample.Count : m_reader.PointCount;
                yield return JobStep.Of(SamplePicture.ChooseSize(m_canvas, sample.Points, Plan, points));
                m_canvas.UseShadows(Plan.ShadowFrameOfPicture());
                yield return JobStep.Of(drawSample
                    ? SamplePicture.Draw(m_canvas, sample.Points, Plan, progress)
                    : DrawAll(progress));
                if (drawSample)
                    PointsDrawn = sample.Count;
                yield return JobStep.Of(Resolve(m_canvas, Plan));
                Image = m_canvas.ToImage();
            }
            progress?.End();
        }

        public static IEnumerator<JobStep> Resolve(PictureCanvas canvas, PicturePlan plan)
        {
            var resolved = canvas.ScheduleResolve(plan.ResolveFor(plan.Camera, canvas), default);
            try
            {
                yield return resolved;
            }
            finally
            {
                resolved.Complete();
            }
        }

        IEnumerator<JobStep> DrawAll(StageProgress progress)
        {
            var wanted = WantedFor(Plan.Mode);
            return SourceScan.Run(m_reader, wanted, this, SourceScan.SlotsFor(m_reader, wanted), progress);
        }

        PointSchema WantedFor(ColorMode mode)
        {
            var schema = m_reader.Info.Schema;
            if (mode == ColorMode.Rgb)
                return schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z,
                    AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue);
            return Ranges.AttributeOf(mode) is string attribute
                ? schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z, attribute)
                : schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z);
        }

        public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            var drawn = Schedule(read, Plan.DrawingOf(read.Points, m_canvas), m_canvas, decoded);
            var shadows = m_canvas.Shadows;
            return shadows == null ? drawn
                : Schedule(read, Plan.ShadowDrawingOf(read.Points, m_canvas), shadows, drawn);
        }

        static JobHandle Schedule(BlockRead read, in PointDrawing drawing, PictureCanvas canvas, JobHandle decoded) =>
            new DrawBlockJob
            {
                Block = read.Points.Bytes,
                Result = read.Result,
                Palettes = canvas.Palettes,
                SizeOfTile = canvas.SizeOfTile,
                Drawing = drawing,
                Pixels = canvas.Pixels,
            }.ScheduleParallel(RasterizePointsJob.PieceCount(read.Range.Count), 1, decoded);

        public void Completed(BlockRead read, int slot) => PointsDrawn += read.Points.Count;
    }

    [BurstCompile]
    internal struct DrawBlockJob : IJobFor
    {
        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeReference<DecodeResult> Result;
        [ReadOnly] public NativeArray<uint> Palettes;
        [ReadOnly] public NativeArray<float> SizeOfTile;
        public PointDrawing Drawing;

        /// <summary>Written by atomic minimum, so that jobs on other blocks may draw at the same time.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<ulong> Pixels;

        public unsafe void Execute(int index)
        {
            int start = index * RasterizePointsJob.PointsPerPiece;
            int count = math.min(RasterizePointsJob.PointsPerPiece, Result.Value.Points - start);
            if (count > 0)
                Drawing.Draw((byte*)Block.GetUnsafeReadOnlyPtr(), start, count,
                    new PictureMemory(Palettes, SizeOfTile, Pixels));
        }
    }
}
