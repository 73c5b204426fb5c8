using FastPoints.Points;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Octree
{
    /// <summary>A run of points of one node, that becomes blocks of its own.</summary>
    public unsafe struct PackedRun
    {
        /// <summary>Numbers of the records.</summary>
        [NativeDisableUnsafePtrRestriction] public uint* Points;
        public int Count;
    }

    /// <summary>Packs planes of nodes from records in memory, in the layout of <see cref="PlaneShape"/>.</summary>
    public unsafe struct PlanePacker
    {
        [NativeDisableUnsafePtrRestriction] public byte* Records;
        public RecordLayout Layout;

        /// <summary>All columns of all attribute planes.</summary>
        [NativeDisableUnsafePtrRestriction] public StoredColumn* Columns;

        /// <summary>Writes the position plane of a node at the end of a list.</summary>
        /// <param name="min">Out, by run: smallest offset from the corner; <paramref name="max"/> the largest. Three a
        /// run.</param>
        public PlaneRange WritePositions(NativeList<byte> file, PackedRun* runs, int runCount, Grid3 corner, bool isWide,
            ulong* min,
            ulong* max)
        {
            var shape = new PlaneShape(3, isWide ? 7 : 0);
            uint* plane = Begin(file, shape, runs, runCount, out long start, out long word);
            uint* descriptor = plane;
            ulong* values = stackalloc ulong[3 * PlaneShape.MaxPointsPerBlock];
            for (int r = 0; r < runCount; r++)
            {
                for (int c = 0; c < 3; c++)
                {
                    min[3 * r + c] = ulong.MaxValue;
                    max[3 * r + c] = 0;
                }
                for (int first = 0; first < runs[r].Count; first += PlaneShape.MaxPointsPerBlock)
                {
                    int count = math.min(PlaneShape.MaxPointsPerBlock, runs[r].Count - first);
                    for (int i = 0; i < count; i++)
                    {
                        var offset = Layout.PlaceOf(Records + (long)runs[r].Points[first + i] * Layout.StrideBytes) - corner;
                        values[i] = (ulong)offset.X;
                        values[PlaneShape.MaxPointsPerBlock + i] = (ulong)offset.Y;
                        values[2 * PlaneShape.MaxPointsPerBlock + i] = (ulong)offset.Z;
                    }
                    WriteBlock(values, count, shape, plane, ref descriptor, ref word, min + 3 * r, max + 3 * r);
                }
            }
            return End(file, plane, start, word);
        }

        /// <summary>Writes one attribute plane of a node at the end of a list.</summary>
        public PlaneRange WriteAttributes(NativeList<byte> file, PackedRun* runs, int runCount, PlaneShape shape, int firstColumn)
        {
            uint* plane = Begin(file, shape, runs, runCount, out long start, out long word);
            uint* descriptor = plane;
            ulong* values = stackalloc ulong[PlaneShape.MaxColumns * PlaneShape.MaxPointsPerBlock];
            ulong* min = stackalloc ulong[PlaneShape.MaxColumns];
            ulong* max = stackalloc ulong[PlaneShape.MaxColumns];
            for (int r = 0; r < runCount; r++)
            {
                for (int first = 0; first < runs[r].Count; first += PlaneShape.MaxPointsPerBlock)
                {
                    int count = math.min(PlaneShape.MaxPointsPerBlock, runs[r].Count - first);
                    for (int c = 0; c < shape.ColumnCount; c++)
                        LoadColumn(runs[r].Points + first, count, Columns[firstColumn + c], values +
                            c * PlaneShape.MaxPointsPerBlock);
                    WriteBlock(values, count, shape, plane, ref descriptor, ref word, min, max);
                }
            }
            return End(file, plane, start, word);
        }

        /// <summary>Writes a plane of averages of a node at the end of a list.</summary>
        /// <param name="firstColumn">Of the averaged columns.</param>
        public PlaneRange WriteAverages(NativeList<byte> file, PackedRun* runs, int runCount, PlaneShape shape,
            in AveragedColumns averaged, int firstColumn)
        {
            uint* plane = Begin(file, shape, runs, runCount, out long start, out long word);
            uint* descriptor = plane;
            ulong* values = stackalloc ulong[PlaneShape.MaxColumns * PlaneShape.MaxPointsPerBlock];
            ulong* min = stackalloc ulong[PlaneShape.MaxColumns];
            ulong* max = stackalloc ulong[PlaneShape.MaxColumns];
            for (int r = 0; r < runCount; r++)
            {
                for (int first = 0; first < runs[r].Count; first += PlaneShape.MaxPointsPerBlock)
                {
                    int count = math.min(PlaneShape.MaxPointsPerBlock, runs[r].Count - first);
                    for (int i = 0; i < count; i++)
                    {
                        int point = (int)runs[r].Points[first + i];
                        var average = averaged.Of(point, Records + (long)point * Layout.StrideBytes, Layout);
                        for (int c = 0; c < shape.ColumnCount; c++)
                            values[c * PlaneShape.MaxPointsPerBlock + i] = averaged.Stored(average, firstColumn + c);
                    }
                    WriteBlock(values, count, shape, plane, ref descriptor, ref word, min, max);
                }
            }
            return End(file, plane, start, word);
        }

        void LoadColumn(uint* points, int count, in StoredColumn column, ulong* values)
        {
            byte* attribute = Records + Layout.PositionBytes + column.RecordOffset;
            long stride = Layout.StrideBytes;
            if (column.Type == AttributeType.UInt16)
            {
                uint divisor = (uint)column.Divisor;
                if (divisor == 1)
                {
                    for (int i = 0; i < count; i++)
                        values[i] = *(ushort*)(attribute + points[i] * stride);
                    return;
                }
                for (int i = 0; i < count; i++)
                    values[i] = *(ushort*)(attribute + points[i] * stride) / divisor;
                return;
            }
            for (int i = 0; i < count; i++)
                values[i] = OrderedBits.Load(attribute + points[i] * stride, column.Type);
        }

        /// <param name="min">By column: lowered to the block's smallest; <paramref name="max"/> raised to its largest.</param>
        static void WriteBlock(ulong* values, int count, PlaneShape shape, uint* plane, ref uint* descriptor, ref long word,
            ulong* min,
            ulong* max)
        {
            uint widths = (uint)(count - 1) << 24;
            descriptor[0] = (uint)word;
            for (int c = 0; c < shape.ColumnCount; c++)
            {
                ulong* column = values + c * PlaneShape.MaxPointsPerBlock;
                ulong least = column[0], most = column[0];
                for (int i = 1; i < count; i++)
                {
                    least = math.min(least, column[i]);
                    most = math.max(most, column[i]);
                }
                min[c] = math.min(min[c], least);
                max[c] = math.max(max[c], most);
                int width = BlockCodec.WidthOf(most - least);
                widths |= (uint)width << (8 * c);
                int at = shape.MinimumWord(c);
                descriptor[at] = (uint)least;
                if (shape.IsWide(c))
                    descriptor[at + 1] = (uint)(least >> 32);
                word += BlockCodec.PackWide(column, least, count, width, plane + word);
            }
            descriptor[1] = widths;
            descriptor += shape.DescriptorWords;
        }

        /// <summary>Makes room for the longest plane that these runs could need.</summary>
        static uint* Begin(NativeList<byte> file, PlaneShape shape, PackedRun* runs, int runCount, out long start, out long word)
        {
            long blocks = 0, points = 0;
            for (int r = 0; r < runCount; r++)
            {
                blocks += PlaneShape.BlocksOf(runs[r].Count);
                points += runs[r].Count;
            }
            start = file.Length;
            long longest = start + shape.LongestBytes(blocks, points);
            if (file.Capacity < longest)
                file.SetCapacity((int)math.max(longest, math.min((long)file.Capacity * 2, int.MaxValue)));
            file.ResizeUninitialized((int)longest);
            word = blocks * shape.DescriptorWords;
            return (uint*)(file.GetUnsafePtr() + start);
        }

        static PlaneRange End(NativeList<byte> file, uint* plane, long start, long word)
        {
            long length = PlaneShape.LengthBytes(word);
            UnsafeUtility.MemClear(plane + word, length - word * sizeof(uint));
            file.ResizeUninitialized((int)(start + length));
            return new PlaneRange { OffsetBytes = start, LengthBytes = length, Hash = ContentHash.Of(plane, length) };
        }
    }
}
