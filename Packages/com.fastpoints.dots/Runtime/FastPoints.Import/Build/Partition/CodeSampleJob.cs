using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>Finds the Morton codes of the cells of a <see cref="DensityTree"/> that contain a source's sample.</summary>
    [BurstCompile]
    internal struct CodeSampleJob : IJob
    {
        /// <summary>Points of one run of the job.</summary>
        public const int PointsOfSlice = 1 << 16;

        /// <summary>A slice of a sample.</summary>
        [ReadOnly] public NativeArray<double3> Stored;
        public SourceGrid Grid;
        public GridCube Cube;

        /// <summary>Codes of all sources' samples; this slice's begin at <see cref="First"/>.</summary>
        public NativeArray<uint> CodeOfPoint;
        public int First;
        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            for (int i = 0; i < Stored.Length; i++)
            {
                long x = SourceGrid.ToGrid(Grid.X, Stored[i].x);
                long y = SourceGrid.ToGrid(Grid.Y, Stored[i].y);
                long z = SourceGrid.ToGrid(Grid.Z, Stored[i].z);
                bool isInside = x != SourceGrid.InvalidPosition && y != SourceGrid.InvalidPosition &&
                    z != SourceGrid.InvalidPosition
                    && Cube.Contains(new Grid3(x, y, z));
                CodeOfPoint[First + i] = isInside
                    ? (uint)Morton.Encode(CellOf(x - Cube.Corner.X), CellOf(y - Cube.Corner.Y), CellOf(z - Cube.Corner.Z))
                    : DensityNumbers.OutsideCode;
            }
            Slices.End(begin);
        }

        /// <summary>The cell of an offset. In a small cube cells are parts of a grid step: its positions are in the first of
        /// them.</summary>
        uint CellOf(long offset)
        {
            int below = Cube.SideLog2 - DensityNumbers.Levels;
            return (uint)(below < 0 ? offset << -below : offset >> below);
        }
    }
}
