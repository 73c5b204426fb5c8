using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Picking
{
    /// <summary>What lies between two picked points.</summary>
    public readonly struct Measurement
    {
        public Measurement(StreamPick from, StreamPick to)
        {
            PickedPoint a = from.Point, b = to.Point;
            WorldLength = math.distance(a.PlaceWorld, b.PlaceWorld);
            IsGeo = from.Path == to.Path || from.Crs.IsSameAs(to.Crs);
            bool isSameGrid = a.Grid.Origin.Equals(b.Grid.Origin) && a.Grid.Step.Equals(b.Grid.Step);
            // Whole steps are subtracted exactly; large coordinates are not.
            var steps = b.Place - a.Place;
            DeltaGeo = !IsGeo ? new double3(double.NaN, double.NaN, double.NaN)
                : isSameGrid ? new double3(steps.X, steps.Y, steps.Z) * a.Grid.Step : b.PlaceGeo - a.PlaceGeo;
            double metres = from.MetresPerUnit;
            MetresPerUnit = IsGeo && metres > 0 && metres <= double.MaxValue ? metres : double.NaN;
            Up = from.Up;
        }

        /// <summary>In Unity's units, as the clouds stood.</summary>
        public double WorldLength { get; }

        /// <summary>Both are in one coordinate system, so that differences of coordinates mean something.</summary>
        public bool IsGeo { get; }

        /// <summary>From the first to the second, in CRS units; NaN where it means nothing.</summary>
        public double3 DeltaGeo { get; }

        /// <summary>NaN where nobody knows, or the units are angles.</summary>
        public double MetresPerUnit { get; }

        /// <summary>The axis that points up.</summary>
        public UpAxis Up { get; }

        /// <summary>In CRS units.</summary>
        public double LengthGeo => math.length(DeltaGeo);

        /// <summary>On the map, without the difference in height; in CRS units.</summary>
        public double HorizontalGeo
        {
            get
            {
                var across = DeltaGeo;
                across[(int)Up] = 0;
                return math.length(across);
            }
        }

        /// <summary>NaN where <see cref="MetresPerUnit"/> is. Heights count in the horizontal unit.</summary>
        public double LengthMetres => LengthGeo * MetresPerUnit;
    }
}
