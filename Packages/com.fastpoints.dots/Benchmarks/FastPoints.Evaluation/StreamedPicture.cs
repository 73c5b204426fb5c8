using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Picture;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>Makes software pictures of all streamed clouds. Main thread; waits for its jobs.</summary>
    internal sealed class StreamedPicture : IDisposable
    {
        readonly List<StreamedBlocks> m_clouds = new List<StreamedBlocks>();
        readonly PictureOptions m_options;
        readonly PictureCanvas m_canvas;
        readonly SizeTree m_sizes = new SizeTree();
        float m_edlStrength;

        public StreamedPicture(PictureOptions options)
        {
            m_options = options;
            m_canvas = new PictureCanvas(options.WidthPx, options.HeightPx, Allocator.Persistent);
        }

        /// <param name="blocks">The blocks, which this picture owns.</param>
        public void Add(StreamedBlocks blocks, ColorMode mode)
        {
            m_clouds.Add(blocks);
            m_edlStrength = math.max(m_edlStrength, m_options.EdlFor(mode));
        }

        public RgbaImage Draw(in Camera camera)
        {
            m_canvas.Clear();
            bool isAdaptive = m_options.SizeInWorld?.Mode == PointSizeMode.Adaptive;
            bool isAuto = m_options.IsAutoSize && !isAdaptive;
            if (isAdaptive && m_clouds.Count > 0)
                m_sizes.Build(m_clouds[0].Stream);
            m_canvas.UseSize(math.max(PointSizing.MinPx, m_options.PointSizePx));
            var drawn = DrawAll(camera, default);
            if (isAuto)
            {
                m_canvas.ScheduleChooseSizes(1, drawn).Complete();
                m_canvas.Clear();
                drawn = DrawAll(camera, default);
            }
            if (m_options.BlendedPoints)
            {
                drawn.Complete();
                m_canvas.BeginBlending();
                drawn = DrawAll(camera, default);
            }
            var projection = new PointDrawing
            {
                Projection = new PointProjection(camera, PositionTransform.Identity, m_canvas.WidthPx, m_canvas.HeightPx),
            };
            m_canvas.ScheduleResolve(projection, m_options.Background, m_edlStrength, drawn, m_options.FillsHoles).Complete();
            return m_canvas.ToImage();
        }

        public void Dispose()
        {
            foreach (var cloud in m_clouds)
                cloud.Dispose();
            m_canvas.Dispose();
            m_sizes.Dispose();
        }

        JobHandle DrawAll(in Camera camera, JobHandle inputDeps)
        {
            foreach (var cloud in m_clouds)
                inputDeps = JobHandle.CombineDependencies(inputDeps, cloud.ScheduleDraw(camera, m_canvas, m_sizes, default));
            return inputDeps;
        }
    }
}
