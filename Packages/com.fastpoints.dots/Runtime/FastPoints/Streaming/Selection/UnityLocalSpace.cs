using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>A cloud's own space in Unity's axes: left-handed, Y up, in metres if the unit is known, from an origin near the
    /// cloud. East is Unity's X, north its Z, up its Y.</summary>
    public struct UnityLocalSpace
    {
        /// <summary>The georeferenced position that lies at (0, 0, 0).</summary>
        public double3 OriginGeo;

        /// <summary>What a Unity unit, a metre, is in the cloud's coordinates.</summary>
        public CloudUnits Units;

        /// <summary>The cloud's axis that is Unity's Y.</summary>
        public UpAxis Up;

        /// <summary>The middle of the bounds' floor becomes the origin, rounded to a whole unit, or to a thousandth of a degree.
        /// Units stay as they are if metres are unknown.</summary>
        public static UnityLocalSpace Of(BoundsGeo boundsGeo, CloudUnits units, UpAxis up = UpAxis.Z)
        {
            var floor = boundsGeo.Center;
            floor[up.Index()] = (up.IsNegative() ? boundsGeo.Max : boundsGeo.Min)[up.Index()];
            var rounded = math.round(floor);
            if (units.IsInDegrees && CloudUnits.CouldBeDegrees(floor))
                rounded.xy = (math.round(floor * 1000) / 1000).xy;
            return new UnityLocalSpace
            {
                OriginGeo = boundsGeo.IsEmpty ? new double3(0, 0, 0) : rounded,
                Units = units,
                Up = up,
            };
        }

        /// <summary>Metres of a CRS unit along each axis; of degrees, at the origin.</summary>
        public readonly double3 Scale => Units.MetresAt(OriginGeo, Up);

        /// <summary>The cloud's placement under a transform from this space to the world.</summary>
        public CloudPlacement Place(CloudGrid grid, GridCube root, double4x4 localToWorld)
        {
            Up.Directions(out var east, out var north, out var up);
            // The matrix has a column for each of the cloud's axes.
            var fromCloud = math.transpose(new double3x3(east, up, north));
            var toWorld = new double3x3(localToWorld.c0.xyz, localToWorld.c1.xyz, localToWorld.c2.xyz);
            var scale = Scale;
            var linear = math.mul(toWorld, new double3x3(fromCloud.c0 * scale.x, fromCloud.c1 * scale.y, fromCloud.c2 * scale.z));
            var fromOrigin = grid.ToGeo(root.Corner) - OriginGeo;
            return new CloudPlacement(linear, localToWorld.c3.xyz + math.mul(linear, fromOrigin));
        }

        /// <summary>A position of the cloud in this space.</summary>
        public double3 FromGeo(double3 geo)
        {
            Up.Directions(out var east, out var north, out var up);
            var from = (geo - OriginGeo) * Scale;
            return new double3(math.dot(from, east), math.dot(from, up), math.dot(from, north));
        }

        /// <summary>The inverse: for example a picked position in coordinates of the CRS.</summary>
        public double3 ToGeo(double3 unity)
        {
            Up.Directions(out var east, out var north, out var up);
            return OriginGeo + (east * unity.x + up * unity.y + north * unity.z) / Scale;
        }
    }
}
