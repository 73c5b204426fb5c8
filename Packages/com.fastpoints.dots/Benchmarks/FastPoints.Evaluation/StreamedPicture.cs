using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Picture;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    internal sealed class StreamedPicture : IDisposable
    {
        readonly List<StreamedBlocks> m_clouds = new List<StreamedBlocks>();
        readonly List<DrawnBlocks> m_drawnOfCloud = new List<DrawnBlocks>();
        readonly List<DrawnBlocks> m_keptOfCloud = new List<DrawnBlocks>();
        readonly PictureOptions m_options;
        readonly PictureCanvas m_canvas;
        readonly SizeTree m_sizes = new SizeTree();
        NativeArray<ulong> m_sums; // Of blended points: see BlendedPixels.
        float m_edlStrength;

        public StreamedPicture(PictureOptions options)
        {
            m_options = options;
            m_canvas = new PictureCanvas(options.WidthPx, options.HeightPx, Allocator.Persistent, options.SamplesPerEdge);
        }

        /// <param name="blocks">The blocks, which this picture owns.</param>
        public void Add(StreamedBlocks blocks, ColorMode mode)
        {
            m_clouds.Add(blocks);
            m_drawnOfCloud.Add(new DrawnBlocks());
            m_keptOfCloud.Add(new DrawnBlocks());
            m_edlStrength = math.max(m_edlStrength, m_options.EdlFor(mode));
        }

        bool IsAdaptive => m_options.SizeInWorld?.Mode == PointSizeMode.Adaptive;

        public RgbaImage Draw(in Camera camera)
        {
            if (IsAdaptive && m_clouds.Count > 0)
                m_sizes.Build(m_clouds[0].Stream);
            for (int cloud = 0; cloud < m_clouds.Count; cloud++)
                m_clouds[cloud].Collect(m_sizes, m_drawnOfCloud[cloud]);
            return Draw(m_drawnOfCloud, camera);
        }

        public void Keep()
        {
            for (int cloud = 0; cloud < m_clouds.Count; cloud++)
                m_keptOfCloud[cloud].CopyFrom(m_drawnOfCloud[cloud]);
        }

        public RgbaImage DrawKept(in Camera camera) => Draw(m_keptOfCloud, camera);

        RgbaImage Draw(List<DrawnBlocks> blocksOfCloud, in Camera camera)
        {
            m_canvas.Clear();
            if (m_options.IsAutoSize && !IsAdaptive)
                ChooseSizes(blocksOfCloud, camera);
            else
                m_canvas.UseSize(math.max(PointSizing.MinPx, m_options.PointSizePx));
            DrawShadows(blocksOfCloud, camera);
            var drawn = DrawAll(blocksOfCloud, camera, m_canvas);
            var resolve = m_clouds[0].Plan.ResolveFor(camera, m_canvas);
            if (m_options.BlendedPoints)
            {
                drawn.Complete();
                resolve.Sums = ClearedSums();
                drawn = DrawAll(blocksOfCloud, camera, m_canvas, sums: resolve.Sums);
            }
            resolve.EdlStrength = m_edlStrength;
            m_canvas.ScheduleResolve(resolve, drawn).Complete();
            return m_canvas.ToImage();
        }

        // The picture so far shows how far away each pixel's nearest point is: drawing the same points again blends them with
        // it, at 16 more bytes a pixel. No drawing may be in flight.
        unsafe NativeArray<ulong> ClearedSums()
        {
            if (!m_sums.IsCreated)
                m_sums = new NativeArray<ulong>(m_canvas.Pixels.Length * BlendedPixels.WordsPerPixel, Allocator.Persistent,
                    NativeArrayOptions.UninitializedMemory);
            UnsafeUtility.MemClear(m_sums.GetUnsafePtr(), (long)m_sums.Length * sizeof(ulong));
            return m_sums;
        }

        void DrawShadows(List<DrawnBlocks> blocksOfCloud, in Camera camera)
        {
            var frame = m_clouds[0].Plan.ShadowFrameFor(m_clouds[0].Stream, camera);
            m_canvas.UseShadows(frame);
            if (!(frame.TexelWorld > 0))
                return;
            m_canvas.Shadows.Clear();
            DrawAll(blocksOfCloud, ShadowMap.CameraOf(frame), m_canvas.Shadows, true).Complete();
        }

        public void Dispose()
        {
            foreach (var cloud in m_clouds)
                cloud.Dispose();
            foreach (var blocks in m_drawnOfCloud)
                blocks.Dispose();
            foreach (var blocks in m_keptOfCloud)
                blocks.Dispose();
            m_canvas.Dispose();
            if (m_sums.IsCreated)
                m_sums.Dispose();
            m_sizes.Dispose();
        }

        void ChooseSizes(List<DrawnBlocks> blocksOfCloud, in Camera camera)
        {
            using var canvas = new PictureCanvas(m_options.WidthPx, m_options.HeightPx, Allocator.Persistent);
            canvas.ScheduleChooseSizes(1, DrawAll(blocksOfCloud, camera, canvas)).Complete();
            m_canvas.UseSizesOf(canvas);
        }

        JobHandle DrawAll(List<DrawnBlocks> blocksOfCloud, in Camera camera, PictureCanvas canvas, bool isPixels = false,
            NativeArray<ulong> sums = default)
        {
            var drawn = default(JobHandle);
            for (int cloud = 0; cloud < m_clouds.Count; cloud++)
                drawn = JobHandle.CombineDependencies(drawn,
                    m_clouds[cloud].ScheduleDraw(blocksOfCloud[cloud], camera, canvas, isPixels, sums));
            return drawn;
        }
    }

    /// <summary>What is streamed for pictures of a plan.</summary>
    internal static class PlannedViews
    {
        // Around what a camera sees of the stream's clouds; without texels where nothing is shaded.
        public static ShadowMapProjection ShadowFrameFor(this PicturePlan plan, StreamContext stream, in Camera camera)
        {
            if (!plan.Options.Shadows)
                return default;
            var frame = plan.NewShadowFrame();
            frame.Add(stream, camera.ToStreamView(plan.Options.WidthPx, plan.Options.HeightPx));
            frame.Fit();
            return frame;
        }

        // The camera's view, then the light's. There is room for both.
        public static NativeArray<StreamView> ViewsFor(this PicturePlan plan, StreamContext stream, in Camera camera,
            NativeArray<StreamView> views)
        {
            views[0] = camera.ToStreamView(plan.Options.WidthPx * plan.Options.SamplesPerEdge,
                plan.Options.HeightPx * plan.Options.SamplesPerEdge);
            var frame = plan.ShadowFrameFor(stream, camera);
            if (!(frame.TexelWorld > 0))
                return views.GetSubArray(0, 1);
            views[1] = frame.ViewFor(views[0]);
            return views;
        }
    }
}
