using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>Position and projection of one eye: a camera's, or one of a headset's two.</summary>
    public struct EyeMatrices
    {
        const double MaxRounding = 1e-5; // Relative to the camera's position: about a hundred times the rounding of floats.

        /// <summary>World to camera, which looks along its negative Z.</summary>
        public Matrix4x4 View;
        public Matrix4x4 Projection;
        public double3 PositionWorld;

        /// <summary>The eye that is being drawn: the camera, or one of a headset's drawn one after the other.</summary>
        public static EyeMatrices Of(Camera camera)
        {
            if (camera.stereoEnabled && camera.stereoActiveEye != Camera.MonoOrStereoscopicEye.Mono)
                return Of(camera, (Camera.StereoscopicEye)camera.stereoActiveEye);
            return OfMono(camera);
        }

        /// <summary>The camera's own, also of one that a headset does not show while it runs.</summary>
        internal static EyeMatrices OfMono(Camera camera)
        {
            var eye = Of(camera.worldToCameraMatrix, camera.projectionMatrix);
            var position = camera.transform.position;
            var exact = new double3(position.x, position.y, position.z);
            // The matrix is rounded, but if a script has set it, as mirrors do, only it counts.
            if (math.distance(eye.PositionWorld, exact) <= MaxRounding * (1 + math.length(exact)))
                eye.PositionWorld = exact;
            return eye;
        }

        internal static EyeMatrices Of(in Matrix4x4 view, in Matrix4x4 projection, Vector3 position) => new EyeMatrices
        {
            View = view,
            Projection = projection,
            PositionWorld = new double3(position.x, position.y, position.z),
        };

        public static EyeMatrices Of(Camera camera, Camera.StereoscopicEye eye) =>
            Of(camera.GetStereoViewMatrix(eye), camera.GetStereoProjectionMatrix(eye));

        public static EyeMatrices Of(in Matrix4x4 view, in Matrix4x4 projection) => new EyeMatrices
        {
            View = view,
            Projection = projection,
            PositionWorld = PositionOf(view),
        };

        // For a matrix that translates, rotates and at most mirrors.
        static double3 PositionOf(in Matrix4x4 view)
        {
            double3 x = Row(view, 0), y = Row(view, 1), z = Row(view, 2);
            return -(x * view.m03 + y * view.m13 + z * view.m23);
        }

        static double3 Row(in Matrix4x4 matrix, int row)
        {
            var values = matrix.GetRow(row);
            return new double3(values.x, values.y, values.z);
        }
    }
}
