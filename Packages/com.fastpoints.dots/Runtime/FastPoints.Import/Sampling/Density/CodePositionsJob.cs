using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Finds the Morton codes of the cells of a <see cref="DensityTree"/> that contain some points of a
    /// sample.</summary>
    [BurstCompile]
    unsafe struct CodePositionsJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<byte> Sample;
        public PositionColumns Positions;
        public PositionTransform Transform;
        public int First;
        public int End;

        public double3 Corner;

        /// <summary>Cells of the last level along one unit.</summary>
        public double CellsPerUnit;

        public NativeArray<uint> CodeOfPoint;

        public void Execute()
        {
            const double cells = 1 << DensityNumbers.Levels;
            double* x = stackalloc double[RunLength];
            double* y = stackalloc double[RunLength];
            double* z = stackalloc double[RunLength];
            for (int first = First; first < End; first += RunLength)
            {
                int run = math.min(RunLength, End - first);
                Positions.Load((byte*)Sample.GetUnsafeReadOnlyPtr(), first, run, x, y, z);
                Transform.ToGeo(run, x, y, z);
                for (int i = 0; i < run; i++)
                {
                    var cell = math.floor((new double3(x[i], y[i], z[i]) - Corner) * CellsPerUnit);
                    CodeOfPoint[first + i] = math.all(cell >= 0) && math.all(cell < cells)
                        ? (uint)Morton.Encode((uint)cell.x, (uint)cell.y, (uint)cell.z) : DensityNumbers.OutsideCode;
                }
            }
        }
    }
}
