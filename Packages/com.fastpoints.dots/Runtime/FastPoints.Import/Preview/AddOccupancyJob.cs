using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Adds one count of cells to another.</summary>
    [BurstCompile]
    public struct AddOccupancyJob : IJob
    {
        [ReadOnly] public NativeArray<ulong> CellsOfBlock;
        [ReadOnly] public NativeArray<long> PointsOfBlock;
        public NativeArray<ulong> SumOfCells;
        public NativeArray<long> SumOfPoints;

        public void Execute()
        {
            for (int block = 0; block < SumOfCells.Length; block++)
            {
                SumOfCells[block] |= CellsOfBlock[block];
                SumOfPoints[block] += PointsOfBlock[block];
            }
        }
    }
}
