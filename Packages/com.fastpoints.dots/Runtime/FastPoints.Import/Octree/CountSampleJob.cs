using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octree
{
    /// <summary>Counts a sample's points by cell of the partition, each with the points it stands for.</summary>
    [BurstCompile]
    public struct CountSampleJob : IJob
    {
        [ReadOnly] public NativeArray<double3> Stored;
        public SourceGrid Grid;
        public CellFinder Cells;

        /// <summary>Points that a sample point stands for, in 1/1024.</summary>
        public long Weight1024;

        /// <summary>In 1/1024 of a point; added to.</summary>
        public NativeArray<long> PointsOfCell;

        public void Execute()
        {
            for (int i = 0; i < Stored.Length; i++)
            {
                long x = SourceGrid.ToGrid(Grid.X, Stored[i].x);
                long y = SourceGrid.ToGrid(Grid.Y, Stored[i].y);
                long z = SourceGrid.ToGrid(Grid.Z, Stored[i].z);
                if (x == SourceGrid.Nowhere || y == SourceGrid.Nowhere || z == SourceGrid.Nowhere)
                    continue;
                int cell = Cells.CellOf(x, y, z);
                if (cell >= 0)
                    PointsOfCell[cell] += Weight1024;
            }
        }
    }
}
