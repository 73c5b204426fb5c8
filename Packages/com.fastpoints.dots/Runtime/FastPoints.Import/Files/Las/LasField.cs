using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>The location of one attribute in a LAS point record.</summary>
    internal readonly struct LasField
    {
        public readonly string Name;

        /// <summary>Type of the value in a column. Bit fields are UInt8.</summary>
        public readonly AttributeType Type;

        public readonly int ByteOffset;

        /// <summary>Lowest bit of a bit field within its byte.</summary>
        public readonly int BitShift;

        /// <summary>Bits of a bit field, or 0 for a value with bytes of its own.</summary>
        public readonly int BitWidth;

        /// <summary>Value = stored * Scale + Offset; 1 and 0 unless extra bytes say otherwise.</summary>
        public readonly double Scale;

        public readonly double Offset;

        public LasField(string name, AttributeType type, int byteOffset, double scale = 1, double offset = 0)
        {
            Name = name;
            Type = type;
            ByteOffset = byteOffset;
            BitShift = 0;
            BitWidth = 0;
            Scale = scale;
            Offset = offset;
        }

        public LasField(string name, int byteOffset, int bitShift, int bitWidth)
        {
            Name = name;
            Type = AttributeType.UInt8;
            ByteOffset = byteOffset;
            BitShift = bitShift;
            BitWidth = bitWidth;
            Scale = 1;
            Offset = 0;
        }

        public bool IsBits => BitWidth != 0;

        /// <summary>The same field in a record part that starts at <paramref name="bytes"/>.</summary>
        public LasField MovedBy(int bytes) =>
            IsBits
                ? new LasField(Name, ByteOffset + bytes, BitShift, BitWidth)
                : new LasField(Name, Type, ByteOffset + bytes, Scale, Offset);

        public PointAttribute ToAttribute() => new PointAttribute(Name, Type, Scale, Offset);
    }
}
