using FastPoints.Streaming;

namespace FastPoints.Gpu
{
    /// <summary>One cloud as a <see cref="BuildSizeTreeJob"/> sees it. Blittable.</summary>
    public unsafe struct SizeTreeCloud
    {
        public HierarchyPage* Pages;
        public NodeCubes Cubes;

        /// <summary>World units of one CRS unit, along the axis that is stretched most.</summary>
        public float WorldPerUnit;
    }
}
