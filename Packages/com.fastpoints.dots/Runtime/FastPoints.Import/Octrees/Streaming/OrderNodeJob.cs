using FastPoints.Core;
using FastPoints.Nodes;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    /// <summary>Orders a slice of a node's decoded points: it moves their positions to the cloud's grid and sorts them along the
    /// Morton curve, so that neighbours share a block. A node of several slices becomes several runs along the curve.</summary>
    [BurstCompile]
    internal unsafe struct OrderNodeJob : IJob
    {
        /// <summary>A slice takes about 3 ms.</summary>
        public const int PointsOfSlice = 1 << 16;

        /// <summary>Bits of a key along each axis: cells that are finer than those of a full block's points.</summary>
        const int KeyBits = 10;
        const int RunLength = 128;

        /// <summary>The batch that was decoded.</summary>
        [ReadOnly] public NativeArray<byte> Columns;
        [ReadOnly] public NativeReference<DecodeResult> Decoded;
        public PositionColumns Positions;
        public SourceGrid Grid;
        public Grid3 Corner;
        public bool IsWide;

        /// <summary>Position of the node's cube relative to <see cref="Corner"/>.</summary>
        public Grid3 CubePosition;

        /// <summary>Bits of the cube's edges.</summary>
        public int3 CubeBits;

        /// <summary>Number of points in the node.</summary>
        public int Count;
        public int First;

        /// <summary>Points of a column of <see cref="Offsets"/>.</summary>
        public int Capacity;

        /// <summary>Out: X, Y, Z of each point from the corner, 32 or 64 bits each.</summary>
        public NativeArray<byte> Offsets;

        /// <summary>Out: the point at each place along the curve.</summary>
        public NativeArray<uint> PointOfRank;
        public NativeReference<PackState> State;

        /// <summary>Scratch for a slice.</summary>
        public NativeArray<ulong> Keys;
        public NativeArray<ulong> KeyScratch;
        public NativeArray<uint> PointScratch;

        public void Execute()
        {
            var state = State.Value;
            if (First == 0)
                state = new PackState { IsDamaged = Decoded.Value.Points < Count || Decoded.Value.Error != 0 };
            int count = math.min(PointsOfSlice, Count - First);
            if (!state.IsDamaged)
            {
                state.IsDamaged = !TryPlace(count);
                RadixSort.Sort((ulong*)Keys.GetUnsafePtr(), (uint*)PointOfRank.GetUnsafePtr() + First,
                    (ulong*)KeyScratch.GetUnsafePtr(), (uint*)PointScratch.GetUnsafePtr(), count);
            }
            State.Value = state;
        }

        bool TryPlace(int count)
        {
            byte* columns = (byte*)Columns.GetUnsafeReadOnlyPtr();
            var keys = (ulong*)Keys.GetUnsafePtr();
            uint* points = (uint*)PointOfRank.GetUnsafePtr() + First;
            long* x = stackalloc long[RunLength], y = stackalloc long[RunLength], z = stackalloc long[RunLength];
            double loss = 0;
            bool isValid = true;
            for (int at = 0; at < count; at += RunLength)
            {
                int run = math.min(RunLength, count - at);
                SourceGrid.ToGrid(Grid.X, Positions.X.At(columns, First + at), Positions.X.Type, run, x, ref loss);
                SourceGrid.ToGrid(Grid.Y, Positions.Y.At(columns, First + at), Positions.Y.Type, run, y, ref loss);
                SourceGrid.ToGrid(Grid.Z, Positions.Z.At(columns, First + at), Positions.Z.Type, run, z, ref loss);
                isValid &= Store(x, Corner.X, 0, First + at, run) & Store(y, Corner.Y, 1, First + at, run) &
                    Store(z, Corner.Z, 2, First + at, run);
                for (int i = 0; i < run; i++)
                {
                    keys[at + i] = Morton.Encode(Cell(x[i], CubePosition.X, CubeBits.x), Cell(y[i], CubePosition.Y, CubeBits.y),
                        Cell(z[i], CubePosition.Z, CubeBits.z));
                    points[at + i] = (uint)(First + at + i);
                }
            }
            return isValid;
        }

        /// <summary>Moves consecutive positions to the corner and stores them.</summary>
        /// <returns>Whether every position has a packed number.</returns>
        bool Store(long* places, long corner, int axis, int first, int count)
        {
            long any = 0;
            if (IsWide)
            {
                var wide = (ulong*)Offsets.GetUnsafePtr() + (long)axis * Capacity + first;
                for (int i = 0; i < count; i++)
                {
                    places[i] -= corner;
                    any |= places[i];
                    wide[i] = (ulong)places[i];
                }
                return any >= 0;
            }
            var narrow = (uint*)Offsets.GetUnsafePtr() + (long)axis * Capacity + first;
            for (int i = 0; i < count; i++)
            {
                places[i] -= corner;
                any |= places[i];
                narrow[i] = (uint)places[i];
            }
            return (ulong)any <= uint.MaxValue;
        }

        /// <summary>The cell of a position; one outside its cube goes with those at its side.</summary>
        static uint Cell(long place, long cube, int bits) =>
            (uint)(math.clamp(place - cube, 0, (1L << bits) - 1) >> math.max(0, bits - KeyBits));
    }

    /// <summary>The progress of packing a node, from slice to slice.</summary>
    internal struct PackState
    {
        /// <summary>Whether the source did not give the node's points, or one exceeds the range of packed numbers.</summary>
        public bool IsDamaged;

        /// <summary>Offset of the plane that is being written.</summary>
        public long PlaneStart;

        /// <summary>Index in that plane of the next packed word.</summary>
        public long Word;
    }
}
