namespace FastPoints.Rendering
{
    /// <summary>What a point is drawn as.</summary>
    public enum PointShape
    {
        /// <summary>The pixel that it lies in: the fastest where points are dense. By a compute shader where the device has
        /// them.</summary>
        Pixel,

        /// <summary>A square that faces the camera.</summary>
        Square,

        /// <summary>A disc that faces the camera.</summary>
        Disc,
    }
}
