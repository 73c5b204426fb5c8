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

        /// <summary>A disc that bulges towards the camera: points share a pixel by which of them is nearer to its centre, which keeps
        /// detail that overlapping discs hide. The fragment's own depth costs the card its early test.</summary>
        Paraboloid,
    }
}
