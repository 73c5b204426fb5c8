namespace FastPoints.Points
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

    internal static class AttributeTypes
    {
        /// <summary>Bytes of one value.</summary>
        public static int SizeOf(this AttributeType type)
        {
            switch (type)
            {
                case AttributeType.UInt8:
                case AttributeType.Int8:
                    return 1;
                case AttributeType.UInt16:
                case AttributeType.Int16:
                    return 2;
                case AttributeType.UInt32:
                case AttributeType.Int32:
                case AttributeType.Float32:
                    return 4;
                default:
                    return 8;
            }
        }

        public static bool IsFloat(this AttributeType type) => type == AttributeType.Float32 || type == AttributeType.Float64;

        public static bool IsSigned(this AttributeType type) => type == AttributeType.Int8 || type == AttributeType.Int16 ||
            type == AttributeType.Int32 || type == AttributeType.Int64 || type.IsFloat();

        /// <summary>The narrowest type that holds the values of both; 64-bit floats if none does.</summary>
        public static AttributeType Common(AttributeType a, AttributeType b)
        {
            if (a == b)
                return a;
            if (a.IsFloat() || b.IsFloat())
                return FitsFloat32(a) && FitsFloat32(b) ? AttributeType.Float32 : AttributeType.Float64;
            int bytes = System.Math.Max(a.SizeOf(), b.SizeOf());
            if (a.IsSigned() == b.IsSigned())
                return a.SizeOf() == bytes ? a : b;
            var unsigned = a.IsSigned() ? b : a;
            if (unsigned.SizeOf() == bytes)
                bytes *= 2;
            return bytes == 2 ? AttributeType.Int16
                : bytes == 4 ? AttributeType.Int32
                : bytes == 8 ? AttributeType.Int64
                : AttributeType.Float64;
        }

        static bool FitsFloat32(AttributeType type) => type == AttributeType.Float32 || type.SizeOf() <= 2;
    }
}
