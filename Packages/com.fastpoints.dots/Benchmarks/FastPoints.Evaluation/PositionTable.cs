using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    public sealed class PositionTable : IDisposable
    {
        NativeArray<double3> m_positions, m_slots;
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
        public NativeArray<byte> States => m_states;

        /// <summary>Whether a position of the table was seen; no job may be in flight.</summary>
        public unsafe bool WasSeen(double3 position)
        {
            int slot = PositionHash.SlotOf((double3*)m_slots.GetUnsafeReadOnlyPtr(), (byte*)m_states.GetUnsafeReadOnlyPtr(),
                m_slots.Length, position);
            return m_states[slot] == PositionHash.Seen;
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

    static class PositionHash
    {
        public const byte Empty = 0, Wanted = 1, Seen = 2;

        /// <summary>The position's slot, or the empty one that it would take. There is an empty one.</summary>
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
                int slot = PositionHash.SlotOf(slots, states, Slots.Length, Positions[i]);
                slots[slot] = Positions[i];
                states[slot] = PositionHash.Wanted;
            }
        }
    }

    /// <summary>Marks those positions of a <see cref="PositionTable"/> that a decoded block holds. Any number of these may
    /// run at once: they all write the same value.</summary>
    [BurstCompile]
    public struct MarkSeenJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeReference<DecodeResult> Result;
        internal PositionColumns Columns;
        public PositionTransform Transform;
        [ReadOnly] public NativeArray<double3> Slots;
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> States;

        public unsafe void Execute()
        {
            double* x = stackalloc double[ColumnValues.BatchLength];
            double* y = stackalloc double[ColumnValues.BatchLength];
            double* z = stackalloc double[ColumnValues.BatchLength];
            byte* bytes = (byte*)Block.GetUnsafeReadOnlyPtr();
            var slots = (double3*)Slots.GetUnsafeReadOnlyPtr();
            byte* states = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(States);
            int count = Result.Value.Points;
            for (int first = 0; first < count; first += ColumnValues.BatchLength)
            {
                int length = math.min(ColumnValues.BatchLength, count - first);
                Columns.Load(bytes, first, length, x, y, z);
                Transform.ToGeo(length, x, y, z);
                for (int i = 0; i < length; i++)
                {
                    int slot = PositionHash.SlotOf(slots, states, Slots.Length, new double3(x[i], y[i], z[i]));
                    if (states[slot] == PositionHash.Wanted)
                        states[slot] = PositionHash.Seen;
                }
            }
        }
    }

    [BurstCompile]
    public struct LoadPositionsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        internal PositionColumns Positions;
        public PositionTransform Transform;
        public int First;
        public int Count;
        public NativeArray<double3> Points;
        public NativeReference<int> Loaded;

        public unsafe void Execute()
        {
            double* x = stackalloc double[ColumnValues.BatchLength];
            double* y = stackalloc double[ColumnValues.BatchLength];
            double* z = stackalloc double[ColumnValues.BatchLength];
            byte* bytes = (byte*)Bytes.GetUnsafeReadOnlyPtr();
            int loaded = Loaded.Value;
            for (int done = 0; done < Count; done += ColumnValues.BatchLength)
            {
                int length = math.min(ColumnValues.BatchLength, Count - done);
                Positions.Load(bytes, First + done, length, x, y, z);
                Transform.ToGeo(length, x, y, z);
                for (int i = 0; i < length; i++)
                    if (PositionBounds.IsFinite(x[i], y[i], z[i]))
                        Points[loaded++] = new double3(x[i], y[i], z[i]);
            }
            Loaded.Value = loaded;
        }
    }
}
