namespace FastPoints.Streaming
{
    /// <summary>Consecutive bytes of a file.</summary>
    public struct FilePiece
    {
        public string Path;
        public long OffsetBytes;
        public long LengthBytes;
    }
}
