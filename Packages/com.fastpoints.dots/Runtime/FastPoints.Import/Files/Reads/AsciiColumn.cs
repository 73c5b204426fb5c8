using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>Stores integers of a text file in a column. HPC#.</summary>
    static unsafe class AsciiColumn
    {
        /// <returns>Whether the value fits into the type; if not, the nearest one that fits is stored.</returns>
        public static bool StoreInteger(byte* column, int row, AttributeType type, int bytes, ulong magnitude, bool isNegative)
        {
            int bits = 8 * bytes;
            bool isSigned = type == AttributeType.Int8 || type == AttributeType.Int16 || type == AttributeType.Int32 ||
                            type == AttributeType.Int64;
            ulong limit;
            if (isSigned)
                limit = isNegative ? 1ul << (bits - 1) : (1ul << (bits - 1)) - 1;
            else
                limit = isNegative ? 0 : ulong.MaxValue >> (64 - bits);
            bool fits = magnitude <= limit;
            ulong value = fits ? magnitude : limit;
            if (isNegative)
                value = 0 - value;
            switch (bytes)
            {
                case 1:
                    column[row] = (byte)value;
                    break;
                case 2:
                    ((ushort*)column)[row] = (ushort)value;
                    break;
                case 4:
                    ((uint*)column)[row] = (uint)value;
                    break;
                default:
                    ((ulong*)column)[row] = value;
                    break;
            }
            return fits;
        }
    }
}
