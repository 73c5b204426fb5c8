using System;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    /// <summary>A position and three axes in georeferenced space. There is no near or far plane:
    /// a perspective camera sees everything in front of it, an orthographic one everything along its axis.</summary>
    public struct Camera
    {
        public double3 EyeGeo;

        /// <summary>Unit vectors, forward into the picture; times lengths of a CRS unit where these differ by axis.</summary>
        public double3 Right;
        public double3 Up;
        public double3 Forward;

        public bool IsOrthographic;

        /// <summary>Vertical field of view of a perspective camera, in radians.</summary>
        public double FovRadians;

        /// <summary>Height in CRS units of what an orthographic camera sees.</summary>
        public double HeightGeo;

        /// <summary>The vertical field of view is more than 0 and less than 180 degrees; up is not the line of sight.</summary>
        public static Camera Perspective(double3 eyeGeo, double3 targetGeo, double3 up, double fovDegrees)
        {
            if (!(fovDegrees > 0 && fovDegrees < 180))
                throw new ArgumentOutOfRangeException(nameof(fovDegrees), fovDegrees, "wanted more than 0 and less than 180");
            var camera = Looking(eyeGeo, targetGeo - eyeGeo, up);
            camera.FovRadians = math.radians(fovDegrees);
            return camera;
        }

        /// <param name="heightGeo">Height in CRS units of what the picture shows; more than 0.</param>
        public static Camera Orthographic(double3 eyeGeo, double3 targetGeo, double3 up, double heightGeo)
        {
            if (!(heightGeo > 0))
                throw new ArgumentOutOfRangeException(nameof(heightGeo), heightGeo, "wanted more than 0");
            var camera = Looking(eyeGeo, targetGeo - eyeGeo, up);
            camera.IsOrthographic = true;
            camera.HeightGeo = heightGeo;
            return camera;
        }

        // A direction without length becomes +Y; an up vector along it the axis farthest from it.
        static Camera Looking(double3 eyeGeo, double3 direction, double3 up)
        {
            var forward = Unit(direction, new double3(0, 1, 0));
            up = Unit(up, new double3(0, 0, 1));
            if (math.abs(math.dot(forward, up)) > 1 - 1e-12)
            {
                var along = math.abs(forward);
                up = along.y <= along.x && along.y <= along.z ? new double3(0, 1, 0)
                    : along.z <= along.x ? new double3(0, 0, 1) : new double3(1, 0, 0);
            }
            var right = math.normalize(math.cross(forward, up));
            return new Camera { EyeGeo = eyeGeo, Right = right, Up = math.cross(right, forward), Forward = forward };
        }

        // Divides by the largest component first, so that lengths near the largest double do not overflow.
        static double3 Unit(double3 direction, double3 instead)
        {
            double largest = math.cmax(math.abs(direction));
            return largest > 0 && largest <= double.MaxValue ? math.normalize(direction / largest) : instead;
        }

        /// <summary>Right, up and forward coordinates relative to the eye, in CRS units.</summary>
        public double3 ToView(double3 geo)
        {
            var fromEye = geo - EyeGeo;
            return new double3(math.dot(fromEye, Right), math.dot(fromEye, Up), math.dot(fromEye, Forward));
        }

        /// <summary>The same camera for choosing nodes, where the world is the cloud's georeferenced space.</summary>
        public StreamView ToStreamView(int widthPx, int heightPx) => IsOrthographic
            ? StreamView.Orthographic(EyeGeo, Right, Up, HeightGeo, new double2(widthPx, heightPx))
            : StreamView.Perspective(EyeGeo, Right, Up, Forward, FovRadians, new double2(widthPx, heightPx));
    }
}
