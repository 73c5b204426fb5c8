namespace FastPoints.Editor
{
    /// <summary>Which variants of the package's shaders go into players.</summary>
    public enum VariantChoice
    {
        /// <summary>Those that the built scenes need; all where scripts, asset bundles or Addressables may need others.</summary>
        Automatic,

        /// <summary>Those that the built scenes need, whatever scripts may ask for.</summary>
        BuiltScenes,

        All,
    }
}
