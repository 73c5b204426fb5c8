using System;
using FastPoints.Points;
using Unity.Collections;

namespace FastPoints.Preview
{
    /// <summary>Some points of a source, in file order: their positions and what they can be coloured by. Owns its
    /// memory.</summary>
    public sealed class PreviewSample : IDisposable
    {
        /// <summary>
        /// Memory of the largest sample. With the slots of a scan, a picture of 4 megapixels and the runtime it stays below 300
        /// MB resident, whatever the size of the file.
        /// </summary>
        public const long MaxBytes = 80L << 20;

        NativeList<SampleRun> m_runs;

        public PreviewSample(PointBatch points, PositionTransform transform)
        {
            Points = points;
            Transform = transform;
        }

        /// <summary>As the source stores them; all positions are finite.</summary>
        public PointBatch Points { get; }

        /// <summary>From stored to georeferenced positions.</summary>
        public PositionTransform Transform { get; }

        /// <summary>Of the sample's positions.</summary>
        public BoundsGeo Bounds { get; internal set; } = BoundsGeo.Empty;

        /// <summary>Points that were chosen and left out, for a position that is not finite.</summary>
        public long NonFinite { get; internal set; }

        /// <summary>Points that the source says it has.</summary>
        public long PointsInSource { get; internal set; }

        /// <summary>Bytes of the file that were read.</summary>
        public long BytesRead { get; internal set; }

        /// <summary>Whether each point was chosen from a scan of all points.</summary>
        public bool IsFullScan { get; internal set; }

        /// <summary>Points among them that were taken only for standing where none of the others is; the others stand for equal
        /// numbers of the source's points each.</summary>
        public int Substitutes { get; internal set; }

        /// <summary>Whether they are of the source's beginning alone, where the rest cannot be read without looking through all
        /// of it.</summary>
        public bool IsOfPrefix { get; internal set; }

        /// <summary>How the points were chosen, and what kept it from being otherwise: a line for people.</summary>
        public string Method { get; internal set; }

        /// <summary>Whether it is known what each point stands for: not so of an octree's upper levels, of a file's beginning
        /// alone, and of points that were chosen without regard to the file's order.</summary>
        public bool StandsForStretches { get; internal set; }

        /// <summary>Whether the points of its stretches are the first ones of blocks that were not read to their ends (LAZ): what
        /// the ends hold, and where, they do not tell.</summary>
        public bool IsOfBlockPrefixes { get; internal set; }

        /// <summary>The points that lie together in the file, in its order, substitutes apart; empty where each stands for a
        /// stretch of its own.</summary>
        internal NativeArray<SampleRun> Runs => RunList.AsArray();

        /// <summary>For who fills it.</summary>
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

        /// <summary>Tells how many points the source has, where that was an estimate or a part.</summary>
        internal void StandFor(long pointsInSource)
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

    /// <summary>Points of a sample that lie together in the file: all that is known of one stretch of it.</summary>
    internal struct SampleRun
    {
        /// <summary>Number of the stretch, in the file's order; several entries in a row may be of one.</summary>
        public int Stretch;

        /// <summary>Of the first point in the sample.</summary>
        public int First;

        public int Count;

        /// <summary>Points of the file that each stands for.</summary>
        public double Weight;
    }
}
