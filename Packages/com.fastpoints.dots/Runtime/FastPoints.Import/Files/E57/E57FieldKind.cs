namespace FastPoints.Files
{
    /// <summary>How a field's values lie in its bytestream.</summary>
    enum E57FieldKind
    {
        /// <summary>Bit-packed differences from a minimum.</summary>
        Integer,
        Float32,
        Float64,

        /// <summary>Strings of any length, which are not read.</summary>
        String,
    }
}
