namespace FastPoints.Files
{
    /// <summary>How an EPT octree keeps the points of a node, each in a file of its own.</summary>
    public enum EptDataType
    {
        /// <summary>Records as the schema says, one behind the other (<c>.bin</c>).</summary>
        Binary,

        /// <summary>The same in a zstandard frame (<c>.zst</c>).</summary>
        Zstandard,

        /// <summary>A whole LAZ file (<c>.laz</c>).</summary>
        Laszip,
    }
}
