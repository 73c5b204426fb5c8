namespace FastPoints.Files
{
    /// <summary>What the decoding jobs of EPT report in <see cref="DecodeResult.Error"/>.</summary>
    static class EptError
    {
        /// <summary>The stream broke off, or is none.</summary>
        public const int Broken = 1;
    }
}
