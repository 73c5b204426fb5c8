using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Estimates the distribution of a cloud's points from a sample: the cells of an adaptive grid, each with its
    /// standard error, and the empty cells, of which nothing is known.</summary>
    /// <remarks>The error is that of choosing segments. It is valid if these lie at random places in their parts of the file, as
    /// runs and text do. Prefixes of blocks (LAZ) are not random: if a block begins in one place and ends in another, no sample
    /// of prefixes shows it.</remarks>
    internal sealed class DensityEstimate : IDisposable
    {
        /// <summary>A cell with points of fewer segments is not divided: half of its parts would have two or three.</summary>
        const int MinSegments = 32;

        /// <summary>Cells need more segments if there are many, so that there are some thousands of cells.</summary>
        const int SegmentsPerMin = 1 << 14;

        const int PointsPerSlice = 1 << 16;

        readonly DensityTree m_tree;
        readonly double3 m_corner;
        readonly double m_edge;
        readonly int m_minSegments;

        DensityEstimate(DensityTree tree, int minSegments, double3 corner, double edge)
        {
            m_tree = tree;
            m_minSegments = minSegments;
            m_corner = corner;
            m_edge = edge;
        }

        /// <summary>The part within the grid's cube.</summary>
        public DensityCell Inside => m_tree[DensityNumbers.Root];

        /// <summary>The part farther out: outliers.</summary>
        public DensityCell Outside => m_tree[DensityNumbers.Outside];

        /// <summary>Coroutine: estimates from the current sample. Points that stand in for others are ignored.</summary>
        /// <param name="bounds">The bounds that the grid divides, which hold nearly all points.</param>
        /// <param name="take">Receives the estimate, which the caller disposes; null if the sample does not say what its points
        /// stand for.</param>
        public static IEnumerator<JobStep> Of(PreviewSample sample, BoundsGeo bounds, Action<DensityEstimate> take)
        {
            int count = sample.Count - sample.Placeholders;
            if (!sample.HasKnownWeights || count == 0 || bounds.IsEmpty)
            {
                take(null);
                yield break;
            }
            double edge = math.cmax(bounds.Size);
            edge = edge > 0 ? edge * (1 + 1e-9) : 1;
            var codes = new NativeArray<uint>(count, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            var coded = default(JobHandle);
            try
            {
                yield return JobStep.Of(Slices.Schedule(count, PointsPerSlice, (first, end, after) => new CodePositionsJob
                {
                    Sample = sample.Points.Bytes,
                    Positions = PositionColumns.Of(sample.Points),
                    Transform = sample.Transform,
                    First = first,
                    End = end,
                    Corner = bounds.Min,
                    CellsPerUnit = (1 << DensityNumbers.Levels) / edge,
                    CodeOfPoint = codes,
                }.Schedule(after), 1, default, all => coded = all));
                long points = Math.Max(sample.PointsInSource, sample.Count);
                double inSample = count + sample.NonFinite;
                int segments = sample.Runs.Length > 0 ? sample.Runs[sample.Runs.Length - 1].Segment + 1 : count;
                int min = Math.Max(MinSegments, segments / SegmentsPerMin);
                yield return JobStep.Of(DensityTree.Count(codes, sample.Runs, points / inSample, inSample / points, min, 0,
                    coded, tree => take(new DensityEstimate(tree, min, bounds.Min, edge))));
            }
            finally
            {
                coded.Complete();
                codes.Dispose();
            }
        }

        /// <summary>All cells that are not divided, in Morton order; they fill the cube.</summary>
        public IEnumerable<DensityLeaf> Leaves()
        {
            var open = new Stack<(int Cell, double3 Min, double Edge)>();
            open.Push((DensityNumbers.Root, m_corner, m_edge));
            while (open.Count > 0)
            {
                var (cell, min, edge) = open.Pop();
                int parts = m_tree.FirstPartOf(cell);
                if (parts < 0 || m_tree[cell].Segments < m_minSegments)
                {
                    yield return new DensityLeaf(min, edge, m_tree[cell]);
                    continue;
                }
                for (int octant = 7; octant >= 0; octant--)
                    open.Push((parts + octant, min + edge / 2 * new double3(octant & 1, octant >> 1 & 1, octant >> 2), edge / 2));
            }
        }

        public void Dispose() => m_tree.Dispose();
    }

    /// <summary>An undivided cell of a <see cref="DensityEstimate"/>.</summary>
    internal readonly struct DensityLeaf
    {
        /// <summary>Lowest corner, georeferenced, in CRS units.</summary>
        public readonly double3 Min;

        /// <summary>Length of an edge in CRS units.</summary>
        public readonly double Edge;

        public readonly DensityCell Cell;

        public DensityLeaf(double3 min, double edge, DensityCell cell)
        {
            Min = min;
            Edge = edge;
            Cell = cell;
        }
    }
}
