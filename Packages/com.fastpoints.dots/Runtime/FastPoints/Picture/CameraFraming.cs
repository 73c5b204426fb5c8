using System;
using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    /// <summary>Makes cameras that show the whole of a cloud, as large as the picture allows.</summary>
    internal static class CameraFraming
    {
        /// <summary>Share of the picture's width and height that stays free on each side.</summary>
        const double Margin = 0.03;

        /// <summary>This share of the outline on each side may lie outside ...</summary>
        const double StrayShare = 0.005;

        /// <summary>... if the rest is then nearer than this share of the distance that shows everything.</summary>
        const double WorthTrimming = 0.9;

        /// <summary>Shifts towards the middle: each leaves half the error or less.</summary>
        const int Rounds = 10;

        public const double DefaultFovDegrees = 45;

        /// <summary>Makes a camera for a standard view. An empty box counts as a point at 0, a point as a box of one
        /// unit.</summary>
        /// <param name="outline">Positions in the box that the camera frames; if null or fewer than eight, it frames the box's
        /// corners.</param>
        public static Camera Frame(ViewDirection view, BoundsGeo bounds, double3[] outline, int widthPx, int heightPx,
            UpAxis upAxis, double fovDegrees = DefaultFovDegrees) =>
            Frame(view, bounds, outline, widthPx, heightPx, upAxis, fovDegrees, new double3(1, 1, 1));

        /// <param name="lengthsPerUnit">Length of a CRS unit along each axis: for a cloud in degrees, the horizontal and
        /// vertical ones differ.</param>
        public static Camera Frame(ViewDirection view, BoundsGeo bounds, double3[] outline, int widthPx, int heightPx,
            UpAxis upAxis, double fovDegrees, double3 lengthsPerUnit)
        {
            if (lengthsPerUnit.Equals(new double3(1, 1, 1)))
                return FrameLengths(view, bounds, outline, widthPx, heightPx, upAxis, fovDegrees);
            var stretched = new double3[outline?.Length ?? 0];
            for (int i = 0; i < stretched.Length; i++)
                stretched[i] = outline[i] * lengthsPerUnit;
            if (!bounds.IsEmpty)
                bounds = new BoundsGeo(bounds.Min * lengthsPerUnit, bounds.Max * lengthsPerUnit);
            var camera = FrameLengths(view, bounds, stretched, widthPx, heightPx, upAxis, fovDegrees);
            camera.EyeGeo /= lengthsPerUnit;
            camera.Right *= lengthsPerUnit;
            camera.Up *= lengthsPerUnit;
            camera.Forward *= lengthsPerUnit;
            return camera;
        }

        static Camera FrameLengths(ViewDirection view, BoundsGeo bounds, double3[] outline, int widthPx, int heightPx,
            UpAxis upAxis, double fovDegrees)
        {
            bool isPoint = bounds.IsEmpty || !(math.cmax(bounds.Size) > 0);
            bounds = Solid(bounds);
            if (outline == null || outline.Length < 8 || isPoint)
                outline = Corners(bounds);
            upAxis.Directions(out var east, out var north, out var up);
            double width = math.dot(bounds.Size, math.abs(east));
            double depth = math.dot(bounds.Size, math.abs(north));
            double height = math.dot(bounds.Size, math.abs(up));

            // A box much thinner from front to back than it is wide and high is a wall (or a single scan line).
            if (view == ViewDirection.Auto && depth < 0.02 * math.min(width, height))
                view = ViewDirection.Front;
            switch (view)
            {
                case ViewDirection.Top:
                    return FrameOrthographic(bounds, outline, -up, north, widthPx, heightPx);
                case ViewDirection.Front:
                    return FrameOrthographic(bounds, outline, north, up, widthPx, heightPx);
                case ViewDirection.Iso:
                    return FramePerspective(bounds, outline, north - 0.55 * east - 0.75 * up, up, widthPx, heightPx, fovDegrees);
                default:
                    var across = depth > 1.2 * width ? -east : north;
                    var aside = depth > 1.2 * width ? north : -east;
                    double skew = math.max(width, depth) > 3 * math.min(width, depth) ? 0.25 : 0.55;
                    return FramePerspective(bounds, outline, across + skew * aside - 0.75 * up, up, widthPx, heightPx,
                        fovDegrees);
            }
        }

        /// <summary>As large as possible with all of the outline in view, or, if its few farthest points cost much of the
        /// picture, all but those.</summary>
        static Camera FrameOrthographic(BoundsGeo bounds, double3[] outline, double3 forward, double3 up, int widthPx,
            int heightPx)
        {
            var all = FrameOrthographic(bounds, outline, 0, forward, up, widthPx, heightPx);
            var most = FrameOrthographic(bounds, outline, Strays(outline), forward, up, widthPx, heightPx);
            return most.HeightGeo < all.HeightGeo * WorthTrimming ? most : all;
        }

        static Camera FrameOrthographic(BoundsGeo bounds, double3[] outline, int strays, double3 forward, double3 up, int widthPx,
            int heightPx)
        {
            var center = bounds.Center;
            var camera = Camera.Orthographic(center, center + forward, up, 1);
            Extent(camera, outline, strays, false, out var min, out var max);
            var middle = (min + max) / 2;
            var size = max - min;
            camera.HeightGeo = math.max(size.y, size.x * heightPx / widthPx) / (1 - 2 * Margin);
            if (!(camera.HeightGeo > 0))
                camera.HeightGeo = math.cmax(bounds.Size);
            double back = math.dot(bounds.Size, math.abs(camera.Forward));
            camera.EyeGeo = center + camera.Right * middle.x + camera.Up * middle.y - camera.Forward * back;
            return camera;
        }

        /// <summary>As near as possible with all of the outline in view, or, if its few farthest points cost much of the picture,
        /// all but those.</summary>
        static Camera FramePerspective(BoundsGeo bounds, double3[] outline, double3 forward, double3 up, int widthPx,
            int heightPx,
            double fovDegrees)
        {
            double tanY = math.tan(math.radians(fovDegrees) / 2) * (1 - 2 * Margin);
            double tanX = tanY * widthPx / heightPx;
            var camera = Camera.Perspective(bounds.Center, bounds.Center + forward, up, fovDegrees);
            double farther = FramePerspective(ref camera, bounds, outline, 0, tanX, tanY);
            var trimmed = camera;
            double nearer = FramePerspective(ref trimmed, bounds, outline, Strays(outline), tanX, tanY);
            return nearer < farther * WorthTrimming ? trimmed : camera;
        }

        /// <summary>Moves a camera to the closest place on its line of sight from which the outline, except some strays, is in
        /// the picture, and shifts the line until the outline's extent is centred.</summary>
        /// <returns>The distance to the middle of the outline.</returns>
        static double FramePerspective(ref Camera camera, BoundsGeo bounds, double3[] outline, int strays, double tanX,
            double tanY)
        {
            var needed = new double[outline.Length];
            var target = bounds.Center;
            for (int round = 0; ; round++)
            {
                camera.EyeGeo = target;
                for (int i = 0; i < outline.Length; i++)
                {
                    var view = camera.ToView(outline[i]);
                    needed[i] = math.max(math.abs(view.x) / tanX, math.abs(view.y) / tanY) - view.z;
                }
                double distance = math.max(math.cmax(bounds.Size) * 1e-6, LargestBut(strays, needed, 1));
                camera.EyeGeo = target - camera.Forward * distance;
                if (round == Rounds)
                    return distance;
                Extent(camera, outline, strays, true, out var min, out var max);
                var shift = (min + max) / 2 * distance;
                target += camera.Right * shift.x + camera.Up * shift.y;
            }
        }

        /// <summary>Extent of the outline in the picture, without the given number of strays on each side: in units, or in
        /// tangents of the angle from the axis.</summary>
        static void Extent(in Camera camera, double3[] outline, int strays, bool divide, out double2 min, out double2 max)
        {
            var x = new double[outline.Length];
            var y = new double[outline.Length];
            for (int i = 0; i < outline.Length; i++)
            {
                var view = camera.ToView(outline[i]);
                double by = divide ? math.max(view.z, 1e-9 * math.length(view)) : 1;
                x[i] = view.x / by;
                y[i] = view.y / by;
            }
            min = new double2(-LargestBut(strays, x, -1), -LargestBut(strays, y, -1));
            max = new double2(LargestBut(strays, x, 1), LargestBut(strays, y, 1));
        }

        /// <summary>The largest value after leaving out the given number of larger ones. They are few, so not all values need
        /// sorting.</summary>
        /// <param name="sign">1, or -1 for the values' negatives.</param>
        static double LargestBut(int strays, double[] values, double sign)
        {
            // Holds the largest values so far, in rising order.
            var kept = new double[strays + 1];
            for (int i = 0; i < kept.Length; i++)
                kept[i] = double.NegativeInfinity;
            foreach (double unsigned in values)
            {
                double value = sign * unsigned;
                if (!(value > kept[0]))
                    continue;
                int at = 0;
                for (; at + 1 < kept.Length && kept[at + 1] < value; at++)
                    kept[at] = kept[at + 1];
                kept[at] = value;
            }
            return kept[0];
        }

        static int Strays(double3[] outline) => (int)(outline.Length * StrayShare);

        static double3[] Corners(BoundsGeo bounds)
        {
            var corners = new double3[8];
            for (int i = 0; i < corners.Length; i++)
                corners[i] = Corner(bounds, i);
            return corners;
        }

        static double3 Corner(BoundsGeo bounds, int corner) => new double3(
            (corner & 1) == 0 ? bounds.Min.x : bounds.Max.x,
            (corner & 2) == 0 ? bounds.Min.y : bounds.Max.y,
            (corner & 4) == 0 ? bounds.Min.z : bounds.Max.z);

        /// <summary>Makes the box at least a millionth as thick in every direction as it is long, and as long as doubles can
        /// resolve there.</summary>
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

    /// <summary>Standard views; x is east, y north and z up for a cloud whose up axis is Z.</summary>
    public enum ViewDirection
    {
        /// <summary>The view that shows most of the cloud: <see cref="Iso"/>, or <see cref="Front"/> for one that is a
        /// wall.</summary>
        Auto,
        /// <summary>Orthographic, from above, north at the top.</summary>
        Top,
        /// <summary>Orthographic, from the south.</summary>
        Front,
        /// <summary>Perspective, from the south-east and above.</summary>
        Iso,
    }
}
