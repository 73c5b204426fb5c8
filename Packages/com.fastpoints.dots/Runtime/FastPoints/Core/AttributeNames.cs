namespace FastPoints
{
    /// <summary>Names of attributes that mean the same in every format: LAS 1.4's, else the file's.</summary>
    public static class AttributeNames
    {
        /// <summary>Position in the file's own numbers: grid units (int) in LAS, CRS units (float, double) in PLY.</summary>
        public const string X = "X";
        public const string Y = "Y";
        public const string Z = "Z";
        public const string Intensity = "Intensity";
        public const string ReturnNumber = "ReturnNumber";
        public const string NumberOfReturns = "NumberOfReturns";
        public const string ScanDirectionFlag = "ScanDirectionFlag";
        public const string EdgeOfFlightLine = "EdgeOfFlightLine";
        public const string Classification = "Classification";
        public const string Synthetic = "Synthetic";
        public const string KeyPoint = "KeyPoint";
        public const string Withheld = "Withheld";
        public const string Overlap = "Overlap";
        public const string ScannerChannel = "ScannerChannel";
        /// <summary>Whole degrees (int8) in point formats 0 to 5, steps of 0.006 degrees (int16) in 6 to 10;
        /// degrees (float) in EPT.</summary>
        public const string ScanAngle = "ScanAngle";
        public const string UserData = "UserData";
        public const string PointSourceId = "PointSourceId";
        public const string GpsTime = "GpsTime";
        public const string Red = "Red";
        public const string Green = "Green";
        public const string Blue = "Blue";
        public const string Alpha = "Alpha";
        public const string NearInfrared = "NearInfrared";
        public const string NormalX = "NormalX";
        public const string NormalY = "NormalY";
        public const string NormalZ = "NormalZ";
        public const string WavePacketDescriptorIndex = "WavePacketDescriptorIndex";
        public const string ByteOffsetToWaveformData = "ByteOffsetToWaveformData";
        public const string WaveformPacketSize = "WaveformPacketSize";
        public const string ReturnPointWaveformLocation = "ReturnPointWaveformLocation";
        /// <summary>Parametric dx, dy, dz of the waveform: anchor point plus t times these.</summary>
        public const string ParametricDx = "ParametricDx";
        public const string ParametricDy = "ParametricDy";
        public const string ParametricDz = "ParametricDz";

        // -1 for an attribute that is no coordinate.
        internal static int AxisOf(string name) => name == X ? 0 : name == Y ? 1 : name == Z ? 2 : -1;

        internal static bool IsColor(string name) => name == Red || name == Green || name == Blue || name == Alpha ||
            name == NearInfrared;
    }
}
