using FastPoints.Store;

namespace FastPoints.Streaming
{
    /// <summary>One plane of one node on its way into the pool.</summary>
    public unsafe struct UploadPart
    {
        public byte* From;
        public byte* To;
        public long LengthBytes;

        /// <summary>Of the bytes as they were written; not looked at where they were made just now.</summary>
        public ulong Hash;
        public bool IsMade;
        public PlaneShape Shape;
        public int BlockCount;

        /// <summary>Which of the frame's uploads it belongs to.</summary>
        public int Upload;
    }
}
