namespace FastPoints.Files
{
    /// <summary>How the decoding of one range ended. Written by the decoding job, turned into an exception on the main
    /// thread.</summary>
    public struct DecodeResult
    {
        /// <summary>Points in the batch; fewer than asked for where the input broke off.</summary>
        public int Points;

        /// <summary>0, or what went wrong: a code of the reader's own.</summary>
        public int Error;

        /// <summary>Byte in the file at which it went wrong.</summary>
        public long ErrorOffset;
    }
}
