namespace FastPoints.Editor
{
    /// <summary>What points may be drawn with beside their style.</summary>
    public struct DrawnOptions
    {
        /// <summary>Clip boxes.</summary>
        public bool Clipped;

        /// <summary>Hidden classes.</summary>
        public bool Filtered;

        /// <summary>Both eyes of a headset at once.</summary>
        public bool Stereo;
    }
}
