using FastPoints.Store;

namespace FastPoints.Streaming
{
    /// <summary>One plane of one node on its way into the pool.</summary>
    public unsafe struct UploadPart
    {
        public byte* From;
        public byte* To;
        public long LengthBytes;
        public ulong Hash;
        public PlaneShape Shape;
        public int BlockCount;

        /// <summary>Which of the frame's uploads it belongs to.</summary>
        public int Upload;
    }
}
