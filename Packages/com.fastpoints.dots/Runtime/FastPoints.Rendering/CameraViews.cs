using System;
using FastPoints.Queries;
using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>The engine's cameras as streaming and drawing see them, off-centre and oblique ones included.</summary>
    public static class CameraViews
    {
        // The editor's scene culling mask of a camera; null in players.
        internal static Func<Camera, ulong> SceneMaskOf { get; set; }

        static ViewMask MaskOf(Camera camera) => new ViewMask
        {
            HiddenLayers = ~(uint)camera.cullingMask,
            Scenes = SceneMaskOf?.Invoke(camera) ?? 0,
            IsSceneView = camera.cameraType == CameraType.SceneView,
        };

        /// <summary>What a camera needs of the clouds.</summary>
        public static StreamView StreamViewOf(Camera camera) => StreamViewOf(camera, EyeMatrices.Of(camera), camera.pixelHeight);

        internal static StreamView StreamViewOf(Camera camera, in EyeMatrices eye, int heightPx)
        {
            var view = StreamViewOf(eye, heightPx);
            view.Mask = MaskOf(camera);
            return view;
        }

        /// <summary>What an eye needs of the clouds.</summary>
        public static StreamView StreamViewOf(in EyeMatrices eye, int heightPx)
        {
            var clip = eye.Projection * RotationOf(eye.View);
            var view = new StreamView
            {
                EyeWorld = eye.PositionWorld,
                IsOrthographic = IsOrthographic(eye.Projection),
                ScalePx = ScalePxOf(eye.Projection, heightPx),
            };
            // For a position p relative to the eye, clip = M p: inside means -w <= x, y, z <= w (Gribb and Hartmann, 2001).
            var w = Row(clip, 3);
            for (int axis = 0; axis < 3; axis++)
            {
                AddPlane(ref view, w + Row(clip, axis));
                AddPlane(ref view, w - Row(clip, axis));
            }
            return view;
        }

        /// <summary>How an eye's picture is drawn, apart from the style.</summary>
        public static RenderView RenderViewOf(in CameraTarget target, in EyeMatrices eye)
        {
            var rotation = RotationOf(eye.View);
            return new RenderView
            {
                ViewProjection = GL.GetGPUProjectionMatrix(eye.Projection, target.IsTexture) * rotation,
                WidthPx = target.WidthPx,
                HeightPx = target.HeightPx,
                // The engine's cameras look along their negative Z.
                Forward = -(Vector3)rotation.GetRow(2),
                ScalePx = ScalePxOf(eye.Projection, target.HeightPx),
                IsOrthographic = IsOrthographic(eye.Projection),
                IsLinear = QualitySettings.activeColorSpace == ColorSpace.Linear,
                Color = target.Color,
                Depth = target.Depth,
                IsSubViewport = target.IsSubViewport,
                MayBeScreen = target.MayBeScreen,
                Light = target.Light.RelativeTo(eye.PositionWorld),
            };
        }

        /// <summary>The ray through a position in a camera's picture, from <c>Camera.ScreenPointToRay</c> or the editor's
        /// <c>GUIPointToWorldRay</c>: from the near plane. The radius is in pixels of the picture.</summary>
        public static PointQuery PickQueryOf(Camera camera, Ray ray, double radiusPx)
        {
            var picked = UnmaskedQueryOf(camera, ray, radiusPx);
            picked.Mask = MaskOf(camera);
            return picked;
        }

        static PointQuery UnmaskedQueryOf(Camera camera, Ray ray, double radiusPx)
        {
            var projection = camera.projectionMatrix;
            var near = new double3(ray.origin.x, ray.origin.y, ray.origin.z);
            var direction = new double3(ray.direction.x, ray.direction.y, ray.direction.z);
            double scalePx = ScalePxOf(projection, camera.pixelHeight);
            if (IsOrthographic(projection))
                return PointQuery.Parallel(near, direction, scalePx, radiusPx);
            var eye = EyeMatrices.Of(camera).PositionWorld;
            var picked = PointQuery.FromEye(eye, direction, scalePx, radiusPx);
            picked.From = math.max(0, math.dot(near - eye, picked.DirectionWorld));
            return picked;
        }

        static float ScalePxOf(in Matrix4x4 projection, int heightPx) => heightPx * 0.5f * math.abs(projection.m11);

        static bool IsOrthographic(in Matrix4x4 projection) => projection.m33 == 1;

        // Leaves out a far plane at infinity, which has no direction.
        static void AddPlane(ref StreamView view, double4 plane)
        {
            if (math.length(plane.xyz) > 1e-6 * math.abs(plane.w) && math.length(plane.xyz) > 0)
                view.Add(plane.xyz, plane.w);
        }

        // Without the eye's position, which is subtracted in double elsewhere.
        static Matrix4x4 RotationOf(Matrix4x4 view)
        {
            view.m03 = 0;
            view.m13 = 0;
            view.m23 = 0;
            return view;
        }

        static double4 Row(in Matrix4x4 matrix, int row)
        {
            var values = matrix.GetRow(row);
            return new double4(values.x, values.y, values.z, values.w);
        }
    }
}
