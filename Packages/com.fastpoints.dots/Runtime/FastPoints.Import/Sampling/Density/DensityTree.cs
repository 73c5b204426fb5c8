using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;
using static FastPoints.Sampling.DensityNumbers;

namespace FastPoints.Sampling
{
    /// <summary>Estimated points in the cells of an adaptive grid: a cube whose cells are divided in eight where a sample says
    /// enough about their parts. It knows only the cells' Morton codes, no coordinates.</summary>
    /// <remarks>Levels come in pairs: a brick has the 8 cells of one level and the 64 of the next; divided ones have a brick of
    /// their own. The result is the same for any number of threads.</remarks>
    internal sealed class DensityTree : IDisposable
    {
        /// <summary>Points of one slice: about 2 ms of managed code.</summary>
        const int PointsPerSlice = 1 << 15;

        NativeList<DensitySum> m_sums;
        NativeList<int> m_childBricks;
        int m_segments;
        double m_share;

        DensityTree()
        {
            m_sums = new NativeList<DensitySum>(FirstBrick + CellsOfBrick, Allocator.Persistent);
            m_childBricks = new NativeList<int>(FineCells, Allocator.Persistent);
            for (int i = 0; i < FirstBrick; i++)
                m_sums.Add(default);
            AddBrick(ref m_childBricks, ref m_sums);
        }

        /// <summary>The estimate for a cell's number.</summary>
        public DensityCell this[int cell] => m_sums[cell].ToCell(m_segments, m_share);

        /// <summary>The number of the first of a cell's eight parts, in Morton order; -1 if it is not divided.</summary>
        public int FirstPartOf(int cell)
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
        /// <param name="runs">Segments in the file's order; empty if each point is a segment of its own.</param>
        /// <param name="weightOfEach">Points that each point stands for, if there are no runs.</param>
        /// <param name="share">The sampled share of the file's points, 0 to 1.</param>
        /// <param name="minSegments">Cells with points of fewer segments are not divided.</param>
        /// <param name="maxPoints">Cells with no more points are not divided.</param>
        /// <param name="coded">Completes when the codes are there.</param>
        /// <param name="take">Receives the tree at the end; the caller disposes it.</param>
        public static IEnumerator<JobStep> Count(NativeArray<uint> codes, NativeArray<SampleRun> runs, double weightOfEach,
            double share, int minSegments, double maxPoints, JobHandle coded, Action<DensityTree> take)
        {
            var tree = new DensityTree { m_share = share };
            var bricks = new NativeArray<int>(Math.Max(1, codes.Length), Allocator.Persistent);
            var touched = new NativeList<int>(Allocator.Persistent);
            var bricksOfDepth = new NativeReference<int2>(new int2(0, 1), Allocator.Persistent);
            try
            {
                int entries = runs.Length > 0 ? runs.Length : codes.Length;
                tree.m_segments = runs.Length > 0 ? runs[runs.Length - 1].Segment + 1 : codes.Length;
                var begins = new List<int> { 0 };
                while (begins[begins.Count - 1] < entries)
                    begins.Add(EndOfSlice(runs, begins[begins.Count - 1], entries));
                // Each depth counts in all slices but one, which divides.
                int slices = begins.Count;
                yield return JobStep.Of(Slices.Run(0, Levels / 2 * slices - 1, 1, (n, _, after) => n % slices == slices - 1
                    ? new DivideDensityJob
                    {
                        Bricks = bricksOfDepth,
                        MinSegments = minSegments,
                        MaxPoints = maxPoints,
                        ChildBricks = tree.m_childBricks,
                        Sums = tree.m_sums,
                    }.Schedule(after)
                    : new CountDensityJob
                    {
                        CodeOfPoint = codes,
                        BrickOfPoint = bricks,
                        Runs = runs,
                        WeightOfEach = weightOfEach,
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
                bricksOfDepth.Dispose();
                bricks.Dispose();
                touched.Dispose();
                tree?.Dispose();
            }
        }

        static int EndOfSlice(NativeArray<SampleRun> runs, int begin, int entries)
        {
            if (runs.Length == 0)
                return Math.Min(entries, begin + PointsPerSlice);
            int end = begin;
            for (int points = 0; end < entries && (points < PointsPerSlice || runs[end].Segment == runs[end - 1].Segment); end++)
                points += runs[end].Count;
            return end;
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

    /// <summary>Gives a brick of their own to the cells of one depth that are worth dividing.</summary>
    [BurstCompile]
    struct DivideDensityJob : IJob
    {
        /// <summary>The depth's first brick and the end of them; becomes the next depth's.</summary>
        public NativeReference<int2> Bricks;

        /// <summary>A cell with fewer says less about its parts than their error.</summary>
        public int MinSegments;

        /// <summary>A cell with no more is small enough.</summary>
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
                    var sum = Sums[FineCell(brick, fine)];
                    if (sum.Segments < MinSegments || sum.Points <= MaxPoints)
                        continue;
                    ChildBricks[brick * FineCells + fine] = ChildBricks.Length / FineCells;
                    DensityTree.AddBrick(ref ChildBricks, ref Sums);
                }
            }
            Bricks.Value = new int2(bricks.y, ChildBricks.Length / FineCells);
        }
    }
}
