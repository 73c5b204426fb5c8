using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Points
{
    /// <summary>Adds the bounds of a range of points to those found before.</summary>
    [BurstCompile]
    public struct MeasureBoundsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        public PositionColumns Columns;
        public PositionTransform Transform;
        public int First;
        public int Count;
        public NativeReference<PositionBounds> Found;

        public unsafe void Execute()
        {
            var found = Found.Value;
            found.Include(PositionBounds.Measure((byte*)Bytes.GetUnsafeReadOnlyPtr(), Columns, Transform, First, Count));
            Found.Value = found;
        }
    }
}
