namespace FastPoints.Scenes
{
    /// <summary>One return of one laser pulse, as LAS point format 7 keeps it.</summary>
    internal struct ScanReturn
    {
        /// <summary>Metres of one grid step.</summary>
        public const double Step = 0.001;

        /// <summary>Adjusted standard GPS seconds: rising from pulse to pulse, the same for all returns of one.</summary>
        public double GpsTime;

        /// <summary>In grid steps.</summary>
        public int X;
        public int Y;
        public int Z;

        public ushort Intensity;
        public ushort Red;
        public ushort Green;
        public ushort Blue;

        /// <summary>Steps of 0.006 degrees from the horizon, as point formats 6 to 10 have it.</summary>
        public short ScanAngle;

        public ushort Station;
        public byte ReturnNumber;
        public byte NumberOfReturns;
        public byte Classification;
    }
}
