namespace FastPoints.Files
{
    /// <summary>How a Potree attribute's bytes become columns.</summary>
    enum PotreeAttributeKind
    {
        /// <summary>Each element is a column of the attribute's own type.</summary>
        Plain,

        /// <summary>Three int32, relative to the node's or the cloud's corner.</summary>
        Position,

        /// <summary>Red, green, blue of one type, perhaps alpha behind them.</summary>
        Color,

        /// <summary>A unit vector in two bytes, by the sphere map of the Lambert azimuthal equal-area projection.</summary>
        SphereMappedNormal,

        /// <summary>A unit vector in two bytes, folded over an octahedron.</summary>
        OctahedralNormal,
    }
}
