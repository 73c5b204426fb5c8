namespace FastPoints.Picture
{
    /// <summary>Standard views; x is east, y north and z up for a cloud whose up axis is Z.</summary>
    public enum ViewDirection
    {
        /// <summary>What shows most of the cloud: <see cref="Iso"/>, or <see cref="Front"/> for one that is a wall.</summary>
        Auto,
        /// <summary>Orthographic, from above, north at the top.</summary>
        Top,
        /// <summary>Orthographic, from the south.</summary>
        Front,
        /// <summary>Perspective, from the south-east and above.</summary>
        Iso,
    }
}
