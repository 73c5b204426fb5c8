using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    // All clouds of a world, for every camera that draws them: the link between streaming and a pipeline's pass. A pass
    // announces a camera before drawing it, so that the next frame selects for it, and then records the draws. Main thread.
    internal sealed class PointScene : IDisposable
    {
        const int FramesToForget = 120; // A camera that was not drawn for this many frames releases its buffers.

        // Frames select for a camera until it was not drawn for this many: it may be drawn at half the rate of others,
        // and its nodes would be loaded and evicted in turn.
        internal const int FramesToKeep = 30;
        const int MaxViews = 4; // Of a camera that a frame selects for.

        static readonly CloudLook s_noLook = new CloudLook { Plane = -1 };

        readonly GraphicsNodePool m_pool;
        readonly PointMaterials m_materials;
        readonly SizeTree m_sizes = new SizeTree();
        readonly List<CloudLook> m_looks = new List<CloudLook>();
        readonly List<SceneCamera> m_cameras = new List<SceneCamera>();
        readonly PointsPerFrameLimit m_pointsPerFrameLimit = new PointsPerFrameLimit();
        NativeList<StreamView> m_nextViews;
        int m_frame;
        int m_pointsPerFrame;

        sealed class SceneCamera
        {
            public Camera Camera;
            public PointRenderer Renderer;
            public PointRenderer RightEye; // Where eyes are drawn in turn and each keeps the points that it saw; null elsewhere.
            public int LastFrame;
            public int AnnouncedFrame;
            public double3? AnnouncedPosition; // Null if a script has set the matrices, independent of the transform.

            // How far the camera moved since it was announced, for example with a floating origin: the next picture is from
            // there.
            public double3 Moved => AnnouncedPosition.HasValue && Camera != null
                ? PositionOf(Camera) - AnnouncedPosition.Value : default;

            // What the next frame selects for: as the camera was drawn at each size and with each mask, for an editor draws it
            // once more into a small picture, and recorders do, in the last frame that it was drawn in.
            public readonly List<((int, int, ulong, uint) Drawn, StreamView View)> Views =
                new List<((int, int, ulong, uint), StreamView)>(MaxViews + 1);
        }

        // The stream's pool is in graphics memory; the scene does not dispose it.
        public PointScene(Shader points, Shader compose, StreamContext stream, ComputeShader raster = null,
            ComputeShader progressive = null)
        {
            Stream = stream;
            m_pool = (GraphicsNodePool)stream.Pool;
            m_materials = new PointMaterials(points, compose, raster, progressive);
            m_nextViews = new NativeList<StreamView>(Allocator.Persistent);
        }

        public static PointScene Current { get; set; } // The scene that passes draw; null for none.

        public StreamContext Stream { get; }
        public PointStyle Style { get; set; } = PointStyle.Default;

        // With as many points in a frame as meet its time; with all in edit mode, where no other frame may follow.
        PointStyle StyleOfFrame
        {
            get
            {
                var style = Style;
                style.PointsPerFrame = !Application.isPlaying ? 0
                    : style.IsProgressive && m_pointsPerFrame > 0 ? m_pointsPerFrame : style.PointsPerFrame;
                return style;
            }
        }

        // Views of the recently announced cameras: one for each size and mask of a camera; then of lights that shade.
        public NativeArray<StreamView> CollectNextViews()
        {
            m_nextViews.Clear();
            foreach (var seen in m_cameras)
            {
                var moved = seen.Moved;
                foreach (var seenAt in seen.Views)
                {
                    var view = seenAt.View;
                    view.EyeWorld += moved;
                    m_nextViews.Add(view);
                }
            }
            foreach (var seen in m_cameras)
            {
                if (seen.Views.Count == 0 || seen.Renderer.ShadowView == null)
                    continue;
                var light = seen.Renderer.ShadowView.Value;
                light.EyeWorld += seen.Moved;
                m_nextViews.Add(light);
            }
            return m_nextViews.AsArray();
        }

        // How often a pipeline's pass has recorded the clouds; 0 if no pass draws them.
        public long RecordedPictures { get; private set; }

        public bool IsLit
        {
            get
            {
                foreach (var look in m_looks)
                    if (PointLighting.LitLevelOf(look.Light) > 0)
                        return true;
                return false;
            }
        }

        public void SetLook(int cloud, CloudLook look)
        {
            while (m_looks.Count <= cloud)
                m_looks.Add(s_noLook);
            m_looks[cloud] = look;
        }

        public bool TryGetLook(int cloud, out CloudLook look)
        {
            look = cloud >= 0 && cloud < m_looks.Count ? m_looks[cloud] : s_noLook;
            return look.Plane >= 0;
        }

        public void ClearLooks()
        {
            for (int cloud = 0; cloud < m_looks.Count; cloud++)
                m_looks[cloud] = s_noLook;
        }

        // Call after CollectNextViews was read. Drops cameras that are no longer announced.
        public void BeginFrame()
        {
            m_frame++;
            long listed = 0;
            foreach (var seen in m_cameras)
                listed = math.max(listed, seen.Renderer.List.Points);
            m_pointsPerFrame = m_pointsPerFrameLimit.Next(Style, listed);
            for (int i = m_cameras.Count - 1; i >= 0; i--)
            {
                if (m_frame - m_cameras[i].AnnouncedFrame > FramesToKeep)
                    m_cameras[i].Views.Clear();
                if (m_cameras[i].Camera != null && m_frame - m_cameras[i].LastFrame < FramesToForget)
                    continue;
                m_cameras[i].Renderer.Dispose();
                m_cameras[i].RightEye?.Dispose();
                m_cameras.RemoveAt(i);
            }
        }

        // Previews of assets, which have a scene of their own, and reflections show none; other cameras do, and overlay cameras
        // where a PointCloudCamera asks for it.
        public static bool ShowsClouds(Camera camera, bool isOverlay = false)
        {
            if (camera.cameraType == CameraType.Preview && camera.overrideSceneCullingMask == 0 && camera.scene.IsValid() ||
                camera.cameraType == CameraType.Reflection)
                return false;
            return camera.TryGetComponent<PointCloudCamera>(out var choice) && choice.enabled ? choice.DrawsClouds : !isOverlay;
        }

        // The next frame selects for this camera, too, as it was last announced: for both eyes of a headset, even if they are
        // drawn one after the other. A camera may be drawn any number of times before that frame comes, if at all.
        // isForHeadset: Camera.stereoEnabled does not know what a pipeline's own settings say.
        public void AddView(Camera camera, bool isForHeadset = true)
        {
            isForHeadset &= camera.stereoEnabled;
            var seen = CameraOf(camera);
            var views = seen.Views;
            if (seen.AnnouncedFrame != m_frame)
                views.Clear();
            seen.AnnouncedFrame = m_frame;
            var view = isForHeadset ? EyeOf(camera, Camera.StereoscopicEye.Left)
                : CameraViews.StreamViewOf(camera, EyeMatrices.OfMono(camera), camera.pixelHeight);
            seen.AnnouncedPosition = isForHeadset || view.EyeWorld.Equals(PositionOf(camera)) ? PositionOf(camera)
                : (double3?)null;
            var drawn = (camera.pixelWidth, camera.pixelHeight, view.Mask.Scenes, view.Mask.HiddenLayers);
            // Keep the order: selection depends on it, and would change from frame to frame.
            int at = 0;
            while (at < views.Count && !views[at].Drawn.Equals(drawn))
                at++;
            while (at < views.Count && views[at].Drawn.Equals(drawn))
                views.RemoveAt(at);
            // A window may be dragged to any number of sizes before the next frame.
            for (; views.Count >= MaxViews; at = views.Count)
                views.RemoveAt(0);
            views.Insert(at, (drawn, view));
            if (isForHeadset)
                views.Insert(at + 1, (drawn, EyeOf(camera, Camera.StereoscopicEye.Right)));
        }

        // Call after AddView where a pass that draws nothing would still split the passes around it, which costs time on
        // tile-based GPUs. Whether the camera has clouds before it; the GPU runs the uploads with its picture in either case.
        public unsafe bool BeginPicture(Camera camera)
        {
            m_pool.BeginPicture();
            var views = CameraOf(camera).Views;
            for (int c = 0; c < Stream.Clouds.Count && Stream.Drawn.Length > 0; c++)
            {
                var cloud = Stream.Clouds[c];
                if (cloud == null || !cloud.Pages[0].IsLoaded || cloud.Pages[0].NodeCount == 0)
                    continue;
                var root = cloud.Pages[0].Nodes[0];
                for (int v = 0; v < views.Count; v++)
                {
                    var seen = new CloudView(views[v].View, cloud.Placement, cloud.Source.Cubes.Size);
                    if (seen.IsShown && seen.IntersectsFrustum(root.Center, root.Half))
                        return true;
                }
            }
            return false;
        }

        static double3 PositionOf(Camera camera)
        {
            var position = camera.transform.position;
            return new double3(position.x, position.y, position.z);
        }

        static StreamView EyeOf(Camera camera, Camera.StereoscopicEye eye) =>
            CameraViews.StreamViewOf(camera, EyeMatrices.Of(camera, eye), camera.pixelHeight);

        public void Record(CommandBuffer commands, Camera camera, in CameraTarget target) =>
            Record(commands, camera, target, true);

        void Record(CommandBuffer commands, Camera camera, in CameraTarget target, bool pipelineDoublesInstances)
        {
            var renderer = Prepare(camera, target, out var view);
            if (!target.HasBothEyes)
            {
                renderer.Record(commands, view);
                return;
            }
            var right = CameraViews.RenderViewOf(target, target.RightEye);
            right.Style = view.Style;
            var offset = target.RightEye.PositionWorld - target.Eye.PositionWorld;
            right.EyeOffset = new Vector3((float)offset.x, (float)offset.y, (float)offset.z);
            renderer.RecordBothEyes(commands, view, right, pipelineDoublesInstances);
        }

        // For pipelines that set the render target themselves: commands before that, and those that draw into it.
        public void Record(CommandBuffer before, CommandBuffer into, Camera camera, in CameraTarget target)
        {
            // The engine sets both slices of a headset's target, and what is drawn eye by eye wants one.
            if (target.HasBothEyes)
            {
                Record(into, camera, target, false);
                return;
            }
            var renderer = Prepare(camera, target, out var view);
            renderer.RecordBefore(before, view);
            renderer.RecordInto(into, view);
        }

        PointRenderer Prepare(Camera camera, in CameraTarget target, out RenderView view)
        {
            RecordedPictures++;
            var renderer = RendererOf(camera, target);
            for (int cloud = 0; cloud < m_looks.Count; cloud++)
                renderer.List.SetLook(cloud, m_looks[cloud]);
            var seen = CameraViews.StreamViewOf(camera, target.Eye, target.HeightPx);
            view = CameraViews.RenderViewOf(target, target.Eye);
            view.Style = StyleOfFrame;
            if (target.HasBothEyes)
                renderer.Prepare(Stream, seen, CameraViews.StreamViewOf(camera, target.RightEye, target.HeightPx), view.Style);
            else
                renderer.Prepare(Stream, seen, view.Style);
            return renderer;
        }

        public void Dispose()
        {
            if (!m_nextViews.IsCreated)
                return;
            if (Current == this)
                Current = null;
            foreach (var seen in m_cameras)
            {
                seen.Renderer.Dispose();
                seen.RightEye?.Dispose();
            }
            m_cameras.Clear();
            m_materials.Dispose();
            m_sizes.Dispose();
            m_nextViews.Dispose();
        }

        PointRenderer RendererOf(Camera camera, in CameraTarget target)
        {
            var seen = CameraOf(camera);
            bool isProgressive = StyleOfFrame.IsProgressive;
            if (!isProgressive)
            {
                seen.RightEye?.Dispose();
                seen.RightEye = null;
            }
            if (!isProgressive || target.HasBothEyes || !camera.stereoEnabled)
                return seen.Renderer;
            var left = EyeMatrices.Of(camera, Camera.StereoscopicEye.Left).PositionWorld;
            var right = EyeMatrices.Of(camera, Camera.StereoscopicEye.Right).PositionWorld;
            if (math.distancesq(target.Eye.PositionWorld, left) <= math.distancesq(target.Eye.PositionWorld, right))
                return seen.Renderer;
            return seen.RightEye ??= new PointRenderer(m_materials, m_pool, m_sizes);
        }

        SceneCamera CameraOf(Camera camera)
        {
            for (int i = 0; i < m_cameras.Count; i++)
            {
                if (!ReferenceEquals(m_cameras[i].Camera, camera))
                    continue;
                m_cameras[i].LastFrame = m_frame;
                return m_cameras[i];
            }
            var renderer = new PointRenderer(m_materials, m_pool, m_sizes);
            var seen = new SceneCamera { Camera = camera, Renderer = renderer, LastFrame = m_frame };
            m_cameras.Add(seen);
            return seen;
        }
    }
}
