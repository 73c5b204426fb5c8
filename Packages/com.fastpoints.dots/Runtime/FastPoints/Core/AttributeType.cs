using Unity.Mathematics;

namespace FastPoints
{
    /// <summary>Type of one component of one attribute, as it lies in a column.</summary>
    public enum AttributeType : byte
    {
        UInt8,
        Int8,
        UInt16,
        Int16,
        UInt32,
        Int32,
        UInt64,
        Int64,
        Float32,
        Float64,
    }

    // HPC#: two bits a type, or one, stand in for a table that jobs could not have; the first type is at the right.
    internal static class AttributeTypes
    {
        const int SizeLog2s = 0b_11_10_11_11_10_10_01_01_00_00;
        const int Signed = 0b_11_10_10_10_10;

        public static int SizeOf(this AttributeType type) => 1 << (SizeLog2s >> 2 * (int)type & 3);

        public static bool IsFloat(this AttributeType type) => type >= AttributeType.Float32;

        public static bool IsSigned(this AttributeType type) => (Signed >> (int)type & 1) != 0;

        public static AttributeType Integer(int bytes, bool isSigned) =>
            (AttributeType)(2 * math.tzcnt((uint)bytes) + (isSigned ? 1 : 0));

        // The range of an integer type of up to 32 bits; that of 32 bits for any other type.
        public static void RangeUpTo32Bits(this AttributeType type, out long min, out long max)
        {
            long values = 1L << 8 * math.min(4, type.SizeOf());
            min = type.IsSigned() ? -values / 2 : 0;
            max = min + values - 1;
        }

        /// <summary>The narrowest type that holds the values of both; 64-bit floats if none does.</summary>
        public static AttributeType Common(AttributeType a, AttributeType b)
        {
            if (a == b)
                return a;
            if (a.IsFloat() || b.IsFloat())
                return FitsFloat32(a) && FitsFloat32(b) ? AttributeType.Float32 : AttributeType.Float64;
            int bytes = math.max(a.SizeOf(), b.SizeOf());
            if (a.IsSigned() == b.IsSigned())
                return a.SizeOf() == bytes ? a : b;
            var unsigned = a.IsSigned() ? b : a;
            if (unsigned.SizeOf() == bytes)
                bytes *= 2;
            return bytes <= 8 ? Integer(bytes, true) : AttributeType.Float64;
        }

        static bool FitsFloat32(AttributeType type) => type == AttributeType.Float32 || type.SizeOf() <= 2;
    }
}
