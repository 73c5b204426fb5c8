namespace FastPoints.Gpu
{
    /// <summary>How large points are drawn.</summary>
    public enum PointSizeMode
    {
        /// <summary>So many pixels, near and far.</summary>
        Pixels,

        /// <summary>A length in the world: smaller farther away.</summary>
        World,

        /// <summary>As far apart as points are at that place, of all that is drawn there: surfaces close, detail stays.</summary>
        Adaptive,
    }
}
