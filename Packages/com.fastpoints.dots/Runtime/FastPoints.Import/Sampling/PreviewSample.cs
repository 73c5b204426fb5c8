using System;

namespace FastPoints.Sampling
{
    /// <summary>Some points of a source in file order: positions and attributes for colouring. Owns its
    /// memory.</summary>
    public sealed class PreviewSample : IDisposable
    {
        /// <summary>Memory of the largest sample. With the slots of a scan, a picture of 4 megapixels and the runtime it stays
        /// below 300 MB resident, whatever the size of the file.</summary>
        public const long MaxBytes = 80L << 20;

        public PreviewSample(PointBatch points, PositionTransform transform)
        {
            Points = points;
            Transform = transform;
        }

        /// <summary>The points as the source stores them; all positions are finite.</summary>
        public PointBatch Points { get; }

        /// <summary>Transforms stored positions to georeferenced ones.</summary>
        public PositionTransform Transform { get; }

        /// <summary>Bounds of the sample's positions.</summary>
        public BoundsGeo Bounds { get; internal set; } = BoundsGeo.Empty;

        /// <summary>Chosen points that were left out because their position is not finite.</summary>
        public long NonFiniteCount { get; internal set; }

        /// <summary>Points that the source says it has.</summary>
        public long PointsInSource { get; internal set; }

        /// <summary>Bytes of the file that were read.</summary>
        public long BytesRead { get; internal set; }

        /// <summary>Whether each point was chosen from a scan of all points.</summary>
        public bool IsFullScan { get; internal set; }

        /// <summary>Number of points among them that were only taken because no other point is near; each of the others
        /// represents an equal number of the source's points.</summary>
        public int PlaceholderCount { get; internal set; }

        /// <summary>Whether they are all from the start of the source, because reading the rest takes a pass over all
        /// of it.</summary>
        public bool IsOfPrefix { get; internal set; }

        /// <summary>How the points were chosen, and why, in a line for people.</summary>
        public string Method { get; internal set; }

        public int Count => Points.Count;

        /// <summary>Share of the source's points that the sample has, 0 to 1.</summary>
        public double Fraction => PointsInSource == 0 ? 1 : Points.Count / (double)PointsInSource;

        public bool HasAllPoints => Points.Count + NonFiniteCount >= PointsInSource;

        /// <summary>The largest sample of this schema.</summary>
        public static int MaxPoints(PointSchema schema) => (int)(MaxBytes / (schema.BytesPerPoint + 1));

        public void Dispose() => Points.Dispose();

        /// <summary>A prefix of a sample that could be drawn before the rest was there.</summary>
        public struct Wave
        {
            /// <summary>The number of points in the prefix.</summary>
            public int Points;

            /// <summary>Time from the start of the sampling to the wave's last point.</summary>
            public double Seconds;

            /// <summary>Bytes of the file that were read up to here.</summary>
            public long BytesRead;
        }
    }
}
