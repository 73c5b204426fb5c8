namespace FastPoints.Files
{
    /// <summary>What a decoding job met that is not as it should be: how often, and the byte of the first one.</summary>
    struct XyzOddities
    {
        public int BadRows;
        public long FirstBadRow;
        public XyzError FirstError;

        public int Remarks;

        /// <summary>Coordinates with more digits than the sample had: rounded to its step.</summary>
        public int Rounded;
        public long FirstRounded;

        /// <summary>Values that their column's type cannot hold.</summary>
        public int Misfits;
        public long FirstMisfit;

        /// <summary>Nothing between two separators: read as 0.</summary>
        public int EmptyValues;
        public long FirstEmpty;

        public int RowsWithMore;
        public long FirstWithMore;
    }

    enum XyzError : byte
    {
        None,
        TooFewValues,
        NoNumber,
        TooLarge,
        LineTooLong,
    }
}
