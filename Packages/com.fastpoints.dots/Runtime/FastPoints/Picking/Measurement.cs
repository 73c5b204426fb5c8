using Unity.Mathematics;

namespace FastPoints.Picking
{
    /// <summary>The distance between two picked points.</summary>
    public readonly struct Measurement
    {
        public Measurement(StreamPick from, StreamPick to)
        {
            PickedPoint a = from.Point, b = to.Point;
            WorldLength = math.distance(a.PositionWorld, b.PositionWorld);
            IsGeo = from.Path == to.Path || from.Crs.IsSameAs(to.Crs);
            bool isSameGrid = a.Grid.Origin.Equals(b.Grid.Origin) && a.Grid.Step.Equals(b.Grid.Step);
            // Whole steps are subtracted exactly; large coordinates are not.
            var steps = b.Position - a.Position;
            DeltaGeo = !IsGeo ? new double3(double.NaN, double.NaN, double.NaN)
                : isSameGrid ? new double3(steps.X, steps.Y, steps.Z) * a.Grid.Step : b.PositionGeo - a.PositionGeo;
            double metres = from.MetresPerUnit;
            MetresPerUnit = IsGeo && metres > 0 && metres <= double.MaxValue ? metres : double.NaN;
            Up = from.Up;
        }

        /// <summary>Distance in Unity's units, as the clouds stood.</summary>
        public double WorldLength { get; }

        /// <summary>Whether both are in one coordinate system, so that differences of coordinates are meaningful.</summary>
        public bool IsGeo { get; }

        /// <summary>Vector from the first to the second in CRS units; NaN if it is meaningless.</summary>
        public double3 DeltaGeo { get; }

        /// <summary>NaN if it is unknown, or if the units are angles.</summary>
        public double MetresPerUnit { get; }

        /// <summary>The axis that points up.</summary>
        public UpAxis Up { get; }

        /// <summary>Length in CRS units.</summary>
        public double LengthGeo => math.length(DeltaGeo);

        /// <summary>Distance on the map in CRS units, without the difference in height.</summary>
        public double HorizontalGeo
        {
            get
            {
                var across = DeltaGeo;
                across[Up.Index()] = 0;
                return math.length(across);
            }
        }

        /// <summary>Length in metres; NaN if <see cref="MetresPerUnit"/> is. Heights count in the horizontal unit.</summary>
        public double LengthMetres => LengthGeo * MetresPerUnit;
    }
}
