using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    internal static class CameraFraming
    {
        // Share of the picture's width and height that stays free on each side, if points are not larger.
        const double Margin = 0.03;
        const double MaxMargin = 0.25; // Points are never so large that the cloud gets less than half of the picture.
        const double OutlierShare = 0.005; // This share of the sample on each side may lie outside of a first picture ...
        const double MaxWidening = 3; // ... and what would enlarge it more than this many times stays outside.
        const int Iterations = 10, IterationsOfAll = 4; // Shifts towards the middle: each leaves half the error or less.

        // An empty box counts as a point at 0, a point as a box of one unit. With fewer than eight positions of a sample the
        // box's corners are framed. Extreme points, if any, are framed as well unless they are outliers. In degrees, lengths of
        // a unit differ by axis.
        public static Camera Frame(PictureOptions options, BoundsGeo bounds, double3[] sample, double3[] extremes,
            double3 lengthsPerUnit)
        {
            if (lengthsPerUnit.Equals(new double3(1, 1, 1)))
                return FrameLengths(options, bounds, sample, extremes);
            if (!bounds.IsEmpty)
                bounds = new BoundsGeo(bounds.Min * lengthsPerUnit, bounds.Max * lengthsPerUnit);
            var camera = FrameLengths(options, bounds, Stretched(sample, lengthsPerUnit), Stretched(extremes, lengthsPerUnit));
            camera.EyeGeo /= lengthsPerUnit;
            camera.Right *= lengthsPerUnit;
            camera.Up *= lengthsPerUnit;
            camera.Forward *= lengthsPerUnit;
            return camera;
        }

        static double3[] Stretched(double3[] positions, double3 lengthsPerUnit)
        {
            var stretched = new double3[positions?.Length ?? 0];
            for (int i = 0; i < stretched.Length; i++)
                stretched[i] = positions[i] * lengthsPerUnit;
            return stretched;
        }

        static Camera FrameLengths(PictureOptions options, BoundsGeo bounds, double3[] sample, double3[] extremes)
        {
            var solid = Thicken(bounds);
            bool isPoint = bounds.IsEmpty || math.cmax(solid.Size) > 2 * math.cmax(bounds.Size);
            bounds = solid;
            if (sample == null || sample.Length < 8 || isPoint)
                sample = Corners(bounds);
            options.UpAxis.Directions(out var east, out var north, out var up);
            double width = math.dot(bounds.Size, math.abs(east));
            double depth = math.dot(bounds.Size, math.abs(north));
            double height = math.dot(bounds.Size, math.abs(up));

            // A box much thinner from front to back than it is wide and high is a wall (or a single scan line).
            var view = options.View;
            if (view == ViewDirection.Auto && depth < 0.02 * math.min(width, height))
                view = ViewDirection.Front;
            bool isFlat = view != ViewDirection.Auto && view != ViewDirection.Iso;
            var across = view == ViewDirection.Auto && depth > 1.2 * width ? -east : north;
            var aside = view == ViewDirection.Auto && depth > 1.2 * width ? north : -east;
            bool isLong = view == ViewDirection.Auto && math.max(width, depth) > 3 * math.min(width, depth);
            var forward = view switch
            {
                ViewDirection.Top => -up,
                ViewDirection.Bottom => up,
                ViewDirection.Front => north,
                ViewDirection.Back => -north,
                ViewDirection.Left => east,
                ViewDirection.Right => -east,
                _ => across + (isLong ? 0.25 : 0.55) * aside - 0.75 * up,
            };
            up = view == ViewDirection.Top || view == ViewDirection.Bottom ? north : up;
            var camera = isFlat ? Camera.Orthographic(bounds.Center, bounds.Center + forward, up, 1)
                : Camera.Perspective(bounds.Center, bounds.Center + forward, up, options.FovDegrees);

            double pointPx = options.PointSizePx >= 1 ? options.PointSizePx : PointSizing.MaxPx;
            double focalLength = isFlat ? 2 : 1 / math.tan(math.radians(options.FovDegrees) / 2);
            var scale = focalLength * new double2(options.HeightPx / (double)options.WidthPx / ShareOf(options.WidthPx, pointPx),
                1 / ShareOf(options.HeightPx, pointPx));
            var target = bounds.Center;
            int outliers = (int)(sample.Length * OutlierShare);
            double minDistance = math.cmax(bounds.Size) * 1e-6;
            double max = Fit(ref camera, ref target, sample, outliers, scale, (minDistance, Iterations));
            var near = Near(camera, target, sample, extremes, scale, max * MaxWidening);
            Fit(ref camera, ref target, near, 0, scale, (minDistance, IterationsOfAll));
            if (isFlat)
                camera.EyeGeo = target - camera.Forward * math.dot(bounds.Size, math.abs(camera.Forward));
            return camera;
        }

        // What is left of an edge between the margins.
        static double ShareOf(int edgePx, double pointPx) =>
            1 - 2 * math.min(MaxMargin, math.max(Margin, (pointPx / 2 + 1) / edgePx));

        // The sampled and extreme points inside the frustum of a camera at this distance.
        static double3[] Near(Camera camera, double3 target, double3[] sample, double3[] extremes, double2 scale, double distance)
        {
            camera.EyeGeo = target;
            var near = new List<double3>(sample.Length);
            foreach (var part in new[] { sample, extremes ?? Array.Empty<double3>() })
                foreach (var position in part)
                    if (DistanceToShow(camera, position, scale) <= distance)
                        near.Add(position);
            return near.ToArray();
        }

        // How far a camera steps back to show a position; of an orthographic one, the height of its picture.
        static double DistanceToShow(in Camera camera, double3 position, double2 scale)
        {
            var view = camera.ToView(position);
            return math.max(math.abs(view.x) * scale.x, math.abs(view.y) * scale.y) - (camera.IsOrthographic ? 0 : view.z);
        }

        // Moves a camera to the closest position on its line of sight from which the positions, except some outliers, are in the
        // picture, and shifts the line until their extent is centred. Returns the distance, or the picture's height.
        static double Fit(ref Camera camera, ref double3 target, double3[] positions, int outliers, double2 scale,
            (double MinDistance, int Rounds) limits)
        {
            var needed = new double[positions.Length];
            for (int round = 0; ; round++)
            {
                camera.EyeGeo = target;
                for (int i = 0; i < positions.Length; i++)
                    needed[i] = DistanceToShow(camera, positions[i], scale);
                double distance = math.max(limits.MinDistance, LargestExcept(outliers, needed, 1));
                if (camera.IsOrthographic)
                    camera.HeightGeo = distance;
                else
                    camera.EyeGeo = target - camera.Forward * distance;
                if (round == limits.Rounds)
                    return distance;
                Extent(camera, positions, outliers, out var min, out var max);
                var shift = (min + max) / 2 * (camera.IsOrthographic ? 1 : distance);
                target += camera.Right * shift.x + camera.Up * shift.y;
            }
        }

        // Ignores this many outliers on each side. In units, or for a perspective camera in tangents of the angle from the axis.
        static void Extent(in Camera camera, double3[] sample, int outliers, out double2 min, out double2 max)
        {
            var x = new double[sample.Length];
            var y = new double[sample.Length];
            for (int i = 0; i < sample.Length; i++)
            {
                var view = camera.ToView(sample[i]);
                double by = camera.IsOrthographic ? 1 : math.max(view.z, 1e-9 * math.length(view));
                x[i] = view.x / by;
                y[i] = view.y / by;
            }
            min = new double2(-LargestExcept(outliers, x, -1), -LargestExcept(outliers, y, -1));
            max = new double2(LargestExcept(outliers, x, 1), LargestExcept(outliers, y, 1));
        }

        // The largest after skipping a few larger ones: not all need sorting. Sign is 1, or -1 for the smallest.
        static double LargestExcept(int outliers, double[] values, double sign)
        {
            // Holds the largest values so far, in rising order.
            var kept = new double[outliers + 1];
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

        // At least a millionth as thick in every direction as it is long; a single position becomes a cube of a unit, or of what
        // doubles can resolve there.
        static BoundsGeo Thicken(BoundsGeo bounds)
        {
            if (bounds.IsEmpty || !bounds.IsFinite)
                bounds = new BoundsGeo(new double3(0, 0, 0), new double3(0, 0, 0));
            var center = bounds.Center;
            double length = math.cmax(bounds.Max * 0.5 - bounds.Min * 0.5);
            double min = length > math.cmax(math.abs(center)) * 1e-12 ? length * 1e-6
                : Math.Max(0.5, math.cmax(math.abs(center)) * 1e-9);
            var half = math.max(bounds.Max * 0.5 - bounds.Min * 0.5, new double3(1, 1, 1) * min);
            return new BoundsGeo(center - half, center + half);
        }
    }
}
