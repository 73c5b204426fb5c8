namespace FastPoints.Files
{
    /// <summary>A <see cref="PointRun"/> whose records have been read. Blittable: jobs carry arrays of these.</summary>
    struct RunInBuffer
    {
        /// <summary>Of the first record in the buffer.</summary>
        public int FirstByte;

        /// <summary>From one record that is wanted to the next.</summary>
        public int StrideBytes;

        public int Count;

        /// <summary>Of the first point in the batch.</summary>
        public int Place;
    }
}
