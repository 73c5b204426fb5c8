using Unity.Mathematics;

namespace FastPoints.Queries
{
    /// <summary>The distance between two picked points.</summary>
    public readonly struct Measurement
    {
        public Measurement(StreamPick from, StreamPick to)
        {
            PickedPoint a = from.Point, b = to.Point;
            WorldLength = math.distance(a.PositionWorld, b.PositionWorld);
            HasOneCrs = from.Path == to.Path || from.Crs.IsSameAs(to.Crs);
            bool isSameGrid = a.Grid.Origin.Equals(b.Grid.Origin) && a.Grid.Step.Equals(b.Grid.Step);
            // Whole steps are subtracted exactly; large coordinates are not.
            var steps = b.Position - a.Position;
            DeltaGeo = !HasOneCrs ? new double3(double.NaN, double.NaN, double.NaN)
                : isSameGrid ? new double3(steps.X, steps.Y, steps.Z) * a.Grid.Step : b.PositionGeo - a.PositionGeo;
            Up = from.Up;
            Units = from.Units;
            bool hasMetres = HasOneCrs && Units.IsKnown;
            MetresPerUnit = !hasMetres ? new double3(double.NaN, double.NaN, double.NaN)
                : Units.MetresAt((a.PositionGeo + b.PositionGeo) * 0.5, Up);
        }

        /// <summary>Distance in Unity's units, as the clouds stood.</summary>
        public double WorldLength { get; }

        /// <summary>Whether both are in one coordinate system, so that differences of coordinates are meaningful.</summary>
        public bool HasOneCrs { get; }

        /// <summary>Vector from the first to the second in CRS units; NaN if it is meaningless.</summary>
        public double3 DeltaGeo { get; }

        /// <summary>Units of the first point's cloud.</summary>
        public CloudUnits Units { get; }

        /// <summary>Metres of a unit along each axis, of degrees half-way between the points; NaN if they are unknown.</summary>
        public double3 MetresPerUnit { get; }

        /// <summary>The axis that points up.</summary>
        public UpAxis Up { get; }

        /// <summary>Length in CRS units; meaningless if these differ, as degrees and metres do.</summary>
        public double LengthGeo => math.length(DeltaGeo);

        /// <summary>Distance on the map in CRS units, without the difference in height.</summary>
        public double HorizontalGeo => math.length(Horizontal(DeltaGeo));

        /// <summary>Length in metres; NaN if <see cref="MetresPerUnit"/> is.</summary>
        public double LengthMetres => math.length(DeltaGeo * MetresPerUnit);

        /// <summary>The same on the map.</summary>
        public double HorizontalMetres => math.length(Horizontal(DeltaGeo * MetresPerUnit));

        double3 Horizontal(double3 delta)
        {
            delta[Up.Index()] = 0;
            return delta;
        }
    }
}
