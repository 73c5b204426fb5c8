namespace FastPoints.Preview
{
    /// <summary>A beginning of a sample that was there to be drawn before the rest.</summary>
    public struct SampleWave
    {
        /// <summary>The sample's first so many points.</summary>
        public int Points;

        /// <summary>From the start of the sampling to the wave's last point.</summary>
        public double Seconds;

        /// <summary>Bytes of the file that were read up to here.</summary>
        public long BytesRead;
    }
}
