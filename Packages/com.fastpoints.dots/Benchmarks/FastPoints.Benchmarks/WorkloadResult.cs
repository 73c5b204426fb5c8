namespace FastPoints.Benchmarks
{
    /// <summary>What one run of a workload did, beside the time that the driver takes.</summary>
    public struct WorkloadResult
    {
        /// <summary>Points (or elements, slices: whatever the workload counts) worked on.</summary>
        public long Points;

        /// <summary>Bytes of input worked on, or 0 where bytes mean nothing.</summary>
        public long Bytes;

        /// <summary>Error of the approximation in <see cref="ErrorUnit"/>; 0 for exact work.</summary>
        public double Error;

        /// <summary>Unit of <see cref="Error"/>, or null for exact work.</summary>
        public string ErrorUnit;

        /// <summary>Whether a larger <see cref="Error"/> is a better one, as of decibels.</summary>
        public bool ErrorIncreaseIsBetter;

        /// <summary>What a number does not say, or null.</summary>
        public string Note;
    }
}
