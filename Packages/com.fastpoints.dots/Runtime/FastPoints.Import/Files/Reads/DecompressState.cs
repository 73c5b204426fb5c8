namespace FastPoints.Files
{
    /// <summary>How far a stream has been decoded, from slice to slice.</summary>
    struct DecompressState
    {
        /// <summary>Bytes of the input that are done with.</summary>
        public int Consumed;

        /// <summary>Whether the stream broke off, or its decompressor failed: nothing more comes of it.</summary>
        public bool IsBroken;
    }
}
