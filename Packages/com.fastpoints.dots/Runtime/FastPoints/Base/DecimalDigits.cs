namespace FastPoints.Base
{
    /// <summary>A decimal number as its text gives it: <see cref="Mantissa"/> * 10^<see cref="Exponent"/>, and the text's digits
    /// where these are more than a mantissa holds.</summary>
    public unsafe struct DecimalDigits
    {
        /// <summary>The first 19 significant digits, or all where there are fewer.</summary>
        public ulong Mantissa;

        public int Exponent;

        public bool IsNegative;

        /// <summary>Whether there are digits beyond the mantissa.</summary>
        public bool IsTruncated;

        /// <summary>The first significant digit, where the mantissa is truncated.</summary>
        public byte* FirstDigit;

        /// <summary>Behind the last digit. There may be one point among them.</summary>
        public byte* EndOfDigits;
    }
}
