namespace FastPoints
{
    /// <summary>Something in the input that is not as it should be, although the points can still be read.</summary>
    public readonly struct CloudWarning
    {
        public readonly string Path;

        /// <summary>Byte offset in the file, or -1.</summary>
        public readonly long ByteOffset;

        /// <summary>What is odd and what was assumed instead: one line without the path.</summary>
        public readonly string Text;

        public CloudWarning(string path, long byteOffset, string text) =>
            (Path, ByteOffset, Text) = (SourcePath.WithoutQuery(path), byteOffset, text);

        public override string ToString() =>
            ByteOffset < 0 ? Path + ": " + Text : Path + ": at byte " + NumberText.Of(ByteOffset) + ": " + Text;
    }
}
