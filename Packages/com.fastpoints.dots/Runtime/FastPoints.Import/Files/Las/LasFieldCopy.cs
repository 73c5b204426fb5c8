namespace FastPoints.Files
{
    /// <summary>From a place in each record to one column, or three. Blittable: jobs carry arrays of these.</summary>
    public struct LasFieldCopy
    {
        /// <summary>Byte of the value in the record.</summary>
        public int RecordByte;

        /// <summary>Byte of the column's first value in the batch.</summary>
        public int Column0;

        /// <summary>The second and third column of the kinds that have them.</summary>
        public int Column1;
        public int Column2;

        public LasCopyKind Kind;
        public byte BitShift;

        /// <summary>After the shift.</summary>
        public byte BitMask;
    }
}
