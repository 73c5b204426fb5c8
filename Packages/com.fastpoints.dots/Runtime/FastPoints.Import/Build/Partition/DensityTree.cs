using System;
using System.Collections.Generic;
using FastPoints.Sampling;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;
using static FastPoints.Build.DensityNumbers;

namespace FastPoints.Build
{
    /// <summary>Estimated points in the cells of an adaptive grid: a cube whose cells are divided in eight where they have many.
    /// It knows only the cells' Morton codes, no coordinates.</summary>
    /// <remarks>Levels come in pairs: a brick has the 8 cells of one level and the 64 of the next; divided ones have a brick of
    /// their own. The result is the same for any number of threads.</remarks>
    internal sealed class DensityTree : IDisposable
    {
        const int PointsPerSlice = 1 << 15; // Points of one slice: about 2 ms of managed code.

        NativeList<DensitySum> m_sums;
        NativeList<int> m_childBricks;
        int m_ranges;
        double m_share;

        DensityTree()
        {
            m_sums = new NativeList<DensitySum>(FirstBrick + CellsOfBrick, Allocator.Persistent);
            m_childBricks = new NativeList<int>(FineCells, Allocator.Persistent);
            for (int i = 0; i < FirstBrick; i++)
                m_sums.Add(default);
            AddBrick(ref m_childBricks, ref m_sums);
        }

        public DensityCell this[int cell] => m_sums[cell].ToCell(m_ranges, m_share);

        /// <summary>The number of the first of a cell's eight subcells, in Morton order; -1 if it is not divided.</summary>
        public int FirstChildOf(int cell)
        {
            if (cell == Root)
                return CoarseCell(0, 0);
            if (cell == Outside)
                return -1;
            int brick = (cell - FirstBrick) / CellsOfBrick, inBrick = (cell - FirstBrick) % CellsOfBrick;
            if (inBrick < CoarseCells)
                return FineCell(brick, inBrick * 8);
            int child = m_childBricks[brick * FineCells + inBrick - CoarseCells];
            return child < 0 ? -1 : CoarseCell(child, 0);
        }

        /// <summary>Coroutine: counts a sample.</summary>
        /// <param name="codes">The Morton code of each point's cell at the last level, or <see cref="OutsideCode"/>.</param>
        /// <param name="ranges">In the file's order.</param>
        /// <param name="share">The sampled share of the file's points, 0 to 1.</param>
        /// <param name="maxPoints">Cells with no more points are not divided.</param>
        /// <param name="coded">Completes when the codes are there.</param>
        /// <param name="take">Receives the tree at the end; the caller disposes it.</param>
        public static IEnumerator<JobStep> Count(NativeArray<uint> codes, NativeArray<SampleRange> ranges, double share,
            double maxPoints, JobHandle coded, Action<DensityTree> take)
        {
            var tree = new DensityTree { m_share = share, m_ranges = ranges.Length };
            using var bricks = new NativeArray<int>(Math.Max(1, codes.Length), Allocator.Persistent);
            using var touched = new NativeList<int>(Allocator.Persistent);
            using var bricksOfDepth = new NativeReference<int2>(new int2(0, 1), Allocator.Persistent);
            try
            {
                var begins = new List<int> { 0 };
                for (int range = 0, points = 0; range < ranges.Length; range++)
                {
                    points += ranges[range].Count;
                    if (points < PointsPerSlice && range + 1 < ranges.Length)
                        continue;
                    begins.Add(range + 1);
                    points = 0;
                }
                // Each depth counts in all slices but one, which divides.
                int slices = begins.Count;
                yield return JobStep.Of(Slices.Run(0, Levels / 2 * slices - 1, 1, (n, _, after) => n % slices == slices - 1
                    ? new DivideDensityJob
                    {
                        Bricks = bricksOfDepth,
                        MaxPoints = maxPoints,
                        ChildBricks = tree.m_childBricks,
                        Sums = tree.m_sums,
                    }.Schedule(after)
                    : new CountDensityJob
                    {
                        CodeOfPoint = codes,
                        BrickOfPoint = bricks,
                        Ranges = ranges,
                        First = begins[n % slices],
                        End = begins[n % slices + 1],
                        Depth = n / slices,
                        Bricks = bricksOfDepth,
                        ChildBricks = tree.m_childBricks,
                        Sums = tree.m_sums,
                        Touched = touched,
                    }.Schedule(after), 1, coded));
                take(tree);
                tree = null;
            }
            finally
            {
                tree?.Dispose();
            }
        }

        public void Dispose()
        {
            if (!m_sums.IsCreated)
                return;
            m_sums.Dispose();
            m_childBricks.Dispose();
        }

        internal static void AddBrick(ref NativeList<int> childBricks, ref NativeList<DensitySum> sums)
        {
            for (int i = 0; i < FineCells; i++)
                childBricks.Add(-1);
            for (int i = 0; i < CellsOfBrick; i++)
                sums.Add(default);
        }
    }

    static class DensityNumbers
    {
        /// <summary>Numbers of the first cells: the whole cube and the space outside it; then come the bricks.</summary>
        public const int Root = 0, Outside = 1;

        public const uint OutsideCode = uint.MaxValue;

        /// <summary>The most levels of cells: a code has three bits for each. In the cube of a continent the smallest are 4 km
        /// wide.</summary>
        public const int Levels = 10;

        public const int FineCells = 64;
        public const int CoarseCells = 8, CellsOfBrick = CoarseCells + FineCells, FirstBrick = 2;

        public static int CoarseCell(int brick, int coarse) => FirstBrick + brick * CellsOfBrick + coarse;

        public static int FineCell(int brick, int fine) => FirstBrick + brick * CellsOfBrick + CoarseCells + fine;

        /// <summary>A point's fine cell within its brick at a depth.</summary>
        public static int FineOf(uint code, int depth) => (int)(code >> 3 * (Levels - 2 * (depth + 1)) & FineCells - 1);
    }

    /// <summary>Sums over the ranges of a sample, one after the other in the file's order, for one cell. Blittable.</summary>
    internal struct DensitySum
    {
        public double Points;
        public double SquaresOfDifferences;

        public double InRange;
        public double InLast; // Points of LastRange, the last one that has points here.
        public int LastRange;
        public int Ranges;

        /// <summary>Adds <see cref="InRange"/> when its range is counted; ranges without points in the cell may be
        /// skipped.</summary>
        public void Close(int range)
        {
            if (Ranges > 0 && LastRange == range - 1)
            {
                SquaresOfDifferences += (InRange - InLast) * (InRange - InLast);
            }
            else
            {
                SquaresOfDifferences += range > 0 ? InRange * InRange : 0;
                SquaresOfDifferences += InLast * InLast;
            }
            Points += InRange;
            InLast = InRange;
            InRange = 0;
            LastRange = range;
            Ranges++;
        }

        /// <summary>The estimate after all are counted.</summary>
        /// <param name="ranges">Number of ranges in the sample, with or without points here.</param>
        /// <param name="share">The sampled share of the file's points.</param>
        /// <remarks>Points of one range are neighbours in space as well: they say hardly more than one of them would, and a
        /// binomial error would be far too small. Each part of the file has one range, so the variance is estimated by the
        /// differences of neighbouring ones (Wolter, "Introduction to variance estimation", 2007, 8.2), with the correction for a
        /// finite population.</remarks>
        public DensityCell ToCell(int ranges, double share)
        {
            if (Ranges == 0)
                return new DensityCell(0, double.NaN, 0);
            double left = Math.Max(0, 1 - share);
            if (ranges < 2)
                return new DensityCell(Points, left > 0 ? Points : 0, Ranges);
            double squares = SquaresOfDifferences + (LastRange < ranges - 1 ? InLast * InLast : 0);
            return new DensityCell(Points, Math.Sqrt(left * squares * ranges / (2.0 * (ranges - 1))), Ranges);
        }
    }

    /// <summary>How many points of a cloud lie in a cell, as far as a sample shows.</summary>
    internal readonly struct DensityCell
    {
        public readonly double Points; // The estimate; also 0 if nothing is known.
        public readonly double StandardError; // Error of Points, in points; NaN if nothing is known.

        public readonly int Ranges;

        public DensityCell(double points, double standardError, int ranges)
        {
            Points = points;
            StandardError = standardError;
            Ranges = ranges;
        }

        /// <summary>False if no sampled point lies here: there may be none, or some that no range covers.</summary>
        public bool IsKnown => Ranges > 0;
    }

    [BurstCompile]
    unsafe struct CountDensityJob : IJob
    {
        [ReadOnly] public NativeArray<uint> CodeOfPoint;

        /// <summary>The brick that each point was counted in at the previous depth; becomes that of this depth, or -1 if there is
        /// none.</summary>
        public NativeArray<int> BrickOfPoint;
        [ReadOnly] public NativeArray<SampleRange> Ranges; // Counts the ranges from First on, before End.
        public int First;
        public int End;

        public int Depth;
        [ReadOnly] public NativeReference<int2> Bricks; // The depth's first brick and the end of them.
        [ReadOnly] public NativeList<int> ChildBricks;
        public NativeList<DensitySum> Sums;

        public NativeList<int> Touched;

        public void Execute()
        {
            if (Bricks.Value.x == Bricks.Value.y)
                return;
            var sums = (DensitySum*)Sums.GetUnsafePtr();
            for (int r = First; r < End; r++)
            {
                var range = Ranges[r];
                for (int i = 0; i < range.Count; i++)
                    Count(sums, range.First + i, range.Weight);
                for (int i = 0; i < Touched.Length; i++)
                    sums[Touched[i]].Close(r);
                Touched.Clear();
            }
        }

        void Count(DensitySum* sums, int point, double weight)
        {
            uint code = CodeOfPoint[point];
            if (Depth == 0)
            {
                BrickOfPoint[point] = code == OutsideCode ? -1 : 0;
                Add(sums, code == OutsideCode ? Outside : Root, weight);
            }
            int brick = BrickOfPoint[point];
            if (brick < 0)
                return;
            if (Depth > 0)
            {
                brick = ChildBricks[brick * FineCells + FineOf(code, Depth - 1)];
                BrickOfPoint[point] = brick;
                if (brick < 0)
                    return;
            }
            int fine = FineOf(code, Depth);
            Add(sums, CoarseCell(brick, fine >> 3), weight);
            Add(sums, FineCell(brick, fine), weight);
        }

        void Add(DensitySum* sums, int cell, double weight)
        {
            if (sums[cell].InRange == 0)
                Touched.Add(cell);
            sums[cell].InRange += weight;
        }
    }

    [BurstCompile]
    struct DivideDensityJob : IJob
    {
        public NativeReference<int2> Bricks; // The depth's first brick and the end of them; becomes the next depth's.

        public double MaxPoints;

        public NativeList<int> ChildBricks;
        public NativeList<DensitySum> Sums;

        public void Execute()
        {
            var bricks = Bricks.Value;
            for (int brick = bricks.x; brick < bricks.y; brick++)
            {
                for (int fine = 0; fine < FineCells; fine++)
                {
                    if (Sums[FineCell(brick, fine)].Points <= MaxPoints)
                        continue;
                    ChildBricks[brick * FineCells + fine] = ChildBricks.Length / FineCells;
                    DensityTree.AddBrick(ref ChildBricks, ref Sums);
                }
            }
            Bricks.Value = new int2(bricks.y, ChildBricks.Length / FineCells);
        }
    }
}
