namespace FastPoints.Files
{
    /// <summary>Where a field's values go.</summary>
    enum E57Target
    {
        /// <summary>A column of an integer type: integer * steps + bias.</summary>
        Integers,

        /// <summary>A column of an integer type: round(value * factor + addend), kept within 0 and 65,535.</summary>
        Shares,

        /// <summary>A column of floats or doubles: value * factor + addend.</summary>
        Reals,

        /// <summary>One of the three (or six) rows of doubles that become positions and normals: the same.</summary>
        Vector,

        /// <summary>Nowhere: points whose value is not 0 are left out.</summary>
        Invalid,
    }
}
