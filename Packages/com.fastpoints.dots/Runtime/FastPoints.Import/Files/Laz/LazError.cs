namespace FastPoints.Files
{
    /// <summary>What the decoding jobs report in <see cref="DecodeResult.Error"/>.</summary>
    static class LazError
    {
        public const int None = 0;

        /// <summary>The input ended (or one of its layers did) before the points that were asked for.</summary>
        public const int Short = 1;

        /// <summary>All points are there, but the stream does not end where its chunk does: some of them are noise.</summary>
        public const int EndMismatch = 2;

        /// <summary>All points are there, and the stream has more bytes: the file claims too few, or some are noise.</summary>
        public const int GoesOn = 4;

        /// <summary>What lies there is no chunk: neither its count nor its length is what was told of it.</summary>
        public const int NoChunk = 3;

        /// <summary>A file's positions do not lie on the grid that they are wanted on.</summary>
        public const int OffGrid = 5;
    }
}
