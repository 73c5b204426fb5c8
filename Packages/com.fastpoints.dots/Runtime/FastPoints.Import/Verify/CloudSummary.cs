using FastPoints.Points;

namespace FastPoints.Verify
{
    /// <summary>What a scan of all points found. Facts, where a header has claims.</summary>
    public sealed class CloudSummary
    {
        public long Points { get; internal set; }

        /// <summary>Of all finite positions, georeferenced; empty where there is none.</summary>
        public BoundsGeo Bounds { get; internal set; } = BoundsGeo.Empty;

        /// <summary>Points with a position that is not finite.</summary>
        public long NonFinite { get; internal set; }

        public PointSchema Schema { get; internal set; }

        /// <summary>One for each attribute of <see cref="Schema"/>.</summary>
        public ColumnSummary[] Columns { get; internal set; }
    }
}
