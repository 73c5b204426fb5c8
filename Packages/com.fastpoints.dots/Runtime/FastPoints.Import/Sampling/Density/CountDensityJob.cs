using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Counts some segments of a sample into the bricks of one depth: see <see cref="DensityTree"/>.</summary>
    [BurstCompile]
    unsafe struct CountDensityJob : IJob
    {
        [ReadOnly] public NativeArray<uint> CodeOfPoint;

        /// <summary>The brick that each point was counted in at the previous depth; becomes that of this depth, or -1 if there is
        /// none.</summary>
        public NativeArray<int> BrickOfPoint;

        /// <summary>Empty if each point is a segment of its own and stands for <see cref="WeightOfEach"/>.</summary>
        [ReadOnly] public NativeArray<SampleRun> Runs;
        public double WeightOfEach;

        /// <summary>First entry of <see cref="Runs"/>, or first point; segments are never divided.</summary>
        public int First;
        public int End;

        public int Depth;

        /// <summary>The depth's first brick and the end of them.</summary>
        [ReadOnly] public NativeReference<int2> Bricks;
        [ReadOnly] public NativeList<int> ChildBricks;
        public NativeList<DensitySum> Sums;

        /// <summary>Cells in which the current segment has points.</summary>
        public NativeList<int> Touched;

        public void Execute()
        {
            if (Bricks.Value.x == Bricks.Value.y)
                return;
            var sums = (DensitySum*)Sums.GetUnsafePtr();
            if (Runs.Length == 0)
            {
                for (int i = First; i < End; i++)
                {
                    Count(sums, i, WeightOfEach);
                    Close(sums, i);
                }
                return;
            }
            for (int r = First; r < End; r++)
            {
                var run = Runs[r];
                for (int i = 0; i < run.Count; i++)
                    Count(sums, run.First + i, run.Weight);
                if (r + 1 == End || Runs[r + 1].Segment != run.Segment)
                    Close(sums, run.Segment);
            }
        }

        void Count(DensitySum* sums, int point, double weight)
        {
            uint code = CodeOfPoint[point];
            if (Depth == 0)
            {
                BrickOfPoint[point] = code == DensityNumbers.OutsideCode ? -1 : 0;
                Add(sums, code == DensityNumbers.OutsideCode ? DensityNumbers.Outside : DensityNumbers.Root, weight);
            }
            int brick = BrickOfPoint[point];
            if (brick < 0)
                return;
            if (Depth > 0)
            {
                brick = ChildBricks[brick * DensityNumbers.FineCells + DensityNumbers.FineOf(code, Depth - 1)];
                BrickOfPoint[point] = brick;
                if (brick < 0)
                    return;
            }
            int fine = DensityNumbers.FineOf(code, Depth);
            Add(sums, DensityNumbers.CoarseCell(brick, fine >> 3), weight);
            Add(sums, DensityNumbers.FineCell(brick, fine), weight);
        }

        void Add(DensitySum* sums, int cell, double weight)
        {
            if (sums[cell].InSegment == 0)
                Touched.Add(cell);
            sums[cell].InSegment += weight;
        }

        void Close(DensitySum* sums, int segment)
        {
            for (int i = 0; i < Touched.Length; i++)
                sums[Touched[i]].Close(segment);
            Touched.Clear();
        }
    }
}
