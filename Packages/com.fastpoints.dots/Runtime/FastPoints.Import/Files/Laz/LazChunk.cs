namespace FastPoints.Files
{
    /// <summary>A stretch of a file that decodes on its own.</summary>
    public struct LazChunk
    {
        /// <summary>In the file.</summary>
        public long Offset;

        public long Bytes;

        /// <summary>As the file says, or as walking it found.</summary>
        public long Points;

        /// <summary>
        /// No chunk holds more points for its bytes: a model of n symbols never makes one of them cheaper than about
        /// 1.44 * (n - 1) / 32768 bits, and a point takes at least the symbols of its mask and coordinates: 0.007 bits.
        /// </summary>
        public const int MaxPointsPerByte = 2000;

        /// <summary>At most so many points are in <paramref name="bytes"/> bytes of a chunk.</summary>
        public static long MaxPoints(long bytes) => 1 + bytes * MaxPointsPerByte;
    }
}
