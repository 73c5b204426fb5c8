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

        /// <summary>A disc that bulges towards the camera: points share a pixel by which of them is nearer to its centre, which
        /// keeps detail that overlapping discs hide. The fragment's own depth costs the card its early test.</summary>
        Paraboloid,

        /// <summary>A disc that is blended with those that lie at most its diameter behind it, with weights that fall towards the
        /// rim: the smoothest, and without the noise of points that overlap by chance. Points are drawn twice, into a layer of 32
        /// bytes a pixel.</summary>
        Splat,
    }
}
