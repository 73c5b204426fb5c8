using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>The engine's cameras as streaming and drawing see them: any projection, off-centre and oblique ones
    /// included.</summary>
    public static class CameraViews
    {
        /// <summary>What a camera needs of the clouds.</summary>
        public static StreamView StreamViewOf(Camera camera)
        {
            var projection = camera.projectionMatrix;
            var clip = projection * RotationOf(camera);
            var view = new StreamView
            {
                EyeWorld = EyeOf(camera),
                IsOrthographic = IsOrthographic(projection),
                ScalePx = ScalePxOf(camera, projection),
            };
            // Of a place p seen from the eye, clip = M p: inside is -w <= x, y, z <= w (Gribb and Hartmann, 2001).
            var w = Row(clip, 3);
            for (int axis = 0; axis < 3; axis++)
            {
                AddPlane(ref view, w + Row(clip, axis));
                AddPlane(ref view, w - Row(clip, axis));
            }
            return view;
        }

        /// <summary>How a camera's picture is drawn.</summary>
        /// <param name="intoTexture">Whether the target is a render texture, which some APIs have upside down.</param>
        public static RenderView RenderViewOf(Camera camera, bool intoTexture)
        {
            var projection = camera.projectionMatrix;
            var rotation = RotationOf(camera);
            return new RenderView
            {
                ViewProjection = GL.GetGPUProjectionMatrix(projection, intoTexture) * rotation,
                WidthPx = camera.pixelWidth,
                HeightPx = camera.pixelHeight,
                // The engine's cameras look along their negative Z.
                Forward = -(Vector3)rotation.GetRow(2),
                ScalePx = ScalePxOf(camera, projection),
                IsOrthographic = IsOrthographic(projection),
                IsLinear = QualitySettings.activeColorSpace == ColorSpace.Linear,
            };
        }

        static float ScalePxOf(Camera camera, in Matrix4x4 projection) => camera.pixelHeight * 0.5f * math.abs(projection.m11);

        static bool IsOrthographic(in Matrix4x4 projection) => projection.m33 == 1;

        /// <summary>A far plane at infinity has no direction: it is left out.</summary>
        static void AddPlane(ref StreamView view, double4 plane)
        {
            if (math.length(plane.xyz) > 1e-6 * math.abs(plane.w) && math.length(plane.xyz) > 0)
                view.Add(plane.xyz, plane.w);
        }

        static double3 EyeOf(Camera camera)
        {
            var position = camera.transform.position;
            return new double3(position.x, position.y, position.z);
        }

        /// <summary>The view without the camera's place, which is subtracted in double elsewhere.</summary>
        static Matrix4x4 RotationOf(Camera camera)
        {
            var rotation = camera.worldToCameraMatrix;
            rotation.m03 = 0;
            rotation.m13 = 0;
            rotation.m23 = 0;
            return rotation;
        }

        static double4 Row(in Matrix4x4 matrix, int row)
        {
            var values = matrix.GetRow(row);
            return new double4(values.x, values.y, values.z, values.w);
        }
    }
}
