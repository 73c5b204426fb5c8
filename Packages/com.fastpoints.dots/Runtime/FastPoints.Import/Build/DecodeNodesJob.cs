using FastPoints.Core;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Unpacks chosen nodes into a batch: positions as doubles in grid steps from the batch's corner, attributes as they
    /// are. Planes are checked before they are read; a damaged node is marked and not unpacked.</summary>
    [BurstCompile]
    internal unsafe struct DecodeNodesJob : IJobParallelFor
    {
        [ReadOnly] public NativeArray<byte> File;

        /// <summary>Where the bytes begin in the file.</summary>
        public long FileOffset;
        [ReadOnly] public NativeArray<ChosenNode> Nodes;

        /// <summary>Indexed by node times planes, plus plane: position first, then the wanted ones.</summary>
        [ReadOnly] public NativeArray<PlaneRange> Ranges;

        /// <summary>Indexed by wanted plane, without the position.</summary>
        [ReadOnly] public NativeArray<PlaneShape> Shapes;

        /// <summary>Indexed by column of the wanted planes.</summary>
        [ReadOnly] public NativeArray<StoredColumn> Columns;

        /// <summary>Where the values of each column of the wanted planes go in the batch.</summary>
        [ReadOnly] public NativeArray<PointColumn> Targets;
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;

        /// <summary>The batch; each node has its own part of every column.</summary>
        [NativeDisableParallelForRestriction] public NativeArray<byte> Batch;

        public NativeArray<bool> IsDamaged;

        public void Execute(int index)
        {
            var node = Nodes[index];
            var file = (byte*)File.GetUnsafeReadOnlyPtr();
            for (int p = 0; p <= Shapes.Length; p++)
            {
                var range = Ranges[node.FirstRange + p];
                byte* plane = file + (range.OffsetBytes - FileOffset);
                if (ContentHash.Of(plane, range.LengthBytes) != range.Hash ||
                    !PlaneView.IsValid(plane, range.LengthBytes, ShapeOf(p, node.IsWide), node.PlaneBlocks))
                {
                    IsDamaged[index] = true;
                    return;
                }
            }
            WritePositions(node, file);
            int column = 0;
            for (int p = 1; p <= Shapes.Length; p++)
                for (int c = 0; c < Shapes[p - 1].ColumnCount; c++)
                    WriteColumn(node, file, p, c, Columns[column], Targets[column++]);
        }

        PlaneShape ShapeOf(int plane, bool isWide) => plane == 0 ? new PlaneShape(3, isWide ? 7 : 0) : Shapes[plane - 1];

        PlaneView ViewOf(in ChosenNode node, byte* file, int plane) =>
            new PlaneView(file + (Ranges[node.FirstRange + plane].OffsetBytes - FileOffset), ShapeOf(plane, node.IsWide),
                node.PlaneBlocks);

        void WritePositions(in ChosenNode node, byte* file)
        {
            var batch = (byte*)Batch.GetUnsafePtr();
            var plane = ViewOf(node, file, 0);
            ulong* values = stackalloc ulong[PlaneShape.MaxPointsPerBlock];
            for (int axis = 0; axis < 3; axis++)
            {
                var to = (double*)(batch + (axis == 0 ? X : axis == 1 ? Y : Z).OffsetBytes) + node.FirstPoint;
                long corner = axis == 0 ? node.Corner.X : axis == 1 ? node.Corner.Y : node.Corner.Z;
                for (int b = node.FirstBlock; b < node.FirstBlock + node.BlockCount; b++)
                {
                    int count = plane.PointsOf(b);
                    plane.UnpackWide(b, axis, values);
                    for (int i = 0; i < count; i++)
                        to[i] = corner + (long)values[i];
                    to += count;
                }
            }
        }

        void WriteColumn(in ChosenNode node, byte* file, int planeIndex, int columnInPlane, in StoredColumn column,
            PointColumn target)
        {
            var plane = ViewOf(node, file, planeIndex);
            int size = target.Type.SizeOf();
            byte* to = (byte*)Batch.GetUnsafePtr() + target.OffsetBytes + (long)node.FirstPoint * size;
            ulong* values = stackalloc ulong[PlaneShape.MaxPointsPerBlock];
            for (int b = node.FirstBlock; b < node.FirstBlock + node.BlockCount; b++)
            {
                int count = plane.PointsOf(b);
                plane.UnpackWide(b, columnInPlane, values);
                for (int i = 0; i < count; i++, to += size)
                    OrderedBits.Store(values[i] * (ulong)column.Divisor, column.Type, to);
            }
        }
    }

    /// <summary>One node to decode: where its blocks lie in a file's bytes, and where its points go. Blittable.</summary>
    internal struct ChosenNode
    {
        public int FirstBlock;
        public int BlockCount;
        public int PlaneBlocks;
        public bool IsWide;

        /// <summary>The corner that its positions count from, relative to the batch's corner.</summary>
        public Grid3 Corner;

        /// <summary>Index of its first point in the batch.</summary>
        public int FirstPoint;

        /// <summary>Index of its first plane among the job's ranges.</summary>
        public int FirstRange;
    }
}
