using FastPoints.Core;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Loads stored positions of a few points as doubles: exact for 32-bit integers and floats.</summary>
    [BurstCompile]
    internal unsafe struct LoadSamplePositionsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Columns;
        [ReadOnly] public NativeReference<DecodeResult> Decoded;
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;

        /// <summary>The first point, and room for all from there on that are loaded.</summary>
        public int First;
        public NativeArray<double3> Stored;

        public void Execute()
        {
            var bytes = (byte*)Columns.GetUnsafeReadOnlyPtr();
            int count = math.min(Decoded.Value.Points - First, Stored.Length);
            for (int i = 0; i < count; i++)
                Stored[i] = new double3(Load(bytes, X, First + i), Load(bytes, Y, First + i), Load(bytes, Z, First + i));
        }

        static double Load(byte* bytes, PointColumn column, int index) =>
            ColumnValues.ToDouble(bytes + column.OffsetBytes, column.Type, index);
    }
}
