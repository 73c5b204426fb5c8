using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>A cloud's own space in Unity's axes: left-handed, Y up, in metres if the unit is known, from an origin near the
    /// cloud. East is Unity's X, north its Z, up its Y.</summary>
    public struct UnitySpace
    {
        /// <summary>The georeferenced position that lies at (0, 0, 0).</summary>
        public double3 OriginGeo;

        /// <summary>Unity's units for one CRS unit.</summary>
        public double Scale;

        /// <summary>The cloud's axis that is Unity's Y.</summary>
        public UpAxis Up;

        /// <summary>The middle of the bounds' floor becomes the origin, rounded to a whole unit. Units stay as they are if
        /// metres are unknown (0) or they are angles (NaN).</summary>
        public static UnitySpace Of(BoundsGeo boundsGeo, double metresPerUnit, UpAxis up = UpAxis.Z)
        {
            bool isKnown = metresPerUnit > 0 && metresPerUnit <= double.MaxValue;
            var floor = boundsGeo.Center;
            floor[up.Index()] = (up.IsNegative() ? boundsGeo.Max : boundsGeo.Min)[up.Index()];
            return new UnitySpace
            {
                OriginGeo = boundsGeo.IsEmpty ? new double3(0, 0, 0) : math.round(floor),
                Scale = isKnown ? metresPerUnit : 1,
                Up = up,
            };
        }

        /// <summary>The cloud's placement under a transform from this space to the world.</summary>
        public CloudPlacement Place(CloudGrid grid, GridCube root, double4x4 localToWorld)
        {
            Up.Directions(out var east, out var north, out var up);
            // The matrix has a column for each of the cloud's axes.
            var fromCloud = math.transpose(new double3x3(east, up, north));
            var toWorld = new double3x3(localToWorld.c0.xyz, localToWorld.c1.xyz, localToWorld.c2.xyz);
            var linear = math.mul(toWorld, fromCloud) * Scale;
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
