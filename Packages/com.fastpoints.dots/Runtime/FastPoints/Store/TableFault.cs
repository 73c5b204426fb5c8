namespace FastPoints.Store
{
    /// <summary>What can be wrong with a file's table of nodes.</summary>
    public enum TableFault : byte
    {
        None,
        /// <summary>The bytes are not those that were written.</summary>
        Hash,
        Roots,
        Orphans,
        PointSum,
        Side,
        OutsideRegion,
        NotOfOctree,
        Parent,
        ParentCube,
        NotAChild,
        Children,
        PointCount,
        BlockCount,
        Bounds,
        Guest,
        FirstBlock,
        GuestBlocks,
        HostedBlocks,
        GuestPlane,
        Plane,
    }
}
