namespace FastPoints.Files
{
    /// <summary>The errors that jobs report for a binary section; 0 means none.</summary>
    static class E57Error
    {
        public const int None = 0;
        public const int SectionEnds = 1;
        public const int PacketKind = 2;
        public const int PacketLength = 3;
        public const int StreamCount = 4;
        public const int StreamLengths = 5;
        public const int Restart = 6;
        public const int FileChanged = 7;
        public const int TooWide = 8;

        public static string Text(int error)
        {
            switch (error)
            {
                case SectionEnds:
                    return "the section ends";
                case PacketKind:
                    return "a packet of unknown kind (not 0, 1 or 2)";
                case PacketLength:
                    return "a packet's length is no multiple of 4, shorter than its header, or leaves the section";
                case StreamCount:
                    return "a packet does not have a bytestream for each field";
                case StreamLengths:
                    return "a packet's bytestreams are longer than it is, or do not fill it";
                case Restart:
                    return "a packet restarts its bytestreams within a value";
                case TooWide:
                    return "the fields of its points lie too far apart";
                default:
                    return "its packets are not what they were when the file was opened";
            }
        }
    }
}
