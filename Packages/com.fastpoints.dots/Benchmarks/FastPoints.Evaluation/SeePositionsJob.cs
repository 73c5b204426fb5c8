using FastPoints.Files;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>Marks those positions of a <see cref="PositionTable"/> that a decoded block holds. Any number of these may
    /// run at once: they all write the same value.</summary>
    [BurstCompile]
    public struct SeePositionsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeReference<DecodeResult> Result;
        public PositionColumns Columns;
        public PositionTransform Transform;
        [ReadOnly] public NativeArray<double3> Slots;
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> States;

        public unsafe void Execute()
        {
            double* x = stackalloc double[ColumnValues.RunLength];
            double* y = stackalloc double[ColumnValues.RunLength];
            double* z = stackalloc double[ColumnValues.RunLength];
            byte* bytes = (byte*)Block.GetUnsafeReadOnlyPtr();
            var slots = (double3*)Slots.GetUnsafeReadOnlyPtr();
            byte* states = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(States);
            int count = Result.Value.Points;
            for (int first = 0; first < count; first += ColumnValues.RunLength)
            {
                int run = math.min(ColumnValues.RunLength, count - first);
                Columns.LoadGeo(bytes, Transform, first, run, x, y, z);
                for (int i = 0; i < run; i++)
                {
                    int slot = PositionSlots.SlotOf(slots, states, Slots.Length, new double3(x[i], y[i], z[i]));
                    if (states[slot] == PositionSlots.Wanted)
                        states[slot] = PositionSlots.Seen;
                }
            }
        }
    }
}
