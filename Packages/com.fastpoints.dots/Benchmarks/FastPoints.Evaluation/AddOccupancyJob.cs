using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Evaluation
{
    /// <summary>Adds one count of cells to another.</summary>
    [BurstCompile]
    public struct AddOccupancyJob : IJob
    {
        [ReadOnly] public NativeArray<ulong> CellsOf128th;
        [ReadOnly] public NativeArray<long> PointsOfBlock;
        public NativeArray<ulong> SumOfCells;
        public NativeArray<long> SumOfPoints;

        public void Execute()
        {
            for (int word = 0; word < SumOfCells.Length; word++)
                SumOfCells[word] |= CellsOf128th[word];
            for (int block = 0; block < SumOfPoints.Length; block++)
                SumOfPoints[block] += PointsOfBlock[block];
        }
    }
}
