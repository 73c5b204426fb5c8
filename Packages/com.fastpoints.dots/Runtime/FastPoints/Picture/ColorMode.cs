namespace FastPoints.Picture
{
    /// <summary>What the colour of a point says.</summary>
    public enum ColorMode
    {
        /// <summary>RGB where it is there and not black, else intensity where it varies, else elevation.</summary>
        Auto,
        /// <summary>The point's own colour: its sRGB values as they are, the upper eight of sixteen bits.</summary>
        Rgb,
        /// <summary>Height along the up axis, on a ramp even to the eye.</summary>
        Elevation,
        /// <summary>Grey; light in proportion to the stored intensity.</summary>
        Intensity,
        /// <summary>One colour for each class.</summary>
        Classification,
        /// <summary>One colour for each number: the first return, the second and so on. Of converted clouds.</summary>
        ReturnNumber,
        /// <summary>One colour for each flight line or scanner: 256, used again and again. Of converted clouds.</summary>
        PointSource,
    }

    /// <summary>How a cloud's colour values are to be read: decided once, from all of a sample.</summary>
    public enum ColorDepth
    {
        /// <summary>No colour, or nothing but black.</summary>
        None,
        /// <summary>0 to 255, whatever the type.</summary>
        Bits8,
        /// <summary>0 to 65,535.</summary>
        Bits16,
        /// <summary>0 to 1.</summary>
        Unit,
    }
}
