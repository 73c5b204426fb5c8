using Unity.Mathematics;

namespace FastPoints
{
    // Converts columns of any type in batches: the type is examined once a batch, and the loops have no branches.
    internal static unsafe class ColumnValues
    {
        // Callers convert this many at once, on the stack: three arrays of doubles stay in the first-level cache.
        public const int BatchLength = 256;

        // Exact except for 64-bit integers beyond 2^53.
        public static void ToDoubles(byte* column, AttributeType type, int first, int count, double* values)
        {
            switch (type)
            {
                case AttributeType.UInt8:
                    for (int i = 0; i < count; i++)
                        values[i] = column[first + i];
                    break;
                case AttributeType.Int8:
                    for (int i = 0; i < count; i++)
                        values[i] = ((sbyte*)column)[first + i];
                    break;
                case AttributeType.UInt16:
                    for (int i = 0; i < count; i++)
                        values[i] = ((ushort*)column)[first + i];
                    break;
                case AttributeType.Int16:
                    for (int i = 0; i < count; i++)
                        values[i] = ((short*)column)[first + i];
                    break;
                case AttributeType.UInt32:
                    for (int i = 0; i < count; i++)
                        values[i] = ((uint*)column)[first + i];
                    break;
                case AttributeType.Int32:
                    for (int i = 0; i < count; i++)
                        values[i] = ((int*)column)[first + i];
                    break;
                case AttributeType.UInt64:
                    for (int i = 0; i < count; i++)
                        values[i] = ((ulong*)column)[first + i];
                    break;
                case AttributeType.Int64:
                    for (int i = 0; i < count; i++)
                        values[i] = ((long*)column)[first + i];
                    break;
                case AttributeType.Float32:
                    for (int i = 0; i < count; i++)
                        values[i] = ((float*)column)[first + i];
                    break;
                default:
                    for (int i = 0; i < count; i++)
                        values[i] = ((double*)column)[first + i];
                    break;
            }
        }

        public static double ToDouble(byte* column, AttributeType type, int index)
        {
            double value;
            ToDoubles(column, type, index, 1, &value);
            return value;
        }

        // Of types whose numbers a double holds.
        public static void Put(byte* column, AttributeType type, int index, double value)
        {
            switch (type)
            {
                case AttributeType.UInt8: column[index] = (byte)value; break;
                case AttributeType.Int8: ((sbyte*)column)[index] = (sbyte)value; break;
                case AttributeType.UInt16: ((ushort*)column)[index] = (ushort)value; break;
                case AttributeType.Int16: ((short*)column)[index] = (short)value; break;
                case AttributeType.UInt32: ((uint*)column)[index] = (uint)value; break;
                case AttributeType.Int32: ((int*)column)[index] = (int)value; break;
                case AttributeType.Float32: ((float*)column)[index] = (float)value; break;
                default: ((double*)column)[index] = value; break;
            }
        }

        // Integers are sign-extended; floats keep their bits, extended by zeros.
        public static void ToBits(byte* column, AttributeType type, int first, int count, ulong* bits)
        {
            switch (type)
            {
                case AttributeType.UInt8:
                    for (int i = 0; i < count; i++)
                        bits[i] = column[first + i];
                    break;
                case AttributeType.Int8:
                    for (int i = 0; i < count; i++)
                        bits[i] = (ulong)((sbyte*)column)[first + i];
                    break;
                case AttributeType.UInt16:
                    for (int i = 0; i < count; i++)
                        bits[i] = ((ushort*)column)[first + i];
                    break;
                case AttributeType.Int16:
                    for (int i = 0; i < count; i++)
                        bits[i] = (ulong)((short*)column)[first + i];
                    break;
                case AttributeType.Int32:
                    for (int i = 0; i < count; i++)
                        bits[i] = (ulong)((int*)column)[first + i];
                    break;
                case AttributeType.UInt32:
                case AttributeType.Float32:
                    for (int i = 0; i < count; i++)
                        bits[i] = ((uint*)column)[first + i];
                    break;
                default:
                    for (int i = 0; i < count; i++)
                        bits[i] = ((ulong*)column)[first + i];
                    break;
            }
        }

        // A double's bits, changed so that unsigned integers order as the numbers do (not for NaN).
        public static ulong OrderedBits(double value)
        {
            ulong bits = math.asulong(value);
            return (bits & 0x8000000000000000UL) != 0 ? ~bits : bits | 0x8000000000000000UL;
        }

        public static double FromOrderedBits(ulong ordered)
        {
            ulong bits = (ordered & 0x8000000000000000UL) != 0 ? ordered & 0x7FFFFFFFFFFFFFFFUL : ~ordered;
            return math.asdouble(bits);
        }
    }
}
