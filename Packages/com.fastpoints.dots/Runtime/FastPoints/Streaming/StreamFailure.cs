using System.Globalization;

namespace FastPoints.Streaming
{
    /// <summary>Something that could not be shown, after all tries.</summary>
    public readonly struct StreamFailure
    {
        public readonly string Path;

        /// <summary>Byte in the file; -1 where the whole of it is meant.</summary>
        public readonly long OffsetBytes;
        public readonly string What;

        public StreamFailure(string path, long offsetBytes, string what)
        {
            Path = path;
            OffsetBytes = offsetBytes;
            What = what;
        }

        public override string ToString() =>
            Path + (OffsetBytes >= 0 ? " at " + OffsetBytes.ToString(CultureInfo.InvariantCulture) : "") + ": " + What;
    }
}
