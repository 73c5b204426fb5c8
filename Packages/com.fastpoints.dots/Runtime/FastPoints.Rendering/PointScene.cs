using System;
using System.Collections.Generic;
using FastPoints.Gpu;
using FastPoints.Streaming;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    /// <summary>
    /// All clouds of a world, for every camera that draws them: what a pipeline's pass needs to know. A camera that is about to
    /// be drawn is announced, so that the next frame selects for it, and then recorded. Main thread.
    /// </summary>
    public sealed class PointScene : IDisposable
    {
        /// <summary>A camera that was not drawn for so many frames gives its buffers back.</summary>
        const int FramesToForget = 120;

        readonly GraphicsNodePool m_pool;
        readonly PointMaterials m_materials;
        readonly SizeTree m_sizes = new SizeTree();
        readonly List<CloudLook> m_looks = new List<CloudLook>();
        readonly List<SeenCamera> m_cameras = new List<SeenCamera>();
        NativeList<StreamView> m_nextViews;
        NativeArray<uint> m_palette;
        int m_frame;

        /// <summary>One camera's buffers.</summary>
        sealed class SeenCamera
        {
            public Camera Camera;
            public PointRenderer Renderer;
            public int LastFrame;
        }

        /// <param name="points">The package's Points.shader.</param>
        /// <param name="compose">The package's Compose.shader.</param>
        /// <param name="stream">Its pool is on the graphics card; not this scene's.</param>
        /// <param name="raster">The package's RasterPoints.compute; null to do without.</param>
        public PointScene(Shader points, Shader compose, StreamContext stream, ComputeShader raster = null)
        {
            Stream = stream;
            m_pool = (GraphicsNodePool)stream.Pool;
            m_materials = new PointMaterials(points, compose, raster);
            m_nextViews = new NativeList<StreamView>(Allocator.Persistent);
            m_palette = new NativeArray<uint>(PointRenderer.PaletteLength, Allocator.Persistent);
        }

        /// <summary>What passes draw; null for nothing.</summary>
        public static PointScene Current { get; set; }

        public StreamContext Stream { get; }
        public PointStyle Style { get; set; } = PointStyle.Default;

        /// <summary>Of the cameras that were announced since the last <see cref="BeginFrame"/>.</summary>
        public NativeArray<StreamView> NextViews => m_nextViews.AsArray();

        /// <summary>How a cloud of the stream is coloured.</summary>
        public void SetLook(int cloud, CloudLook look)
        {
            while (m_looks.Count <= cloud)
                m_looks.Add(new CloudLook { Plane = -1 });
            m_looks[cloud] = look;
        }

        /// <summary>See <see cref="PointRenderer.SetPalette"/>.</summary>
        public void SetPalette(NativeArray<uint> colors)
        {
            m_palette.CopyFrom(colors);
            foreach (var seen in m_cameras)
                seen.Renderer.SetPalette(m_palette);
        }

        /// <summary>The views were taken: cameras are announced anew.</summary>
        public void BeginFrame()
        {
            m_nextViews.Clear();
            m_frame++;
            for (int i = m_cameras.Count - 1; i >= 0; i--)
            {
                if (m_cameras[i].Camera != null && m_frame - m_cameras[i].LastFrame < FramesToForget)
                    continue;
                m_cameras[i].Renderer.Dispose();
                m_cameras.RemoveAt(i);
            }
        }

        /// <summary>Whether clouds are drawn for a camera: not in previews of assets, nor in reflections.</summary>
        public static bool IsDrawn(Camera camera) =>
            camera.cameraType != CameraType.Preview && camera.cameraType != CameraType.Reflection;

        /// <summary>The next frame selects for this camera, too.</summary>
        public void Announce(Camera camera) => m_nextViews.Add(CameraViews.StreamViewOf(camera));

        /// <summary>Records the clouds as a camera sees them, into the target that is set.</summary>
        /// <param name="color">That target, and <paramref name="depth"/> its depth: see <see cref="RenderView.Color"/>.</param>
        /// <param name="intoTexture">See <see cref="CameraViews.RenderViewOf"/>.</param>
        public void Record(CommandBuffer commands, Camera camera, RenderTargetIdentifier color, RenderTargetIdentifier depth,
            bool intoTexture)
        {
            var renderer = RendererFor(camera);
            for (int cloud = 0; cloud < m_looks.Count; cloud++)
                renderer.List.SetLook(cloud, m_looks[cloud]);
            renderer.Prepare(Stream, CameraViews.StreamViewOf(camera), Style);
            var view = CameraViews.RenderViewOf(camera, intoTexture);
            view.Color = color;
            view.Depth = depth;
            view.Style = Style;
            renderer.Record(commands, view);
        }

        public void Dispose()
        {
            if (!m_nextViews.IsCreated)
                return;
            if (Current == this)
                Current = null;
            foreach (var seen in m_cameras)
                seen.Renderer.Dispose();
            m_cameras.Clear();
            m_materials.Dispose();
            m_sizes.Dispose();
            m_nextViews.Dispose();
            m_palette.Dispose();
        }

        PointRenderer RendererFor(Camera camera)
        {
            for (int i = 0; i < m_cameras.Count; i++)
            {
                if (!ReferenceEquals(m_cameras[i].Camera, camera))
                    continue;
                m_cameras[i].LastFrame = m_frame;
                return m_cameras[i].Renderer;
            }
            var renderer = new PointRenderer(m_materials, m_pool, m_sizes);
            renderer.SetPalette(m_palette);
            m_cameras.Add(new SeenCamera { Camera = camera, Renderer = renderer, LastFrame = m_frame });
            return renderer;
        }
    }
}
