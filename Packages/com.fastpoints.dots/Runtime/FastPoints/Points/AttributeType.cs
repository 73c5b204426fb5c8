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

    public static class AttributeTypes
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
    }
}
