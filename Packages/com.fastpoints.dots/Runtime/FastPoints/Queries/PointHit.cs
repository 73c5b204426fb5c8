using Unity.Mathematics;

namespace FastPoints.Queries
{
    /// <summary>A point that a query has found: see <see cref="PointCloudQueries"/>.</summary>
    public struct PointHit
    {
        /// <summary>Position in the world, as the cloud stood.</summary>
        public double3 PositionWorld;

        /// <summary>Position in CRS units.</summary>
        public double3 PositionGeo;

        /// <summary>Exact position in whole steps of the cloud's grid.</summary>
        public Grid3 Position;

        /// <summary>World units along the ray, or from the centre.</summary>
        public double Distance;

        /// <summary>Unit vector; 0 if it is unknown.</summary>
        public float3 NormalWorld;

        /// <summary>Spacing of the finest points that were searched here, in world units: others of the cloud may be nearer by as
        /// much. 0 if all of its points were.</summary>
        public double SpacingWorld;

        /// <summary>Number of the point's cloud in the stream.</summary>
        public int Cloud;

        // Where the copy in memory has it; no slot of what was stored.
        internal int Slot;
        internal int Version;
        internal int Block;
        internal int Index;
    }
}
