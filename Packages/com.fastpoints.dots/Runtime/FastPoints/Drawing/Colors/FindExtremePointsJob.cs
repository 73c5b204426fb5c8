using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // Finds the farthest of some points in each of many directions from the middle of a box: those of a cube map whose faces
    // are those of the box. Of equally far points the first counts.
    [BurstCompile]
    internal struct FindExtremePointsJob : IJob
    {
        const int EdgeOfFace = 16;
        public const int Directions = 6 * EdgeOfFace * EdgeOfFace;

        // A box counts as this share of its longest edge thick: thinner ones would leave few directions to their sides.
        const double MinThickness = 0.05;

        [ReadOnly] public NativeArray<byte> Bytes;
        public PositionColumns Columns;
        public PositionTransform Transform;
        public int First;
        public int Count;
        public BoundsGeo Around; // Points that are farther outside than its longest edge do not count.

        // Position, and its squared distance from the middle, as a multiple of the box's half edges; 0 for none.
        public NativeArray<double4> Farthest;

        public unsafe void Execute()
        {
            double* x = stackalloc double[ColumnValues.BatchLength];
            double* y = stackalloc double[ColumnValues.BatchLength];
            double* z = stackalloc double[ColumnValues.BatchLength];
            double longest = math.cmax(Around.Size);
            if (!(longest > 0))
                return;
            var middle = Around.Center;
            var max = Around.Size * 0.5 + longest;
            var scale = 2 / math.max(Around.Size, longest * MinThickness);
            for (int done = 0; done < Count; done += ColumnValues.BatchLength)
            {
                int length = math.min(ColumnValues.BatchLength, Count - done);
                Columns.Load((byte*)Bytes.GetUnsafeReadOnlyPtr(), First + done, length, x, y, z);
                Transform.ToGeo(length, x, y, z);
                for (int i = 0; i < length; i++)
                {
                    var from = new double3(x[i], y[i], z[i]) - middle;
                    if (!math.all(math.abs(from) <= max))
                        continue;
                    from *= scale;
                    double distanceSq = math.lengthsq(from);
                    int direction = DirectionOf(from);
                    if (distanceSq > Farthest[direction].w)
                        Farthest[direction] = new double4(x[i], y[i], z[i], distanceSq);
                }
            }
        }

        static int DirectionOf(double3 from)
        {
            var along = math.abs(from);
            int axis = along.x >= along.y && along.x >= along.z ? 0 : along.y >= along.z ? 1 : 2;
            double depth = axis == 0 ? from.x : axis == 1 ? from.y : from.z;
            var across = (axis == 0 ? from.yz : axis == 1 ? from.xz : from.xy) / math.max(math.abs(depth), 1e-300);
            int column = (int)((across.x + 1) * (EdgeOfFace / 2 - 1e-9)), row = (int)((across.y + 1) * (EdgeOfFace / 2 - 1e-9));
            return ((axis * 2 + (depth < 0 ? 1 : 0)) * EdgeOfFace + row) * EdgeOfFace + column;
        }
    }
}
