namespace FastPoints.Gpu
{
    /// <summary>What a point's colour is taken from.</summary>
    public enum ColorSource : uint
    {
        /// <summary>Three columns are red, green and blue.</summary>
        Channels,

        /// <summary>One column, looked up in the palette.</summary>
        Attribute,

        /// <summary>The same, with entries of the palette used again and again.</summary>
        Wrapped,

        /// <summary>The place, looked up in the palette.</summary>
        Place,
    }
}
