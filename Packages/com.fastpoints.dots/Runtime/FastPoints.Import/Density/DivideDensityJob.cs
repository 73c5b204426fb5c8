using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Density
{
    /// <summary>Gives a brick of their own to the cells of one depth that are worth looking into.</summary>
    [BurstCompile]
    struct DivideDensityJob : IJob
    {
        /// <summary>Of the depth.</summary>
        public int FirstBrick;
        public int EndBrick;

        /// <summary>A cell of fewer says less of its parts than their error.</summary>
        public int LeastStretches;

        /// <summary>A cell of no more is small enough.</summary>
        public double MostPoints;

        public NativeList<int> ChildBricks;
        public NativeList<DensitySum> Sums;

        public void Execute()
        {
            for (int brick = FirstBrick; brick < EndBrick; brick++)
            {
                for (int fine = 0; fine < DensityTree.FineCells; fine++)
                {
                    var sum = Sums[DensityTree.FineCell(brick, fine)];
                    if (sum.Stretches < LeastStretches || sum.Points <= MostPoints)
                        continue;
                    ChildBricks[brick * DensityTree.FineCells + fine] = ChildBricks.Length / DensityTree.FineCells;
                    DensityTree.AddBrick(ref ChildBricks, ref Sums);
                }
            }
        }
    }
}
