namespace FastPoints.Files
{
    /// <summary>How one <see cref="LasFieldCopy"/> moves values. Sizes in bytes.</summary>
    public enum LasCopyKind : byte
    {
        /// <summary>Some bits of one byte.</summary>
        Bits,
        One,
        Two,
        Four,
        Eight,
        /// <summary>Three neighbouring values (R, G, B; X, Y, Z) into three columns in one pass over the records.</summary>
        ThreeOfTwo,
        ThreeOfFour,
        /// <summary>X, Y, Z and R, G, B, six columns in one pass: what most scenes want, faster than in two.</summary>
        PositionAndColor,
    }
}
