namespace FastPoints.Files
{
    /// <summary>Codes of <see cref="DecodeResult.Error"/>; bits, since several slices have one result.</summary>
    static class PotreeError
    {
        public const int None = 0;

        /// <summary>Positions beyond the 32-bit grid were set to its edge.</summary>
        public const int OffGrid = 1;

        /// <summary>A compressed node broke off, or its decompressor failed.</summary>
        public const int Broken = 2;
    }
}
