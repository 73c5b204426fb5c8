namespace FastPoints.Files
{
    /// <summary>From a place in each record to one column, or several. Blittable: jobs carry arrays of these.</summary>
    public struct LasFieldCopy
    {
        /// <summary>Byte of the value in the record.</summary>
        public int RecordByte;

        /// <summary>Byte of the column's first value in the batch.</summary>
        public int Column0;

        /// <summary>The second and third column of the kinds that have them.</summary>
        public int Column1;
        public int Column2;

        /// <summary>As the first four, for the colour of <see cref="LasCopyKind.PositionAndColor"/>.</summary>
        public int ColorByte;
        public int Red;
        public int Green;
        public int Blue;

        public LasCopyKind Kind;
        public byte BitShift;

        /// <summary>After the shift.</summary>
        public byte BitMask;
    }
}
