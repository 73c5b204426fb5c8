using System.Collections.Generic;
using System.Globalization;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>What a display needs to know of a cloud, found from all points of a sample.</summary>
    public sealed class DisplayRanges
    {
        const double OutlierShare = 0.005; // Of the values, this share at either end is taken for outliers.
        const double IntensityOutlierShare = 0.01;
        const double Widening = 0.1; // Outliers apart, the bounds are widened by this share of their size on either side.

        // Points farther from the middle half than this many times its longest edge are not framed, however many points that
        // are: scanners put what they did not hit at 0, and a hundredth of such points would make the rest one pixel.
        const double FarInInterquartileRanges = 50;
        const double FarBoundsFactor = 10; // Reports bounds that are this many times larger than the framed ones.

        // Within the degrees of the earth, this many times as high as wide: no object is; degrees with metres are, a
        // thousand times.
        const double MaxHeightPerDegree = 200;
        const double DarkestColor = 12; // Of 255: colours darker than this, except outliers, vanish against the background.

        const int MaxFramingPoints = 4096;
        const int MaxPointsForClasses = 100_000;
        const int FirstClassWithMeaning = 2; // 0 and 1 are points that nobody has classified.
        const int PointsPerSlice = 1 << 17; // Less than a millisecond of managed code.

        // The position first.
        readonly string[] m_columns =
        {
            AttributeNames.X, AttributeNames.Y, AttributeNames.Z, AttributeNames.Intensity, AttributeNames.Red,
            AttributeNames.Green, AttributeNames.Blue,
        };
        const int IntensityColumn = 3;

        bool m_hasFar;

        // Share of the points that are not outliers: less than 1 if only the largest of distant parts is framed.
        double m_shareFramed = 1;

        /// <summary>What the CRS says; where it is silent, degrees are guessed from the bounds.</summary>
        public CloudUnits Units;

        public bool IsInDegrees => Units.IsInDegrees;

        internal string ValueAttribute
        {
            get => m_columns[IntensityColumn];
            set => m_columns[IntensityColumn] = value;
        }

        /// <summary>The one that a mode looks its colours up by; null for the others.</summary>
        internal string AttributeOf(ColorMode mode) =>
            mode == ColorMode.Intensity ? ValueAttribute : ColorModes.AttributeOf(mode);

        /// <summary>What a CRS unit along each axis is taken for in a picture: horizontal units, or metres where X and Y are
        /// degrees.</summary>
        public double3 LengthsPerUnit = new double3(1, 1, 1);

        public UpAxis UpAxis = UpAxis.Z;

        /// <summary>Bounds of all finite positions.</summary>
        public BoundsGeo Full = BoundsGeo.Empty;

        /// <summary>Where nearly all points are: quantiles, widened, within <see cref="Full"/>.</summary>
        public BoundsGeo Robust = BoundsGeo.Empty;

        /// <summary>Some positions within <see cref="Robust"/>, at most 4,096: what a camera frames.</summary>
        public double3[] FramingSample = new double3[0];

        /// <summary>The farthest positions in many directions, except those far outside of Robust: what a camera is to
        /// show.</summary>
        public double3[] ExtremePoints = new double3[0];

        /// <summary>Points with a position that is not finite: in no range.</summary>
        public long NonFiniteCount;

        /// <summary>Heights along UpAxis in CRS units: of a negative axis, coordinates with the other sign.</summary>
        public double ElevationLow;
        public double ElevationHigh;

        /// <summary>Stored values; both 0 if there is no intensity.</summary>
        public double IntensityLow;
        public double IntensityHigh;
        public bool IntensityVaries;

        public bool HasIntensity;

        /// <summary>The existing ones of <see cref="ColorModes.Categories"/>.</summary>
        public readonly HashSet<ColorMode> Categories = new HashSet<ColorMode>();

        /// <summary>Classes of some of the points, where they have any; none of a manifest.</summary>
        public readonly SortedSet<int> Classes = new SortedSet<int>();

        /// <summary>There are several classes, and most points are of one that means something.</summary>
        public bool HasMeaningfulClasses;

        /// <summary>None where there is no colour or it is all black.</summary>
        public ColorDepth Color;

        /// <summary>What was assumed, and from what: a readable line each.</summary>
        public readonly List<string> Assumptions = new List<string>();

        // For a manifest; null if nothing was measured. The up axis is Z.
        internal StoredDisplayRanges? ToStored() => Robust.IsEmpty ? (StoredDisplayRanges?)null : new StoredDisplayRanges
        {
            BoundsGeo = Robust,
            Elevation = new CloudManifest.ValueRange { Min = ElevationLow, Max = ElevationHigh },
            Intensity = new CloudManifest.ValueRange { Min = IntensityLow, Max = IntensityHigh },
            HasColor = Color != ColorDepth.None,
            HasMeaningfulClasses = HasMeaningfulClasses,
        };

        /// <summary>What a manifest says: what is shown of the cloud, or else bounds and ranges with outliers.</summary>
        public static DisplayRanges Of(CloudManifest manifest)
        {
            var bounds = manifest.BoundsGeo;
            var ranges = new DisplayRanges
            {
                Units = manifest.Crs.Units,
                Full = bounds,
                Robust = bounds,
                ElevationLow = bounds.IsEmpty ? 0 : bounds.Min.z,
                ElevationHigh = bounds.IsEmpty ? 0 : bounds.Max.z,
            };
            ranges.FindCategories(manifest.Attributes);
            if (manifest.DisplayRanges is StoredDisplayRanges shown)
            {
                ranges.Robust = shown.BoundsGeo;
                ranges.ElevationLow = shown.Elevation.Min;
                ranges.ElevationHigh = shown.Elevation.Max;
                ranges.HasMeaningfulClasses = shown.HasMeaningfulClasses;
            }
            ranges.SetLengths();
            int intensity = manifest.Attributes.IndexOf(AttributeNames.Intensity);
            if (intensity >= 0)
            {
                ranges.HasIntensity = true;
                ranges.IntensityLow = manifest.Ranges[intensity].Min;
                ranges.IntensityHigh = manifest.Ranges[intensity].Max;
                ranges.IntensityVaries = ranges.IntensityHigh > ranges.IntensityLow;
                if (manifest.DisplayRanges is StoredDisplayRanges of && ranges.IntensityVaries)
                {
                    ranges.IntensityLow = of.Intensity.Min;
                    ranges.IntensityHigh = of.Intensity.Max;
                }
            }
            if (!manifest.Attributes.HasColor || manifest.DisplayRanges?.HasColor == false)
                return ranges;
            double brightest = 0;
            foreach (string name in new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue })
                brightest = math.max(brightest, manifest.Ranges[manifest.Attributes.IndexOf(name)].Max);
            var type = manifest.Attributes[manifest.Attributes.IndexOf(AttributeNames.Red)].Type;
            ranges.Color = brightest > 0 ? DepthOf(type, brightest) : ColorDepth.None;
            return ranges;
        }

        /// <summary>These, with elevation along another axis: its own are where nearly all points are.</summary>
        public DisplayRanges WithUp(UpAxis up)
        {
            if (up == UpAxis || Robust.IsEmpty)
                return this;
            var along = (DisplayRanges)MemberwiseClone();
            along.UpAxis = up;
            along.SetElevation(Robust.Min, Robust.Max);
            return along;
        }

        /// <summary>Coroutine: fills this from a batch. The batch must stay until the work is done.</summary>
        public IEnumerator<JobStep> Measure(PointBatch points, PositionTransform transform, UpAxis upAxis)
        {
            UpAxis = upAxis;
            var found = new NativeReference<ColumnQuantiles>[m_columns.Length];
            var bounds = new NativeReference<PositionBounds>(PositionBounds.Empty, Allocator.Persistent);
            try
            {
                for (int i = 0; i < found.Length; i++)
                    if (points.Schema.Has(m_columns[i]))
                        found[i] = new NativeReference<ColumnQuantiles>(ColumnQuantiles.Empty, Allocator.Persistent);
                int slices = (points.Count + PointsPerSlice - 1) / PointsPerSlice;
                yield return JobStep.Of(Slices.Run(0, slices + 1, 1, (slice, _, after) => slice < slices
                    ? MeasureSlice(points, transform, slice * PointsPerSlice, bounds, found, after)
                    : MeasureColumns(points, transform, found, after)));
                FindCategories(points.Schema);
                SetPositions(bounds.Value, found[0].Value, found[1].Value, found[2].Value);
                // Each of these takes a millisecond.
                yield return default;
                FramingSample = FramingSampleOf(points, transform);
                yield return default;
                Frame();
                yield return JobStep.Of(FindExtremePoints(points, transform));
                FindClasses(points);
                if (found[IntensityColumn].IsCreated)
                    SetIntensity(found[IntensityColumn].Value);
                if (points.Schema.HasColor)
                    SetColor(points.Schema[points.Schema.IndexOf(AttributeNames.Red)].Type, found[IntensityColumn + 1].Value,
                        found[IntensityColumn + 2].Value, found[IntensityColumn + 3].Value);
            }
            finally
            {
                bounds.Dispose();
                for (int i = 0; i < found.Length; i++)
                    if (found[i].IsCreated)
                        found[i].Dispose();
            }
        }

        JobHandle MeasureSlice(PointBatch points, PositionTransform transform, int first,
            NativeReference<PositionBounds> bounds, NativeReference<ColumnQuantiles>[] found, JobHandle inputDeps)
        {
            int count = math.min(PointsPerSlice, points.Count - first);
            var all = new MeasureBoundsJob
            {
                Bytes = points.Bytes,
                Columns = PositionColumns.Of(points),
                Transform = transform,
                First = first,
                Count = count,
                Found = bounds,
            }.Schedule(inputDeps);
            for (int i = 0; i < found.Length; i++)
                if (found[i].IsCreated)
                    all = JobHandle.CombineDependencies(all, new MeasureRangeJob
                    {
                        Bytes = points.Bytes,
                        Column = points.Column(points.Schema.IndexOf(m_columns[i])),
                        First = first,
                        Count = count,
                        Found = found[i],
                    }.Schedule(inputDeps));
            return all;
        }

        IEnumerator<JobStep> FindExtremePoints(PointBatch points, PositionTransform transform)
        {
            if (Robust.IsEmpty)
                yield break;
            using var farthest = new NativeArray<double4>(FindExtremePointsJob.Directions, Allocator.Persistent);
            yield return JobStep.Of(Slices.Run(0, points.Count, PointsPerSlice,
                (first, end, after) => new FindExtremePointsJob
                {
                    Bytes = points.Bytes,
                    Columns = PositionColumns.Of(points),
                    Transform = transform,
                    First = first,
                    Count = end - first,
                    Around = Robust,
                    Farthest = farthest,
                }.Schedule(after)));
            var extremes = new List<double3>();
            foreach (var position in farthest)
                if (position.w > 0)
                    extremes.Add(position.xyz);
            ExtremePoints = extremes.ToArray();
        }

        JobHandle MeasureColumns(PointBatch points, PositionTransform transform,
            NativeReference<ColumnQuantiles>[] found, JobHandle inputDeps)
        {
            var all = inputDeps;
            for (int i = 0; i < found.Length; i++)
            {
                if (!found[i].IsCreated)
                    continue;
                bool isPosition = i < IntensityColumn;
                double outliers = isPosition ? OutlierShare : IntensityOutlierShare;
                all = JobHandle.CombineDependencies(all, new MeasureColumnJob
                {
                    Bytes = points.Bytes,
                    Column = points.Column(points.Schema.IndexOf(m_columns[i])),
                    Count = points.Count,
                    Scale = isPosition ? transform.Scale[i] : 1,
                    Offset = isPosition ? transform.Offset[i] : 0,
                    LowQuantile = outliers,
                    HighQuantile = 1 - outliers,
                    Found = found[i],
                }.Schedule(inputDeps));
            }
            return all;
        }

        void Frame()
        {
            var part = LargestCluster.Of(FramingSample);
            m_shareFramed = part.Length / (double)math.max(1, FramingSample.Length);
            FramingSample = part;
            if ((m_hasFar || m_shareFramed < 1) && FramingSample.Length > 0)
                FrameSample();
            if (!Full.IsEmpty)
                ReportFarBounds();
            SetLengths();
        }

        /// <summary>The mode that a picture gets for <paramref name="wanted"/>, by the cloud's attributes.</summary>
        public ColorMode Resolve(ColorMode wanted)
        {
            switch (wanted)
            {
                case ColorMode.Rgb when Color != ColorDepth.None:
                case ColorMode.Intensity when HasIntensity:
                case ColorMode.Elevation:
                    return wanted;
                default:
                    return Categories.Contains(wanted) ? wanted
                        : Color != ColorDepth.None ? ColorMode.Rgb : HasMeaningfulClasses ? ColorMode.Classification
                            : ColorMode.Elevation;
            }
        }

        void FindCategories(PointSchema schema)
        {
            foreach (var mode in ColorModes.Categories)
                if (schema.Has(ColorModes.AttributeOf(mode)))
                    Categories.Add(mode);
        }

        void SetPositions(PositionBounds bounds, ColumnQuantiles x, ColumnQuantiles y, ColumnQuantiles z)
        {
            Full = bounds.Bounds;
            NonFiniteCount = bounds.NonFiniteCount;
            if (Full.IsEmpty)
            {
                Robust = BoundsGeo.Empty;
                ElevationLow = ElevationHigh = 0;
                Assumptions.Add("no point has a position: nothing is drawn");
                return;
            }
            var low = new double3(x.Low, y.Low, z.Low);
            var high = new double3(x.High, y.High, z.High);
            var lowQuarter = new double3(x.LowerQuartile, y.LowerQuartile, z.LowerQuartile);
            var highQuarter = new double3(x.UpperQuartile, y.UpperQuartile, z.UpperQuartile);
            double far = FarInInterquartileRanges * math.cmax(highQuarter - lowQuarter);
            m_hasFar = far > 0 && (math.any(low < lowQuarter - far) || math.any(high > highQuarter + far));
            if (m_hasFar)
            {
                low = math.max(low, lowQuarter - far);
                high = math.min(high, highQuarter + far);
            }
            Frame(low, high);
        }

        // Nearly all points lie between these.
        void Frame(double3 low, double3 high)
        {
            SetElevation(low, high);
            var widening = (high * 0.5 - low * 0.5) * (2 * Widening);
            Robust = new BoundsGeo(math.max(low - widening, Full.Min), math.min(high + widening, Full.Max));
        }

        void SetElevation(double3 low, double3 high)
        {
            ElevationLow = UpAxis.Height(UpAxis.IsNegative() ? high : low);
            ElevationHigh = UpAxis.Height(UpAxis.IsNegative() ? low : high);
        }

        void FrameSample()
        {
            var low = new double3();
            var high = new double3();
            var values = new double[FramingSample.Length];
            for (int axis = 0; axis < 3; axis++)
            {
                for (int i = 0; i < values.Length; i++)
                    values[i] = FramingSample[i][axis];
                System.Array.Sort(values);
                int outliers = (int)(values.Length * OutlierShare);
                low[axis] = values[outliers];
                high[axis] = values[values.Length - 1 - outliers];
            }
            Frame(low, high);
        }

        void ReportFarBounds()
        {
            if (math.cmax(Full.Size) <= FarBoundsFactor * math.cmax(Robust.Size) || math.cmax(Robust.Size) <= 0)
                return;
            string max = m_shareFramed < 1 ? (100 * m_shareFramed).ToString("F0", CultureInfo.InvariantCulture) + " %" : "most";
            Assumptions.Add("points lie as far as " + math.cmax(Full.Size).ToString("G3", CultureInfo.InvariantCulture)
                + " apart, " + max + " within " + math.cmax(Robust.Size).ToString("G3", CultureInfo.InvariantCulture)
                + ": these are framed");
        }

        // A degree of longitude is shorter by the cosine of the latitude; to whole degrees, so that any sample gives the same.
        void SetLengths()
        {
            LengthsPerUnit = new double3(1, 1, 1);
            if (Robust.IsEmpty)
                return;
            var lengths = Units.MetresAt(default, UpAxis);
            if (!IsInDegrees && Units.IsKnown)
                LengthsPerUnit = lengths / lengths[(UpAxis.Index() + 1) % 3];
            if (UpAxis != UpAxis.Z)
                return;
            double across = math.max(Robust.Size.x, Robust.Size.y);
            bool couldBeDegrees = CloudUnits.CouldBeDegrees(Robust.Min) && CloudUnits.CouldBeDegrees(Robust.Max);
            if (!couldBeDegrees || !IsInDegrees && !(across > 0 && Robust.Size.z > MaxHeightPerDegree * across))
                return;
            double latitude = math.min(89, math.abs(math.round(Robust.Center.y)));
            LengthsPerUnit = new CloudUnits(double.NaN, Units.Vertical).MetresAt(new double3(0, latitude, 0), UpAxis);
            Assumptions.Add("X and Y are taken for degrees, Z for " +
                (LengthsPerUnit.z == 1 ? "metres" : "units of " + NumberText.Of(LengthsPerUnit.z) + " m") +
                (IsInDegrees ? ": the CRS says so" : ", by their size"));
        }

        unsafe double3[] FramingSampleOf(PointBatch points, PositionTransform transform)
        {
            var sample = new List<double3>();
            var columns = PositionColumns.Of(points);
            byte* bytes = (byte*)points.Bytes.GetUnsafeReadOnlyPtr();
            int step = (points.Count + MaxFramingPoints - 1) / MaxFramingPoints;
            for (long i = 0; i < points.Count; i += step)
            {
                var position = columns.GeoAt(bytes, transform, (int)i);
                if (Robust.Contains(position))
                    sample.Add(position);
            }
            return sample.ToArray();
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

        unsafe void FindClasses(PointBatch points)
        {
            int at = points.Schema.IndexOf(AttributeNames.Classification);
            int step = (points.Count + MaxPointsForClasses - 1) / MaxPointsForClasses;
            if (at < 0)
                return;
            var column = points.Column(at);
            byte* bytes = (byte*)points.Bytes.GetUnsafeReadOnlyPtr();
            int looked = 0, meant = 0;
            for (long i = 0; i < points.Count; i += step, looked++)
            {
                int found = (int)ColumnValues.ToDouble(bytes + column.OffsetBytes, column.Type, (int)i);
                Classes.Add(found);
                meant += found >= FirstClassWithMeaning ? 1 : 0;
            }
            HasMeaningfulClasses = Classes.Count > 1 && 2 * meant > looked;
        }

        void SetColor(AttributeType type, ColumnQuantiles red, ColumnQuantiles green, ColumnQuantiles blue)
        {
            var range = red.Range;
            range.Include(green.Range);
            range.Include(blue.Range);
            if (range.IsEmpty || !(range.Max > 0))
            {
                Color = ColorDepth.None;
                if (!range.IsEmpty)
                    Assumptions.Add("colour is black throughout the sample: taken for none");
                return;
            }
            string max = NumberText.Of(range.Max);
            Color = DepthOf(type, range.Max);
            if (Color == ColorDepth.Unit)
                Assumptions.Add("colours are floats up to " + max + ": read as 0 to 1");
            else if (Color == ColorDepth.Bits8 && type != AttributeType.UInt8)
                Assumptions.Add("colours are " + type + " but no more than " + max + " in the sample: read as 8-bit");
            else if (Color == ColorDepth.Bits16 && type != AttributeType.UInt16)
                Assumptions.Add("colours are " + type + " up to " + max + ": read as 16-bit");
            double full = Color == ColorDepth.Unit ? 1 : Color == ColorDepth.Bits16 ? ushort.MaxValue : byte.MaxValue;
            double brightest = math.max(red.High, math.max(green.High, blue.High));
            if (brightest < full * DarkestColor / byte.MaxValue)
            {
                Color = ColorDepth.None;
                Assumptions.Add("colour is black or nearly so in 99 of 100 points: taken for none");
            }
        }

        // The maximum is that of all channels, more than 0.
        static ColorDepth DepthOf(AttributeType type, double max) => type == AttributeType.UInt8 ? ColorDepth.Bits8
            : type.IsFloat() && max <= 1 ? ColorDepth.Unit : max <= byte.MaxValue ? ColorDepth.Bits8 : ColorDepth.Bits16;
    }
}
