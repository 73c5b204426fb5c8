using FastPoints.Drawing;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>A slice of adding points to the voxels of a cell and its margins. Slices run one after another.</summary>
    [BurstCompile]
    internal unsafe struct CollectVoxelsJob : IJob
    {
        public const int PointsPerSlice = 100000; // A slice takes about a millisecond.
        public const int SumStepsPerVoxel = 1024; // Of a voxel's edge: what is in a voxel is summed in these.
        const uint MaxPointsPerVoxel = 1u << 21; // More points would overflow the sums; their mean has long been found.

        public int First;
        public int End;
        public SurfaceGrid Grid;
        public int3 Cell;
        public double3 StepMetres; // Of what positions are stored in.
        public ClassMask Hidden; // Points of these classes are left out.
        [ReadOnly] public NativeArray<double> X;
        [ReadOnly] public NativeArray<double> Y;
        [ReadOnly] public NativeArray<double> Z;
        [ReadOnly] public NativeArray<byte> Classes; // By point; empty if all are taken.
        public SurfaceMemory Memory;
        public SliceTimes Times;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int side = Grid.SideWithMargins;
            var scale = StepMetres * (SumStepsPerVoxel / Grid.VoxelMetres);
            // Rounded before it is moved to the cell, so that a point is at the same step in each.
            var corner = (new double3(Cell.x, Cell.y, Cell.z) * Grid.CellEdgeVoxels - Grid.Margin) * SumStepsPerVoxel;
            double end = (double)side * SumStepsPerVoxel;
            double* xs = (double*)X.GetUnsafeReadOnlyPtr(), ys = (double*)Y.GetUnsafeReadOnlyPtr(),
                zs = (double*)Z.GetUnsafeReadOnlyPtr();
            var classes = Classes.Length == 0 ? null : (byte*)Classes.GetUnsafeReadOnlyPtr();
            var surfelOf = (int*)Memory.SurfelOf.GetUnsafePtr();
            for (int i = First; i < End; i++)
            {
                double x = math.floor(xs[i] * scale.x) - corner.x, y = math.floor(ys[i] * scale.y) - corner.y,
                    z = math.floor(zs[i] * scale.z) - corner.z;
                if (!(x >= 0 && y >= 0 && z >= 0 && x < end && y < end && z < end) ||
                    classes != null && Hidden.Has(classes[i]))
                    continue;
                uint sx = (uint)x, sy = (uint)y, sz = (uint)z;
                int at = (int)(sx / SumStepsPerVoxel) +
                    side * ((int)(sy / SumStepsPerVoxel) + side * (int)(sz / SumStepsPerVoxel));
                if (surfelOf[at] == 0)
                {
                    Memory.Voxels.Add(new SurfaceVoxel { At = at });
                    surfelOf[at] = Memory.Voxels.Length;
                }
                var voxel = Memory.Voxels.GetUnsafePtr() + surfelOf[at] - 1;
                if (voxel->Count == MaxPointsPerVoxel)
                    continue;
                voxel->Count++;
                voxel->X += sx % SumStepsPerVoxel;
                voxel->Y += sy % SumStepsPerVoxel;
                voxel->Z += sz % SumStepsPerVoxel;
            }
            Times.End(begin);
        }
    }
}
