namespace FastPoints.Scenes
{
    /// <summary>One return of one laser pulse, as LAS point format 7 keeps it.</summary>
    internal struct ScanReturn
    {
        public const double Step = 0.001; // Metres of one grid step.
        public double GpsTime; // Adjusted standard GPS seconds: rising from pulse to pulse, the same for all returns of one.
        public int X; // In grid steps.
        public int Y;
        public int Z;

        public ushort Intensity;
        public ushort Red;
        public ushort Green;
        public ushort Blue;
        public short ScanAngle; // Steps of 0.006 degrees from the horizon, as point formats 6 to 10 have it.

        public ushort Station;
        public byte ReturnNumber;
        public byte NumberOfReturns;
        public byte Classification;
    }
}
