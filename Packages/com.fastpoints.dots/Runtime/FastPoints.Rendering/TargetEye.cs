namespace FastPoints.Rendering
{
    /// <summary>Which slice of a target is drawn into.</summary>
    public enum TargetEye
    {
        /// <summary>The target as it is.</summary>
        Whole,

        /// <summary>The first slice of two.</summary>
        Left,

        /// <summary>The second one.</summary>
        Right,
    }
}
