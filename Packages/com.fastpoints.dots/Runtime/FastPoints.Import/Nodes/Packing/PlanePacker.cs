using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>Some points of one node that become blocks of their own.</summary>
    internal unsafe struct PackedGroup
    {
        [NativeDisableUnsafePtrRestriction] public uint* Points;
        public int Count;
    }

    /// <summary>Packs planes of nodes from records in memory, in the layout of <see cref="PlaneShape"/>.</summary>
    internal unsafe struct PlanePacker
    {
        [NativeDisableUnsafePtrRestriction] public byte* Records;
        public RecordLayout Layout;

        [NativeDisableUnsafePtrRestriction] public StoredColumn* Columns;

        /// <summary>Writes the position plane of a node at the end of a list.</summary>
        /// <param name="min">Receives the smallest offset from the node's corner, three numbers for each group;
        /// <paramref name="max"/> receives the largest.</param>
        public PlaneRange WritePositions(NativeList<byte> file, PackedGroup* groups, int groupCount, in NodeRecord node,
            ulong* min, ulong* max)
        {
            var corner = node.Corner;
            bool isWide = node.IsWide;
            var shape = PlaneShape.OfPositions(isWide);
            var writer = Begin(file, shape, groups, groupCount, out long start);
            ulong* values = stackalloc ulong[3 * PlaneShape.MaxPointsPerBlock];
            for (int r = 0; r < groupCount; r++)
            {
                for (int c = 0; c < 3; c++)
                {
                    min[3 * r + c] = ulong.MaxValue;
                    max[3 * r + c] = 0;
                }
                for (int first = 0; first < groups[r].Count; first += PlaneShape.MaxPointsPerBlock)
                {
                    int count = math.min(PlaneShape.MaxPointsPerBlock, groups[r].Count - first);
                    if (isWide)
                        LoadOffsets(groups[r].Points + first, count, corner, values);
                    else
                        LoadOffsetsNarrow(groups[r].Points + first, count, corner, (uint*)values);
                    writer.Write(values, count, min + 3 * r, max + 3 * r);
                }
            }
            return End(file, writer, start);
        }

        public PlaneRange WriteAttributes(NativeList<byte> file, PackedGroup* groups, int groupCount, PlaneShape shape,
            int firstColumn)
        {
            var writer = Begin(file, shape, groups, groupCount, out long start);
            ulong* values = stackalloc ulong[PlaneShape.MaxColumns * PlaneShape.MaxPointsPerBlock];
            ulong* min = stackalloc ulong[PlaneShape.MaxColumns];
            ulong* max = stackalloc ulong[PlaneShape.MaxColumns];
            for (int r = 0; r < groupCount; r++)
            {
                for (int first = 0; first < groups[r].Count; first += PlaneShape.MaxPointsPerBlock)
                {
                    int count = math.min(PlaneShape.MaxPointsPerBlock, groups[r].Count - first);
                    for (int c = 0; c < shape.ColumnCount; c++)
                    {
                        if (shape.IsWide(c))
                            LoadColumn(groups[r].Points + first, count, Columns[firstColumn + c], BlockWriter.WideOf(values, c));
                        else
                            LoadColumnNarrow(groups[r].Points + first, count, Columns[firstColumn + c],
                                BlockWriter.NarrowOf(values, c));
                    }
                    writer.Write(values, count, min, max);
                }
            }
            return End(file, writer, start);
        }

        /// <summary>Writes a plane of averages of a node at the end of a list.</summary>
        /// <param name="firstColumn">Index of the first averaged column.</param>
        public PlaneRange WriteAverages(NativeList<byte> file, PackedGroup* groups, int groupCount, PlaneShape shape,
            in AveragedColumns averaged, int firstColumn)
        {
            var writer = Begin(file, shape, groups, groupCount, out long start);
            ulong* values = stackalloc ulong[PlaneShape.MaxColumns * PlaneShape.MaxPointsPerBlock];
            ulong* min = stackalloc ulong[PlaneShape.MaxColumns];
            ulong* max = stackalloc ulong[PlaneShape.MaxColumns];
            for (int r = 0; r < groupCount; r++)
            {
                for (int first = 0; first < groups[r].Count; first += PlaneShape.MaxPointsPerBlock)
                {
                    int count = math.min(PlaneShape.MaxPointsPerBlock, groups[r].Count - first);
                    for (int i = 0; i < count; i++)
                    {
                        int point = (int)groups[r].Points[first + i];
                        var average = averaged.Of(point, Records + (long)point * Layout.StrideBytes, Layout);
                        for (int c = 0; c < shape.ColumnCount; c++)
                        {
                            ulong stored = averaged.Stored(average, firstColumn + c);
                            if (shape.IsWide(c))
                                BlockWriter.WideOf(values, c)[i] = stored;
                            else
                                BlockWriter.NarrowOf(values, c)[i] = (uint)stored;
                        }
                    }
                    writer.Write(values, count, min, max);
                }
            }
            return End(file, writer, start);
        }

        void LoadOffsets(uint* points, int count, Grid3 corner, ulong* values)
        {
            for (int i = 0; i < count; i++)
            {
                var offset = Layout.PositionOf(Records + (long)points[i] * Layout.StrideBytes) - corner;
                BlockWriter.WideOf(values, 0)[i] = (ulong)offset.X;
                BlockWriter.WideOf(values, 1)[i] = (ulong)offset.Y;
                BlockWriter.WideOf(values, 2)[i] = (ulong)offset.Z;
            }
        }

        void LoadOffsetsNarrow(uint* points, int count, Grid3 corner, uint* values)
        {
            byte* records = Records;
            long stride = Layout.StrideBytes;
            uint* x = values, y = x + PlaneShape.MaxPointsPerBlock, z = y + PlaneShape.MaxPointsPerBlock;
            if (Layout.IsWide)
            {
                for (int i = 0; i < count; i++)
                {
                    var offset = Layout.PositionOf(records + points[i] * stride) - corner;
                    x[i] = (uint)offset.X;
                    y[i] = (uint)offset.Y;
                    z[i] = (uint)offset.Z;
                }
                return;
            }
            var shift = corner - Layout.Base;
            uint shiftX = (uint)shift.X, shiftY = (uint)shift.Y, shiftZ = (uint)shift.Z;
            for (int i = 0; i < count; i++)
            {
                var position = (uint*)(records + points[i] * stride);
                x[i] = position[0] - shiftX;
                y[i] = position[1] - shiftY;
                z[i] = position[2] - shiftZ;
            }
        }

        void LoadColumn(uint* points, int count, in StoredColumn column, ulong* values)
        {
            byte* attribute = Records + Layout.PositionBytes + column.RecordOffset;
            long stride = Layout.StrideBytes;
            for (int i = 0; i < count; i++)
                values[i] = OrderedBits.Load(attribute + points[i] * stride, column.Type);
        }

        void LoadColumnNarrow(uint* points, int count, in StoredColumn column, uint* values)
        {
            byte* attribute = Records + Layout.PositionBytes + column.RecordOffset;
            long stride = Layout.StrideBytes;
            var type = column.Type;
            if (type == AttributeType.UInt16)
            {
                // Values are multiples of the divisor and have 16 bits, so the product is exact.
                ulong reciprocal = ((1UL << 32) + (uint)column.Divisor - 1) / (uint)column.Divisor;
                for (int i = 0; i < count; i++)
                    values[i] = (uint)(*(ushort*)(attribute + points[i] * stride) * reciprocal >> 32);
                return;
            }
            if (type == AttributeType.UInt8)
            {
                for (int i = 0; i < count; i++)
                    values[i] = attribute[points[i] * stride];
                return;
            }
            for (int i = 0; i < count; i++)
                values[i] = (uint)OrderedBits.Load(attribute + points[i] * stride, type);
        }

        /// <summary>Makes room for the longest plane that these groups could need.</summary>
        static BlockWriter Begin(NativeList<byte> file, PlaneShape shape, PackedGroup* groups, int groupCount, out long start)
        {
            long blocks = 0, points = 0;
            for (int r = 0; r < groupCount; r++)
            {
                blocks += PlaneShape.BlocksOf(groups[r].Count);
                points += groups[r].Count;
            }
            start = file.Length;
            long longest = start + shape.LongestBytes(blocks, points);
            if (file.Capacity < longest)
                file.SetCapacity((int)math.max(longest, math.min((long)file.Capacity * 2, int.MaxValue)));
            file.ResizeUninitialized((int)longest);
            return new BlockWriter((uint*)(file.GetUnsafePtr() + start), shape, 0, blocks * shape.DescriptorWords);
        }

        static PlaneRange End(NativeList<byte> file, BlockWriter writer, long start)
        {
            long length = writer.End();
            file.ResizeUninitialized((int)(start + length));
            return new PlaneRange { OffsetBytes = start, LengthBytes = length, Hash = ContentHash.Of(writer.Plane, length) };
        }
    }
}
