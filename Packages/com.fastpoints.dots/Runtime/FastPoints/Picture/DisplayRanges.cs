using System.Collections.Generic;
using System.Globalization;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    /// <summary>What a display needs to know of a cloud, found from all points of a sample.</summary>
    public sealed class DisplayRanges
    {
        /// <summary>Of the values, this share at either end is taken for strays.</summary>
        const double StrayShare = 0.005;
        const double IntensityStrayShare = 0.01;

        /// <summary>Strays apart, the bounds are widened by this share of their size on either side.</summary>
        const double Widening = 0.1;

        const int MaxOutlinePoints = 4096;

        public UpAxis UpAxis = UpAxis.Z;

        /// <summary>Of all finite positions.</summary>
        public BoundsGeo Full = BoundsGeo.Empty;

        /// <summary>Where nearly all points are: quantiles, widened, within <see cref="Full"/>.</summary>
        public BoundsGeo Robust = BoundsGeo.Empty;

        /// <summary>Some positions within <see cref="Robust"/>, at most 4,096: what a camera frames.</summary>
        public double3[] Outline = new double3[0];

        /// <summary>Points with a position that is not finite: in no range.</summary>
        public long NonFinite;

        /// <summary>Along <see cref="UpAxis"/>, in CRS units.</summary>
        public double ElevationLow;
        public double ElevationHigh;

        /// <summary>Stored values; both 0 where there is no intensity.</summary>
        public double IntensityLow;
        public double IntensityHigh;
        public bool IntensityVaries;

        public bool HasIntensity;
        public bool HasClassification;

        /// <summary>None where there is no colour or it is all black.</summary>
        public ColorDepth Color;

        /// <summary>What was assumed, and from what: a line for people each.</summary>
        public readonly List<string> Assumptions = new List<string>();

        /// <summary>Work for a pump: fills this from a batch. The batch must stay until the work is done.</summary>
        public IEnumerator<JobHandle> Measure(PointBatch points, PositionTransform transform, UpAxis upAxis)
        {
            UpAxis = upAxis;
            string[] names =
            {
                AttributeNames.X, AttributeNames.Y, AttributeNames.Z, AttributeNames.Intensity, AttributeNames.Red,
                AttributeNames.Green, AttributeNames.Blue,
            };
            var found = new NativeReference<ColumnQuantiles>[names.Length];
            var bounds = new NativeReference<PositionBounds>(PositionBounds.Empty, Allocator.Persistent);
            JobHandle all = default;
            try
            {
                all = new MeasureBoundsJob
                {
                    Bytes = points.Bytes,
                    Columns = PositionColumns.Of(points),
                    Transform = transform,
                    Count = points.Count,
                    Found = bounds,
                }.Schedule();
                for (int i = 0; i < names.Length; i++)
                {
                    int column = points.Schema.IndexOf(names[i]);
                    if (column < 0)
                        continue;
                    found[i] = new NativeReference<ColumnQuantiles>(Allocator.Persistent);
                    double strays = i < 3 ? StrayShare : IntensityStrayShare;
                    all = JobHandle.CombineDependencies(all, new MeasureColumnJob
                    {
                        Bytes = points.Bytes,
                        Column = points.Column(column),
                        Count = points.Count,
                        Scale = i < 3 ? transform.Scale[i] : 1,
                        Offset = i < 3 ? transform.Offset[i] : 0,
                        LowShare = strays,
                        HighShare = 1 - strays,
                        Found = found[i],
                    }.Schedule());
                }
                yield return all;
                all.Complete();
                HasClassification = points.Schema.Has(AttributeNames.Classification);
                SetPositions(bounds.Value, found[0].Value, found[1].Value, found[2].Value);
                Outline = OutlineOf(points, transform);
                if (found[3].IsCreated)
                    SetIntensity(found[3].Value);
                if (points.Schema.HasColor)
                    SetColor(points.Schema[points.Schema.IndexOf(AttributeNames.Red)].Type, found[4].Value.Range,
                        found[5].Value.Range, found[6].Value.Range);
            }
            finally
            {
                all.Complete();
                bounds.Dispose();
                for (int i = 0; i < found.Length; i++)
                    if (found[i].IsCreated)
                        found[i].Dispose();
            }
        }

        /// <summary>The mode that a picture gets where <paramref name="wanted"/> is asked for, by what the cloud has.</summary>
        public ColorMode Resolve(ColorMode wanted)
        {
            switch (wanted)
            {
                case ColorMode.Rgb when Color != ColorDepth.None:
                case ColorMode.Intensity when HasIntensity:
                case ColorMode.Classification when HasClassification:
                    return wanted;
                case ColorMode.Elevation:
                    return wanted;
                default:
                    return Color != ColorDepth.None ? ColorMode.Rgb : IntensityVaries ? ColorMode.Intensity : ColorMode.Elevation;
            }
        }

        void SetPositions(PositionBounds bounds, ColumnQuantiles x, ColumnQuantiles y, ColumnQuantiles z)
        {
            Full = bounds.Bounds;
            NonFinite = bounds.NonFinite;
            if (Full.IsEmpty)
            {
                Robust = BoundsGeo.Empty;
                ElevationLow = ElevationHigh = 0;
                Assumptions.Add("no point has a position: nothing is drawn");
                return;
            }
            var low = new double3(x.Low, y.Low, z.Low);
            var high = new double3(x.High, y.High, z.High);
            int up = (int)UpAxis;
            ElevationLow = low[up];
            ElevationHigh = high[up];
            var widening = (high * 0.5 - low * 0.5) * (2 * Widening);
            Robust = new BoundsGeo(math.max(low - widening, Full.Min), math.min(high + widening, Full.Max));
        }

        unsafe double3[] OutlineOf(PointBatch points, PositionTransform transform)
        {
            var outline = new List<double3>();
            var columns = PositionColumns.Of(points);
            byte* bytes = (byte*)points.Bytes.GetUnsafeReadOnlyPtr();
            int step = (points.Count + MaxOutlinePoints - 1) / MaxOutlinePoints;
            for (long i = 0; i < points.Count; i += step)
            {
                double3 position;
                columns.LoadGeo(bytes, transform, (int)i, 1, &position.x, &position.y, &position.z);
                if (Robust.Contains(position))
                    outline.Add(position);
            }
            return outline.ToArray();
        }

        void SetIntensity(ColumnQuantiles found)
        {
            HasIntensity = !found.Range.IsEmpty;
            IntensityVaries = HasIntensity && found.Range.Max > found.Range.Min;
            if (!HasIntensity)
                return;
            IntensityLow = found.Low;
            IntensityHigh = found.High;
            if (IntensityVaries && !(IntensityHigh > IntensityLow))
            {
                IntensityLow = found.Range.Min;
                IntensityHigh = found.Range.Max;
            }
        }

        void SetColor(AttributeType type, ColumnRange red, ColumnRange green, ColumnRange blue)
        {
            var range = red;
            range.Include(green);
            range.Include(blue);
            if (range.IsEmpty || !(range.Max > 0))
            {
                Color = ColorDepth.None;
                if (!range.IsEmpty)
                    Assumptions.Add("colour is black throughout the sample: taken for none");
                return;
            }
            string max = range.Max.ToString("R", CultureInfo.InvariantCulture);
            if (type == AttributeType.UInt8)
            {
                Color = ColorDepth.Bits8;
            }
            else if (type.IsFloat() && range.Max <= 1)
            {
                Color = ColorDepth.Unit;
                Assumptions.Add("colours are floats up to " + max + ": read as 0 to 1");
            }
            else if (range.Max <= byte.MaxValue)
            {
                Color = ColorDepth.Bits8;
                Assumptions.Add("colours are " + type + " but no more than " + max + " in the sample: read as 8-bit");
            }
            else
            {
                Color = ColorDepth.Bits16;
                if (type != AttributeType.UInt16)
                    Assumptions.Add("colours are " + type + " up to " + max + ": read as 16-bit");
            }
        }
    }
}
