using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>
    /// A cloud's own space in Unity's axes: left-handed, Y up, in metres where the unit is known, from an origin near the cloud, so
    /// that a scan with the coordinates of a map stands where its transform is. X is Unity's X, and of a cloud whose Z is up, Y
    /// is Unity's Z (north is forward) and Z its Y.
    /// </summary>
    public struct UnitySpace
    {
        /// <summary>The place that lies at (0, 0, 0).</summary>
        public double3 OriginGeo;

        /// <summary>Unity's units for one CRS unit.</summary>
        public double Scale;

        /// <param name="boundsGeo">Of the cloud; the middle of its floor becomes the origin, to a whole CRS unit.</param>
        /// <param name="metresPerUnit">0 where unknown, NaN where it is an angle: then units stay as they are.</param>
        public static UnitySpace Of(BoundsGeo boundsGeo, double metresPerUnit)
        {
            bool isKnown = metresPerUnit > 0 && metresPerUnit <= double.MaxValue;
            var floor = new double3(boundsGeo.Center.x, boundsGeo.Center.y, boundsGeo.Min.z);
            return new UnitySpace
            {
                OriginGeo = boundsGeo.IsEmpty ? new double3(0, 0, 0) : math.round(floor),
                Scale = isKnown ? metresPerUnit : 1,
            };
        }

        /// <summary>Where the cloud stands under a transform.</summary>
        /// <param name="localToWorld">From this space to the world.</param>
        public CloudPlacement Place(CloudGrid grid, GridCube root, double4x4 localToWorld)
        {
            var x = localToWorld.c0.xyz * Scale;
            var y = localToWorld.c2.xyz * Scale;
            var z = localToWorld.c1.xyz * Scale;
            var fromOrigin = grid.ToGeo(root.Corner) - OriginGeo;
            return new CloudPlacement(new double3x3(x, y, z),
                localToWorld.c3.xyz + x * fromOrigin.x + y * fromOrigin.y + z * fromOrigin.z);
        }

        /// <summary>A place of the cloud, in this space.</summary>
        public double3 FromGeo(double3 geo)
        {
            var from = (geo - OriginGeo) * Scale;
            return new double3(from.x, from.z, from.y);
        }

        /// <summary>The inverse: what a user picked, in coordinates of the CRS.</summary>
        public double3 ToGeo(double3 unity) => OriginGeo + new double3(unity.x, unity.z, unity.y) / Scale;
    }
}
