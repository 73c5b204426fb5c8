namespace FastPoints.E57
{
    // Header of a packet (ASTM E2807, 9.3 to 9.5): kind, flags, length less one (16 bits); in data packets the number of
    // bytestreams (16 bits), their lengths (16 bits each), then the bytestreams one after the other.
    unsafe struct E57Packet
    {
        public const int DataKind = 1;
        public const int IgnoredKind = 2;
        public const int MinBytes = 4;
        public const int DataHeaderBytes = 6;
        const int RestartFlag = 1;
        const int MaxPaddingBytes = 3;

        public int Kind;
        public bool IsRestart;
        public int Bytes;
        public int HeaderBytes; // In front of the bytestreams; 0 for packets without data.

        // 0 or an E57Error. Sets needsMore if the available bytes may not hold the whole header; toEnd: bytes of the section from
        // p.
        public static int Read(byte* p, long available, long toEnd, int streams, out E57Packet packet, out bool needsMore)
        {
            packet = default;
            needsMore = false;
            if (toEnd < MinBytes)
                return E57Error.SectionEnds;
            int full = DataHeaderBytes + 2 * streams;
            if (available < (full < toEnd ? full : toEnd))
            {
                needsMore = true;
                return E57Error.None;
            }
            packet.Kind = p[0];
            packet.Bytes = (p[2] | p[3] << 8) + 1;
            if (packet.Kind > IgnoredKind)
                return E57Error.PacketKind;
            if ((packet.Bytes & 3) != 0 || packet.Bytes > toEnd)
                return E57Error.PacketLength;
            if (packet.Kind != DataKind)
                return E57Error.None;
            packet.IsRestart = (p[1] & RestartFlag) != 0;
            if (packet.Bytes < DataHeaderBytes)
                return E57Error.PacketLength;
            if ((p[4] | p[5] << 8) != streams)
                return E57Error.StreamCount;
            if (packet.Bytes < full)
                return E57Error.PacketLength;
            packet.HeaderBytes = full;
            long bytes = full;
            for (int i = 0; i < streams; i++)
                bytes += StreamBytes(p, i);
            return bytes > packet.Bytes || bytes + MaxPaddingBytes < packet.Bytes ? E57Error.StreamLengths : E57Error.None;
        }

        public static int StreamBytes(byte* packet, int stream)
        {
            byte* p = packet + DataHeaderBytes + 2 * stream;
            return p[0] | p[1] << 8;
        }
    }

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
