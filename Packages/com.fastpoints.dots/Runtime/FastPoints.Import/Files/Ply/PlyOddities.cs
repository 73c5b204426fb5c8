namespace FastPoints.Files
{
    /// <summary>What a decoding job met that is odd and costs no point.</summary>
    struct PlyOddities
    {
        /// <summary>Values that their integer type cannot hold.</summary>
        public int Misfits;
        public long FirstMisfitOffset;

        public int LinesWithExtraValues;
        public long FirstExtraOffset;
    }
}
