using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>A hash table of positions, to see which of them come along. Open addressing, at most half full.</summary>
    public sealed class PositionTable : IDisposable
    {
        NativeArray<double3> m_positions;
        NativeArray<double3> m_slots;
        NativeArray<byte> m_states;

        public PositionTable(double3[] positions, Allocator allocator)
        {
            int bits = 4;
            while (1L << bits < 2L * positions.Length)
                bits++;
            m_positions = new NativeArray<double3>(Math.Max(1, positions.Length), allocator);
            m_positions.GetSubArray(0, positions.Length).CopyFrom(positions);
            Count = positions.Length;
            m_slots = new NativeArray<double3>(1 << bits, allocator);
            m_states = new NativeArray<byte>(1 << bits, allocator);
        }

        public int Count { get; }
        public NativeArray<double3> Positions => m_positions;
        public NativeArray<double3> Slots => m_slots;

        /// <summary>Of each slot: one of <see cref="PositionSlots"/>' states.</summary>
        public NativeArray<byte> States => m_states;

        /// <summary>Whether a position that is in the table has come along; no job may be in flight.</summary>
        public unsafe bool WasSeen(double3 position)
        {
            int slot = PositionSlots.SlotOf((double3*)m_slots.GetUnsafeReadOnlyPtr(), (byte*)m_states.GetUnsafeReadOnlyPtr(),
                m_slots.Length, position);
            return m_states[slot] == PositionSlots.Seen;
        }

        public void Dispose()
        {
            if (!m_slots.IsCreated)
                return;
            m_positions.Dispose();
            m_slots.Dispose();
            m_states.Dispose();
        }
    }
}
