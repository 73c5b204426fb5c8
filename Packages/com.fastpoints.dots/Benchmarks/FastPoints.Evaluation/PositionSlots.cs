using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>Where positions lie in a <see cref="PositionTable"/>.</summary>
    static class PositionSlots
    {
        /// <summary>States of a slot.</summary>
        public const byte Empty = 0, Wanted = 1, Seen = 2;

        /// <summary>The position's slot, or the empty one that it would take. There is an empty one.</summary>
        /// <param name="slotCount">A power of two.</param>
        public static unsafe int SlotOf(double3* slots, byte* states, int slotCount, double3 position)
        {
            // Adding 0 makes one number of both zeros.
            ulong hash = math.asulong(position.x + 0.0) * 0x9E3779B97F4A7C15UL;
            hash = (hash ^ hash >> 32 ^ math.asulong(position.y + 0.0)) * 0xC2B2AE3D27D4EB4FUL;
            hash = (hash ^ hash >> 29 ^ math.asulong(position.z + 0.0)) * 0x165667B19E3779F9UL;
            int mask = slotCount - 1;
            int slot = (int)(hash >> 32) & mask;
            while (states[slot] != Empty
                && !(slots[slot].x == position.x && slots[slot].y == position.y && slots[slot].z == position.z))
                slot = slot + 1 & mask;
            return slot;
        }
    }
}
