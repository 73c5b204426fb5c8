using FastPoints.Points;

namespace FastPoints.Store
{
    /// <summary>One column of one attribute plane: what its stored numbers mean. Blittable, for jobs.</summary>
    public struct StoredColumn
    {
        public AttributeType Type;

        /// <summary>Every value of the cloud is a multiple of it, and what is packed is the quotient: 256 or 257 where 8-bit
        /// colours fill 16-bit fields. 1 for all but 16-bit unsigned attributes.</summary>
        public int Divisor;

        /// <summary>Byte at which the value lies in a record: the values of all attributes, one after the other.</summary>
        public int RecordOffset;
    }
}
