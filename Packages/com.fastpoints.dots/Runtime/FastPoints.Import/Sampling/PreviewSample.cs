using System;
using FastPoints.Core;
using Unity.Collections;

namespace FastPoints.Sampling
{
    /// <summary>Some points of a source in file order: their positions and what they can be coloured by. Owns its
    /// memory.</summary>
    public sealed class PreviewSample : IDisposable
    {
        /// <summary>Memory of the largest sample. With the slots of a scan, a picture of 4 megapixels and the runtime it stays
        /// below 300 MB resident, whatever the size of the file.</summary>
        public const long MaxBytes = 80L << 20;

        NativeList<SampleRun> m_runs;

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
        public long NonFinite { get; internal set; }

        /// <summary>Points that the source says it has.</summary>
        public long PointsInSource { get; internal set; }

        /// <summary>Bytes of the file that were read.</summary>
        public long BytesRead { get; internal set; }

        /// <summary>Whether each point was chosen from a scan of all points.</summary>
        public bool IsFullScan { get; internal set; }

        /// <summary>Number of points among them that were only taken because no other point is near; each of the others stands
        /// for an equal number of the source's points.</summary>
        public int Placeholders { get; internal set; }

        /// <summary>Whether they come from the source's beginning alone, because reading the rest takes a pass over all of
        /// it.</summary>
        public bool IsOfPrefix { get; internal set; }

        /// <summary>How the points were chosen, and why not otherwise: a line for people.</summary>
        public string Method { get; internal set; }

        /// <summary>Whether it is known what each point stands for: not for an octree's upper levels, a file's prefix, or points
        /// that were chosen without regard to the file's order.</summary>
        public bool HasKnownWeights { get; internal set; }

        /// <summary>Whether the points of its segments are prefixes of blocks that were not read to their ends (LAZ): they say
        /// nothing about the ends.</summary>
        public bool IsOfBlockPrefixes { get; internal set; }

        /// <summary>The points that lie together in the file, in its order, without placeholders; empty if each stands for a
        /// segment of its own.</summary>
        internal NativeArray<SampleRun> Runs => RunList.AsArray();

        /// <summary>The list for code that fills it.</summary>
        internal NativeList<SampleRun> RunList
        {
            get
            {
                if (!m_runs.IsCreated)
                    m_runs = new NativeList<SampleRun>(Allocator.Persistent);
                return m_runs;
            }
        }

        public int Count => Points.Count;

        /// <summary>Share of the source's points that the sample has, 0 to 1.</summary>
        public double Share => PointsInSource == 0 ? 1 : Points.Count / (double)PointsInSource;

        public bool IsWhole => Points.Count + NonFinite >= PointsInSource;

        /// <summary>The largest sample of this schema.</summary>
        public static int MaxPoints(PointSchema schema) => (int)(MaxBytes / (schema.BytesPerPoint + 1));

        /// <summary>Sets how many points the source has, if that was an estimate or a part.</summary>
        internal void SetPointsInSource(long pointsInSource)
        {
            double scale = pointsInSource / (double)Math.Max(1, PointsInSource);
            for (int i = 0; i < Runs.Length; i++)
            {
                var run = m_runs[i];
                run.Weight *= scale;
                m_runs[i] = run;
            }
            PointsInSource = pointsInSource;
        }

        public void Dispose()
        {
            Points.Dispose();
            if (m_runs.IsCreated)
                m_runs.Dispose();
            m_runs = default;
        }
    }

    /// <summary>Points of a sample that lie together in the file: all that is known of one segment of it.</summary>
    internal struct SampleRun
    {
        /// <summary>Number of the segment in the file's order; consecutive entries may have the same one.</summary>
        public int Segment;

        /// <summary>Index of the first point in the sample.</summary>
        public int First;

        public int Count;

        /// <summary>Number of points of the file that each stands for.</summary>
        public double Weight;
    }
}
