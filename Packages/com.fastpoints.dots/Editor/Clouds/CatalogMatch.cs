namespace FastPoints.Editor
{
    /// <summary>How a handle's cloud was found.</summary>
    public enum CatalogMatch
    {
        /// <summary>Nowhere.</summary>
        None,
        /// <summary>Where the handle says.</summary>
        InPlace,
        /// <summary>In another folder of the project's clouds, by its id.</summary>
        Moved,
        /// <summary>Where the handle says is another cloud, and its own is nowhere.</summary>
        Another,
        /// <summary>Where the handle says it is in the making.</summary>
        Building,
    }
}
