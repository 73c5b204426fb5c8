namespace FastPoints.E57
{
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

        public static string Text(int error) => error switch
        {
            SectionEnds => "the section ends",
            PacketKind => "a packet of unknown kind (not 0, 1 or 2)",
            PacketLength => "a packet's length is no multiple of 4, shorter than its header, or leaves the section",
            StreamCount => "a packet does not have a bytestream for each field",
            StreamLengths => "a packet's bytestreams are longer than it is, or do not fill it",
            Restart => "a packet restarts its bytestreams within a value",
            TooWide => "the fields of its points lie too far apart",
            _ => "its packets are not what they were when the file was opened",
        };
    }
}
