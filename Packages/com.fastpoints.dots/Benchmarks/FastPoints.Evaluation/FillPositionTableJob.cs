using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>Puts the positions of a <see cref="PositionTable"/> into its slots; equal ones share a slot.</summary>
    [BurstCompile]
    public struct FillPositionTableJob : IJob
    {
        [ReadOnly] public NativeArray<double3> Positions;
        public int Count;
        public NativeArray<double3> Slots;
        public NativeArray<byte> States;

        public unsafe void Execute()
        {
            var slots = (double3*)Slots.GetUnsafePtr();
            byte* states = (byte*)States.GetUnsafePtr();
            for (int i = 0; i < Count; i++)
            {
                int slot = PositionSlots.SlotOf(slots, states, Slots.Length, Positions[i]);
                slots[slot] = Positions[i];
                states[slot] = PositionSlots.Wanted;
            }
        }
    }
}
