using FastPoints.Points;

namespace FastPoints.Store
{
    /// <summary>Where nearly all points of a cloud and their values are, strays apart: what displays frame and colour by. From a
    /// sample of the octree's upper levels.</summary>
    public struct ShownRanges
    {
        /// <summary>Georeferenced.</summary>
        public BoundsGeo BoundsGeo;

        /// <summary>Along Z, in CRS units.</summary>
        public CloudManifest.Range Elevation;

        /// <summary>Stored values; both 0 where there is no intensity.</summary>
        public CloudManifest.Range Intensity;

        /// <summary>Whether there is colour, and more than strays have it.</summary>
        public bool HasColor;
    }
}
