using FastPoints.Picture;

namespace FastPoints.Draw
{
    /// <summary>What <see cref="PreviewCloud"/> should take and show.</summary>
    public sealed class PreviewOptions
    {
        /// <summary>Points of the sample.</summary>
        public int Points = 1_000_000;

        public uint Seed = 1;

        /// <summary>Choose from a scan of all points, not from short runs.</summary>
        public bool Exact;

        /// <summary>Stop at the sample that reads little, also where it is of the beginnings of blocks alone, or of
        /// the file's.</summary>
        public bool Quick;

        public PictureOptions Picture = new PictureOptions();
    }
}
