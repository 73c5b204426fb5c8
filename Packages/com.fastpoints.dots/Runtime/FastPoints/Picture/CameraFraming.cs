using System;
using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    /// <summary>Cameras that show the whole of a box.</summary>
    public static class CameraFraming
    {
        /// <summary>Share of the picture's width and height that is left free on each side.</summary>
        const double Margin = 0.03;

        public const double DefaultFovDegrees = 45;

        /// <summary>A camera for a standard view; an empty box is taken for a point at 0, a point for a box of one
        /// unit.</summary>
        public static Camera Frame(ViewDirection view, BoundsGeo bounds, int widthPx, int heightPx, UpAxis upAxis,
            double fovDegrees = DefaultFovDegrees)
        {
            bounds = Solid(bounds);
            Axes(upAxis, out var east, out var north, out var up);
            if (view == ViewDirection.Auto)
                view = AutoView(bounds, east, north, up);
            switch (view)
            {
                case ViewDirection.Top:
                    return FrameOrthographic(bounds, -up, north, widthPx, heightPx);
                case ViewDirection.Front:
                    return FrameOrthographic(bounds, north, up, widthPx, heightPx);
                default:
                    return FramePerspective(bounds, north - 0.55 * east - 0.75 * up, up, widthPx, heightPx, fovDegrees);
            }
        }

        /// <summary>A box much thinner from front to back than it is wide and high is a wall (or a single scan line).</summary>
        static ViewDirection AutoView(BoundsGeo bounds, double3 east, double3 north, double3 up)
        {
            double width = math.dot(bounds.Size, math.abs(east));
            double depth = math.dot(bounds.Size, math.abs(north));
            double height = math.dot(bounds.Size, math.abs(up));
            return depth < 0.02 * math.min(width, height) ? ViewDirection.Front : ViewDirection.Iso;
        }

        static Camera FrameOrthographic(BoundsGeo bounds, double3 forward, double3 up, int widthPx, int heightPx)
        {
            var center = bounds.Center;
            var size = bounds.Size;
            var camera = Camera.Orthographic(center, center + forward, up, 1);
            double heightGeo = math.dot(size, math.abs(camera.Up));
            double widthGeo = math.dot(size, math.abs(camera.Right));
            camera.HeightGeo = math.max(heightGeo, widthGeo * heightPx / widthPx) / (1 - 2 * Margin);
            if (!(camera.HeightGeo > 0))
                camera.HeightGeo = math.cmax(size);
            camera.EyeGeo = center - camera.Forward * math.dot(size, math.abs(camera.Forward));
            return camera;
        }

        /// <summary>
        /// The closest place on a line of sight from which every corner is in the picture, with the line shifted (three times,
        /// which converges to a hundredth of the picture) until the corners' extent is centred.
        /// </summary>
        static Camera FramePerspective(BoundsGeo bounds, double3 forward, double3 up, int widthPx, int heightPx,
            double fovDegrees)
        {
            double tanY = math.tan(math.radians(fovDegrees) / 2) * (1 - 2 * Margin);
            double tanX = tanY * widthPx / heightPx;
            var target = bounds.Center;
            var camera = Camera.Perspective(target, target + forward, up, fovDegrees);
            for (int round = 0; round < 4; round++)
            {
                camera.EyeGeo = target;
                double distance = 0;
                for (int corner = 0; corner < 8; corner++)
                {
                    var view = camera.ToView(Corner(bounds, corner));
                    distance = math.max(distance, math.max(math.abs(view.x) / tanX, math.abs(view.y) / tanY) - view.z);
                }
                camera.EyeGeo = target - camera.Forward * distance;
                if (round == 3)
                    break;

                var min = new double2(double.PositiveInfinity, double.PositiveInfinity);
                var max = -min;
                for (int corner = 0; corner < 8; corner++)
                {
                    var view = camera.ToView(Corner(bounds, corner));
                    min = math.min(min, view.xy / math.max(view.z, 1e-9 * distance));
                    max = math.max(max, view.xy / math.max(view.z, 1e-9 * distance));
                }
                var shift = (min + max) / 2 * distance;
                target += camera.Right * shift.x + camera.Up * shift.y;
            }
            return camera;
        }

        static double3 Corner(BoundsGeo bounds, int corner) => new double3(
            (corner & 1) == 0 ? bounds.Min.x : bounds.Max.x,
            (corner & 2) == 0 ? bounds.Min.y : bounds.Max.y,
            (corner & 4) == 0 ? bounds.Min.z : bounds.Max.z);

        static void Axes(UpAxis upAxis, out double3 east, out double3 north, out double3 up)
        {
            var x = new double3(1, 0, 0);
            var y = new double3(0, 1, 0);
            var z = new double3(0, 0, 1);
            switch (upAxis)
            {
                case UpAxis.X:
                    east = y;
                    north = z;
                    up = x;
                    break;
                case UpAxis.Y:
                    east = x;
                    north = -z;
                    up = y;
                    break;
                default:
                    east = x;
                    north = y;
                    up = z;
                    break;
            }
        }

        /// <summary>At least a millionth as thick in every direction as it is long, and as long as doubles can resolve
        /// there.</summary>
        static BoundsGeo Solid(BoundsGeo bounds)
        {
            if (bounds.IsEmpty || !bounds.IsFinite)
                bounds = new BoundsGeo(new double3(0, 0, 0), new double3(0, 0, 0));
            var center = bounds.Center;
            double length = math.cmax(bounds.Max * 0.5 - bounds.Min * 0.5);
            if (!(length > math.cmax(math.abs(center)) * 1e-12))
                length = Math.Max(0.5, math.cmax(math.abs(center)) * 1e-9);
            var half = math.max(bounds.Max * 0.5 - bounds.Min * 0.5, new double3(1, 1, 1) * (length * 1e-6));
            return new BoundsGeo(center - half, center + half);
        }
    }
}
