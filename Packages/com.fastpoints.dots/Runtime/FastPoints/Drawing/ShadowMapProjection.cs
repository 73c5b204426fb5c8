using System;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // Where the main light's depth map lies: a square across the light, around what a camera may see of the clouds. It rests in
    // the world: its texels' length is a power of two, and it moves by whole ones, so that they stay where they are whatever
    // the camera does.
    internal unsafe struct ShadowMapProjection
    {
        public const int EdgePx = 1024;
        const int StepPx = 64; // The map moves by so many texels at once, and has as many to spare.

        // Of a box's face, of which each plane of a view may cut a corner.
        const int MaxCorners = 4 + StreamView.MaxFrustumPlanes;

        readonly double3 m_right, m_up, m_lengths;
        double3 m_min, m_max; // To the right, up and along the light.

        /// <param name="lengths">Of the world's units along each axis, which differ where they are degrees.</param>
        public ShadowMapProjection(float3 toLight, double3 lengths)
        {
            this = default;
            m_lengths = lengths;
            UnitForward = -math.normalize(new double3(toLight.x, toLight.y, toLight.z));
            m_right = math.normalize(math.cross(UnitForward, AxisOf(math.abs(UnitForward.z) < 0.9 ? 2 : 1)));
            m_up = math.cross(m_right, UnitForward);
            (m_min, m_max) = (double.PositiveInfinity, double.NegativeInfinity);
        }

        // The way that the light goes.
        public double3 UnitForward { get; }
        public double3 Right => m_right * m_lengths;
        public double3 Up => m_up * m_lengths;
        public double3 ScaledForward => UnitForward * m_lengths;
        public double3 MiddleWorld { get; private set; }
        public double TexelWorld { get; private set; } // 0: nothing is in view.
        public double EdgeWorld => TexelWorld * EdgePx;

        public void Add(StreamContext stream, in StreamView view)
        {
            for (int c = 0; c < stream.Clouds.Count; c++)
            {
                var cloud = stream.Clouds[c];
                if (cloud != null && cloud.Placement.IsValid && view.Mask.Shows(cloud.Placement.Visibility) &&
                    cloud.Pages[0].IsLoaded && cloud.Pages[0].NodeCount > 0)
                    Add(view, cloud.Placement, cloud.Pages[0].Nodes[0].Center, cloud.Pages[0].Nodes[0].Half);
            }
        }

        // The part of a box that a view shows: the corners of its faces, cut by the view's planes, and the eye inside.
        public void Add(in StreamView view, in CloudPlacement placement, double3 center, double3 half)
        {
            var corners = stackalloc double3[MaxCorners];
            var cut = stackalloc double3[MaxCorners];
            var fromEye = placement.OriginWorld - view.EyeWorld;
            for (int face = 0; face < 6; face++)
            {
                int axis = face >> 1;
                double3 side = AxisOf(axis) * ((face & 1) * 2 - 1);
                double3 across = AxisOf((axis + 1) % 3), along = AxisOf((axis + 2) % 3);
                for (int i = 0; i < 4; i++)
                    corners[i] = math.mul(placement.Linear, center + half *
                        (side + across * (i == 1 || i == 2 ? 1 : -1) + along * (i > 1 ? 1 : -1))) + fromEye;
                int count = Cut(corners, cut, 4, view);
                for (int i = 0; i < count; i++)
                    Include(view.EyeWorld + corners[i]);
            }
            if (math.all(math.abs(math.mul(math.inverse(placement.Linear), -fromEye) - center) <= half))
                Include(view.EyeWorld);
        }

        public void Fit()
        {
            double longest = math.max(m_max.x - m_min.x, m_max.y - m_min.y);
            if (!(longest >= 0 && longest <= double.MaxValue))
                return;
            TexelWorld = Math.Pow(2, Math.Ceiling(Math.Log(Math.Max(longest, 1e-9) / (EdgePx - StepPx), 2)));
            double step = TexelWorld * StepPx;
            var middle = math.round((m_min + m_max) / (2 * step)) * step;
            MiddleWorld = (m_right * middle.x + m_up * middle.y + UnitForward * middle.z) / m_lengths;
        }

        public StreamView ViewFor(in StreamView camera)
        {
            var view = StreamView.Orthographic(MiddleWorld, Right, Up, EdgeWorld, new double2(EdgePx, EdgePx));
            (view.Mask, view.IsLight) = (camera.Mask, true);
            return view;
        }

        public MainLightShadow From(double3 eyeWorld)
        {
            var fromMiddle = (eyeWorld - MiddleWorld) * m_lengths;
            return new MainLightShadow
            {
                Column = (float3)(m_right / TexelWorld),
                Row = (float3)(-m_up / TexelWorld),
                Forward = (float3)UnitForward,
                Eye = (float3)new double3(math.dot(m_right, fromMiddle) / TexelWorld + EdgePx / 2,
                    EdgePx / 2 - math.dot(m_up, fromMiddle) / TexelWorld, math.dot(UnitForward, fromMiddle)),
                TexelWorld = (float)TexelWorld,
            };
        }

        void Include(double3 world)
        {
            var place = new double3(math.dot(world, Right), math.dot(world, Up), math.dot(world, ScaledForward));
            (m_min, m_max) = (math.min(m_min, place), math.max(m_max, place));
        }

        static double3 AxisOf(int axis) => new double3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);

        // Sutherland and Hodgman, 1974. The result is in corners.
        static int Cut(double3* corners, double3* cut, int count, in StreamView view)
        {
            for (int p = 0; p < view.PlaneCount; p++)
            {
                double4 plane;
                fixed (double4* planes = &view.Plane0)
                    plane = planes[p];
                int left = 0;
                for (int i = 0; i < count; i++)
                {
                    double3 from = corners[i], to = corners[(i + 1) % count];
                    double before = math.dot(plane.xyz, from) + plane.w, after = math.dot(plane.xyz, to) + plane.w;
                    if (before >= 0)
                        cut[left++] = from;
                    if (before >= 0 != after >= 0)
                        cut[left++] = from + (to - from) * (before / (before - after));
                }
                for (int i = 0; i < left; i++)
                    corners[i] = cut[i];
                count = left;
            }
            return count;
        }
    }

    // The map as an eye sees it: a place from the eye is in column dot(place, Column) + Eye.x, and so on; by its depth along the
    // light it is dot(place, Forward) + Eye.z from the map's own middle.
    internal struct MainLightShadow
    {
        public float3 Column;
        public float3 Row;
        public float3 Forward;
        public float3 Eye;
        public float TexelWorld;

        // How far before a place something has to lie to shade it: a texel, and what a surface rises within the texels around it
        // that are looked at, by the cosine of its angle to the light.
        public const float BiasTexels = 1, SlopeTexels = 2;

        // Of the texels around a place, which half shades it wholly: points leave some open.
        public const float WholeShare = 0.5f;
    }
}
