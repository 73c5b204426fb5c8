using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>How one field of one scan is decoded. Blittable, for jobs.</summary>
    struct E57FieldRead
    {
        public E57FieldKind Kind;

        /// <summary>Its place among the bytestreams; -1 for a value that no stream holds.</summary>
        public int Stream;

        /// <summary>Of one value; 0 for one that is the same in all points.</summary>
        public int Bits;

        /// <summary>Integers: what the packed differences are added to, and the largest difference.</summary>
        public long Minimum;
        public ulong Range;

        public E57Target Target;

        /// <summary>Columns: the type of their values and where the column starts.</summary>
        public AttributeType ColumnType;
        public int ColumnOffsetBytes;

        /// <summary>Vectors: 0 to 2 for positions, 3 to 5 for normals.</summary>
        public int Row;

        /// <summary>Columns of integers: stored * Steps + Bias.</summary>
        public long Steps;
        public long Bias;
        public double Factor;
        public double Addend;
    }
}
