using FastPoints.Core;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    /// <summary>Packs a slice of a node's plane: some blocks, behind those of the previous slice. The planes of a node come one
    /// behind the other.</summary>
    [BurstCompile]
    internal unsafe struct PackPlaneJob : IJob
    {
        /// <summary>A slice takes about 2 ms.</summary>
        public const int BlocksOfSlice = 512;

        /// <summary>The batch that was decoded.</summary>
        [ReadOnly] public NativeArray<byte> Columns;
        [ReadOnly] public NativeArray<byte> Offsets;
        [ReadOnly] public NativeArray<uint> PointOfRank;
        public PlaneShape Shape;

        /// <summary>The plane's columns in the batch; the position plane has none.</summary>
        public PointColumn Column0;
        public PointColumn Column1;
        public PointColumn Column2;

        /// <summary>Index among the streamed planes: 0 is the position's.</summary>
        public int Plane;

        /// <summary>Number of points in the node.</summary>
        public int Count;
        public int FirstBlock;

        /// <summary>Points of a column of <see cref="Offsets"/>.</summary>
        public int Capacity;

        /// <summary>Has room for the longest that the planes can be.</summary>
        public NativeArray<byte> Packed;

        /// <summary>Indexed by plane.</summary>
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
            int end = math.min(FirstBlock + BlocksOfSlice, blocks);
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
