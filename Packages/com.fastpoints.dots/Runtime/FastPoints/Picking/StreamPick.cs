using FastPoints.Points;

namespace FastPoints.Picking
{
    /// <summary>What a ray has hit of the clouds of a stream.</summary>
    public sealed class StreamPick
    {
        /// <summary>Null where nothing was hit.</summary>
        public PickedPoint Point { get; internal set; }

        /// <summary>Number of the point's cloud in the stream, as it was when the search began.</summary>
        public int Cloud { get; internal set; }

        /// <summary>Of the point's cloud: a converted folder, finished or not, without the suffix of one in the making; or a
        /// file.</summary>
        public string Path { get; internal set; }

        /// <summary>Of the point's cloud: units, coordinate system.</summary>
        public CloudCrs Crs { get; internal set; }

        /// <summary>Metres of a horizontal unit, 0 where unknown, NaN where it is an angle: as the cloud says, unless somebody
        /// knows better.</summary>
        public double MetresPerUnit { get; set; }

        /// <summary>The axis of the cloud that points up: Z, unless somebody knows better.</summary>
        public UpAxis Up { get; set; } = UpAxis.Z;

        /// <summary>The point's cloud is a preview, or a build in progress: not all of its points could be hit.</summary>
        public bool IsPreview { get; internal set; }

        /// <summary>A search ended before it had looked at all: there may be a nearer point.</summary>
        public bool IsPartial { get; internal set; }

        /// <summary>What the first cloud that could not be searched said; null where all could.</summary>
        public string Failure { get; internal set; }
    }
}
