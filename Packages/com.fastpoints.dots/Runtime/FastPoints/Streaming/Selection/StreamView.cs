using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>One camera for the selection, in world space: its frustum, and how large things are on its screen. Planes face
    /// inwards and count from the eye, so that nothing is lost far from the world's origin.</summary>
    public unsafe struct StreamView
    {
        public const int MaxFrustumPlanes = 6;

        public double3 EyeWorld;
        public bool IsOrthographic;

        /// <summary>Pixels of one unit: at a distance of one unit (perspective), or anywhere (orthographic).</summary>
        public double ScalePx;

        /// <summary>With 0 planes, everything is in view.</summary>
        public int PlaneCount;

        /// <summary>A unit normal n and a distance w: inside is dot(n, position - eye) + w >= 0.</summary>
        public double4 Plane0;
        public double4 Plane1;
        public double4 Plane2;
        public double4 Plane3;
        public double4 Plane4;
        public double4 Plane5;

        internal ViewMask Mask;

        // A light's view: nodes that only it sees are selected for shadows, within a fraction of the point budget.
        internal bool IsLight;

        /// <summary>Without a position; its frustum contains everything. A length of one unit has this many pixels.</summary>
        public static StreamView Everything(double scalePx) => new StreamView { IsOrthographic = true, ScalePx = scalePx };

        /// <summary>Unit vectors, forward into the picture; the field of view is vertical.</summary>
        public static StreamView Perspective(double3 eyeWorld, double3 right, double3 up, double3 forward, double fovRadians,
            double2 sizePx)
        {
            double tanY = math.tan(fovRadians / 2), tanX = tanY * sizePx.x / sizePx.y;
            var view = new StreamView { EyeWorld = eyeWorld, ScalePx = sizePx.y * 0.5 / tanY };
            view.Add(right + forward * tanX, 0);
            view.Add(forward * tanX - right, 0);
            view.Add(up + forward * tanY, 0);
            view.Add(forward * tanY - up, 0);
            view.Add(forward, 0);
            return view;
        }

        /// <summary>Its frustum is endless along the axis, behind the eye too; the height is the picture's.</summary>
        public static StreamView Orthographic(double3 eyeWorld, double3 right, double3 up, double heightWorld, double2 sizePx)
        {
            double halfHeight = heightWorld / 2, halfWidth = halfHeight * sizePx.x / sizePx.y;
            var view = new StreamView { EyeWorld = eyeWorld, IsOrthographic = true, ScalePx = sizePx.y / heightWorld };
            view.Add(right, halfWidth);
            view.Add(-right, halfWidth);
            view.Add(up, halfHeight);
            view.Add(-up, halfHeight);
            return view;
        }

        /// <summary>Adds a plane that the view ends at, for example a clip plane of the camera; at most six in all.</summary>
        public void Add(double3 normal, double distance)
        {
            double length = math.length(normal);
            fixed (double4* planes = &Plane0)
                planes[PlaneCount++] = new double4(normal / length, distance / length);
        }
    }
}
