namespace FastPoints.Laz
{
    /// <summary>Item types of the LASzip VLR: consecutive bytes of a record that are compressed together.</summary>
    internal enum LazItemType : ushort
    {
        Bytes = 0,
        Point10 = 6,
        GpsTime11 = 7,
        Rgb12 = 8,
        WavePacket13 = 9,
        Point14 = 10,
        Rgb14 = 11,
        RgbNir14 = 12,
        WavePacket14 = 13,
        Bytes14 = 14,
    }

    internal struct LazItem
    {
        public LazItemType Type;
        public int Version;
        public int Bytes;
        public int RecordOffset;
        public bool IsLayered => Type >= LazItemType.Point14; // POINT14 and what goes with it.

        // 0 if any number above 0 is valid.
        public static int FixedBytes(LazItemType type) => type switch
        {
            LazItemType.Point10 => 20,
            LazItemType.GpsTime11 => 8,
            LazItemType.Rgb12 or LazItemType.Rgb14 => 6,
            LazItemType.WavePacket13 or LazItemType.WavePacket14 => 29,
            LazItemType.Point14 => 30,
            LazItemType.RgbNir14 => 8,
            _ => 0,
        };

        // Versions of compressed items; 0 stands for uncompressed ones.
        public static bool IsVersionKnown(LazItemType type, int version)
        {
            switch (type)
            {
                case LazItemType.Bytes:
                case LazItemType.Point10:
                case LazItemType.GpsTime11:
                case LazItemType.Rgb12:
                    return version == 1 || version == 2;
                case LazItemType.WavePacket13:
                    return version == 1;
                // Version 2 is a prototype's number for what became 3.
                case LazItemType.Point14:
                case LazItemType.Rgb14:
                case LazItemType.RgbNir14:
                case LazItemType.Bytes14:
                    return version >= 2 && version <= 4;
                case LazItemType.WavePacket14:
                    return version == 3 || version == 4;
                default:
                    return false;
            }
        }
    }
}
