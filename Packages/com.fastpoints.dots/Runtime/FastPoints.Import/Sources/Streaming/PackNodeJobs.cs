using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // Moves positions of a slice to the cloud's grid and sorts them along the Morton curve, so that neighbours share a
    // block. A node of several slices becomes several stretches along the curve.
    [BurstCompile]
    internal unsafe struct OrderNodeJob : IJob
    {
        public const int PointsPerSlice = 1 << 16; // About 3 ms.

        // Along each axis: cells that are finer than those of a full block's points.
        const int KeyBits = 10;
        const int BatchLength = 128;

        [ReadOnly] public NativeArray<byte> Columns;
        [ReadOnly] public NativeReference<DecodeResult> Decoded;
        public PositionColumns Positions;
        public SourceToGrid Grid;
        public Grid3 Corner;
        public bool IsWide;
        public Grid3 CubeCorner; // Relative to Corner.

        public int3 CubeBits;
        public int Count;
        public int First;
        public int Capacity;
        public NativeArray<byte> Offsets; // Out: X, Y, Z of each point from the corner, 32 or 64 bits each.

        // Out: the point of each rank along the curve.
        public NativeArray<uint> PointOfRank;
        public NativeReference<PackState> State;
        public NativeArray<ulong> Keys;
        public NativeArray<ulong> KeyScratch;
        public NativeArray<uint> PointScratch;

        public void Execute()
        {
            var state = State.Value;
            if (First == 0)
                state = new PackState { IsDamaged = Decoded.Value.Points < Count || Decoded.Value.Error != 0 };
            int count = math.min(PointsPerSlice, Count - First);
            if (!state.IsDamaged)
            {
                state.IsDamaged = !TryComputeOffsets(count);
                RadixSort.Sort((ulong*)Keys.GetUnsafePtr(), (uint*)PointOfRank.GetUnsafePtr() + First,
                    (ulong*)KeyScratch.GetUnsafePtr(), (uint*)PointScratch.GetUnsafePtr(), count);
            }
            State.Value = state;
        }

        bool TryComputeOffsets(int count)
        {
            byte* columns = (byte*)Columns.GetUnsafeReadOnlyPtr();
            var keys = (ulong*)Keys.GetUnsafePtr();
            uint* points = (uint*)PointOfRank.GetUnsafePtr() + First;
            long* x = stackalloc long[BatchLength], y = stackalloc long[BatchLength], z = stackalloc long[BatchLength];
            double loss = 0;
            bool isValid = true;
            for (int at = 0; at < count; at += BatchLength)
            {
                int length = math.min(BatchLength, count - at);
                SourceToGrid.ToGrid(Grid.X, Positions.X.At(columns, First + at), Positions.X.Type, length, x, ref loss);
                SourceToGrid.ToGrid(Grid.Y, Positions.Y.At(columns, First + at), Positions.Y.Type, length, y, ref loss);
                SourceToGrid.ToGrid(Grid.Z, Positions.Z.At(columns, First + at), Positions.Z.Type, length, z, ref loss);
                isValid &= Store(x, Corner.X, 0, First + at, length) & Store(y, Corner.Y, 1, First + at, length) &
                    Store(z, Corner.Z, 2, First + at, length);
                for (int i = 0; i < length; i++)
                {
                    keys[at + i] = Morton.Encode(Cell(x[i], CubeCorner.X, CubeBits.x), Cell(y[i], CubeCorner.Y, CubeBits.y),
                        Cell(z[i], CubeCorner.Z, CubeBits.z));
                    points[at + i] = (uint)(First + at + i);
                }
            }
            return isValid;
        }

        // False if a position has no packed number.
        bool Store(long* positions, long corner, int axis, int first, int count)
        {
            long any = 0;
            if (IsWide)
            {
                var wide = (ulong*)Offsets.GetUnsafePtr() + (long)axis * Capacity + first;
                for (int i = 0; i < count; i++)
                {
                    positions[i] -= corner;
                    any |= positions[i];
                    wide[i] = (ulong)positions[i];
                }
                return any >= 0;
            }
            var narrow = (uint*)Offsets.GetUnsafePtr() + (long)axis * Capacity + first;
            for (int i = 0; i < count; i++)
            {
                positions[i] -= corner;
                any |= positions[i];
                narrow[i] = (uint)positions[i];
            }
            return (ulong)any <= uint.MaxValue;
        }

        // A position outside its cube is clamped to its side.
        static uint Cell(long position, long cube, int bits) =>
            (uint)(math.clamp(position - cube, 0, (1L << bits) - 1) >> math.max(0, bits - KeyBits));
    }

    internal struct PackState
    {
        public bool IsDamaged; // The source did not give the node's points, or one exceeds the range of packed numbers.

        public long PlaneStart;
        public long Word; // In that plane, of the next packed word.
    }

    // Some blocks of a plane, after those of the previous slice. The planes of a node follow one another.
    [BurstCompile]
    internal unsafe struct PackPlaneJob : IJob
    {
        public const int BlocksPerSlice = 512; // About 2 ms.

        [ReadOnly] public NativeArray<byte> Columns;
        [ReadOnly] public NativeArray<byte> Offsets;
        [ReadOnly] public NativeArray<uint> PointOfRank;
        public PlaneShape Shape;

        // In the batch; the position plane has none.
        public PointColumn Column0;
        public PointColumn Column1;
        public PointColumn Column2;
        public int Plane; // Among the streamed planes: 0 is the position's.

        public int Count;
        public int FirstBlock;
        public int Capacity;
        public NativeArray<byte> Packed; // Capacity for the longest planes.

        public NativeArray<long> LengthOfPlane;
        public NativeReference<PackState> State;

        public void Execute()
        {
            var state = State.Value;
            if (state.IsDamaged)
                return;
            int blocks = PlaneShape.BlocksOf(Count);
            if (FirstBlock == 0)
                state.Word = (long)blocks * Shape.DescriptorWords;
            var writer = new BlockWriter((uint*)((byte*)Packed.GetUnsafePtr() + state.PlaneStart), Shape, FirstBlock, state.Word);
            ulong* values = stackalloc ulong[PlaneShape.MaxColumns * PlaneShape.MaxPointsPerBlock];
            ulong* min = stackalloc ulong[PlaneShape.MaxColumns];
            ulong* max = stackalloc ulong[PlaneShape.MaxColumns];
            int end = math.min(FirstBlock + BlocksPerSlice, blocks);
            for (int block = FirstBlock; block < end; block++)
            {
                int first = block * PlaneShape.MaxPointsPerBlock, count = math.min(PlaneShape.MaxPointsPerBlock, Count - first);
                Gather(first, count, values);
                writer.Write(values, count, min, max);
            }
            state.Word = writer.Word;
            if (end == blocks)
            {
                long length = writer.End();
                LengthOfPlane[Plane] = length;
                state.PlaneStart += length;
            }
            State.Value = state;
        }

        void Gather(int first, int count, ulong* values)
        {
            uint* points = (uint*)PointOfRank.GetUnsafeReadOnlyPtr() + first;
            for (int c = 0; c < Shape.ColumnCount; c++)
            {
                if (Plane == 0)
                    GatherOffsets(points, count, c, values);
                else
                    GatherColumn(points, count, c == 0 ? Column0 : c == 1 ? Column1 : Column2, c, values);
            }
        }

        void GatherOffsets(uint* points, int count, int axis, ulong* values)
        {
            if (Shape.IsWide(axis))
            {
                ulong* wide = (ulong*)Offsets.GetUnsafeReadOnlyPtr() + (long)axis * Capacity;
                for (int i = 0; i < count; i++)
                    BlockWriter.WideOf(values, axis)[i] = wide[points[i]];
                return;
            }
            uint* narrow = (uint*)Offsets.GetUnsafeReadOnlyPtr() + (long)axis * Capacity;
            uint* to = BlockWriter.NarrowOf(values, axis);
            for (int i = 0; i < count; i++)
                to[i] = narrow[points[i]];
        }

        void GatherColumn(uint* points, int count, PointColumn column, int c, ulong* values)
        {
            byte* from = (byte*)Columns.GetUnsafeReadOnlyPtr() + column.OffsetBytes;
            uint* to = BlockWriter.NarrowOf(values, c);
            var type = column.Type;
            if (type == AttributeType.UInt16)
            {
                for (int i = 0; i < count; i++)
                    to[i] = ((ushort*)from)[points[i]];
                return;
            }
            if (type == AttributeType.UInt8)
            {
                for (int i = 0; i < count; i++)
                    to[i] = from[points[i]];
                return;
            }
            int size = type.SizeOf();
            for (int i = 0; i < count; i++)
            {
                ulong stored = OrderedBits.Load(from + (long)points[i] * size, type);
                if (Shape.IsWide(c))
                    BlockWriter.WideOf(values, c)[i] = stored;
                else
                    to[i] = (uint)stored;
            }
        }
    }
}
