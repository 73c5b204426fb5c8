using FastPoints.Core;

namespace FastPoints.Picking
{
    /// <summary>What a ray has hit among the clouds of a stream.</summary>
    public sealed class StreamPick
    {
        /// <summary>Null if nothing was hit.</summary>
        public PickedPoint Point { get; internal set; }

        /// <summary>Number of the point's cloud in the stream, as it was when the search began.</summary>
        public int Cloud { get; internal set; }

        /// <summary>Path of the point's cloud: a converted folder, finished or not, without the suffix of one in the making; or a
        /// file.</summary>
        public string Path { get; internal set; }

        /// <summary>Units and coordinate system of the point's cloud.</summary>
        public CloudCrs Crs { get; internal set; }

        /// <summary>Metres of a horizontal unit, 0 if unknown, NaN if it is an angle: as the cloud says, unless it is
        /// overridden.</summary>
        public double MetresPerUnit { get; set; }

        /// <summary>The axis of the cloud that points up: Z, unless it is overridden.</summary>
        public UpAxis Up { get; set; } = UpAxis.Z;

        /// <summary>Whether the point's cloud is a preview or a build in progress, so that not all of its points could be
        /// hit.</summary>
        public bool IsPreview { get; internal set; }

        /// <summary>Whether a search ended before it had covered everything, so that there may be a nearer point.</summary>
        public bool IsPartial { get; internal set; }

        /// <summary>The message of the first cloud that could not be searched; null if all could.</summary>
        public string Failure { get; internal set; }
    }
}
