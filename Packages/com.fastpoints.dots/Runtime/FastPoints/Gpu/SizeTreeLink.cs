namespace FastPoints.Gpu
{
    /// <summary>A drawn node while a <see cref="BuildSizeTreeJob"/> works.</summary>
    public struct SizeTreeLink
    {
        /// <summary>Octants that have nodes of their own.</summary>
        public uint Mask;

        /// <summary>In its parent; -1 where it does not take one of the parent's octants.</summary>
        public int Octant;

        /// <summary>Index of the first of its own children.</summary>
        public int First;
    }
}
