using FastPoints.Picture;
using FastPoints.Points;
using FastPoints.Streaming;

namespace FastPoints.Feeds
{
    /// <summary>What a state of a cloud says of itself before it is streamed: enough to place and to colour it.</summary>
    public sealed class CloudFacts
    {
        public CloudStage Stage;

        /// <summary>Georeferenced, CRS units: what its source claims where that claims something.</summary>
        public BoundsGeo BoundsGeo;

        /// <summary>Metres of a horizontal unit; 0 where unknown, NaN where it is an angle.</summary>
        public double MetresPerUnit;

        public DisplayRanges Ranges;

        /// <summary>Whether the ranges are those of all values, strays included: of a manifest that knows no better, not of a
        /// sample.</summary>
        public bool RangesHaveStrays;
    }
}
