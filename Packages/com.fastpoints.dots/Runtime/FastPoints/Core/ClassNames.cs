namespace FastPoints
{
    /// <summary>The names of <see cref="AttributeNames.Classification"/> numbers: ASPRS, LAS 1.4 R15, table 17.</summary>
    internal static class ClassNames
    {
        static readonly string[] s_names =
        {
            "never classified", "unclassified", "ground", "low vegetation", "medium vegetation", "high vegetation", "building",
            "low point (noise)", null, "water", "rail", "road surface", null, "wire, guard", "wire, conductor",
            "transmission tower", "wire-structure connector", "bridge deck", "high noise", "overhead structure",
            "ignored ground", "snow", "temporal exclusion",
        };

        public const int FirstUserDefined = 64;

        // Null for numbers that are reserved or defined by the user.
        public static string Of(int classification) =>
            classification >= 0 && classification < s_names.Length ? s_names[classification] : null;
    }
}
