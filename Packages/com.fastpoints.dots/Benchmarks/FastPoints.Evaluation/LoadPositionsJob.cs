using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>Appends a slice of a batch's finite positions, georeferenced, to those that came before.</summary>
    [BurstCompile]
    public struct LoadPositionsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        internal PositionColumns Positions;
        public PositionTransform Transform;
        public int First;
        public int Count;
        public NativeArray<double3> Points;

        /// <summary>Places filled so far.</summary>
        public NativeReference<int> Loaded;

        public unsafe void Execute()
        {
            double* x = stackalloc double[ColumnValues.RunLength];
            double* y = stackalloc double[ColumnValues.RunLength];
            double* z = stackalloc double[ColumnValues.RunLength];
            byte* bytes = (byte*)Bytes.GetUnsafeReadOnlyPtr();
            int loaded = Loaded.Value;
            for (int done = 0; done < Count; done += ColumnValues.RunLength)
            {
                int run = math.min(ColumnValues.RunLength, Count - done);
                Positions.LoadGeo(bytes, Transform, First + done, run, x, y, z);
                for (int i = 0; i < run; i++)
                    if (PositionBounds.IsFinite(x[i], y[i], z[i]))
                        Points[loaded++] = new double3(x[i], y[i], z[i]);
            }
            Loaded.Value = loaded;
        }
    }
}
