namespace FastPoints.Picture
{
    /// <summary>The ramp that amounts are coloured by.</summary>
    public enum Gradient
    {
        /// <summary>Viridis for elevation, grey for intensity.</summary>
        Auto,

        /// <summary>Even to the eye, and to those who do not see all colours.</summary>
        Viridis,

        /// <summary>The rainbow's colours: tells more values apart, less evenly.</summary>
        Turbo,

        /// <summary>Light in proportion to the value.</summary>
        Gray,
    }
}
