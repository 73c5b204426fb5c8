namespace FastPoints.Streaming
{
    /// <summary>One cloud as a selection sees it. Blittable, for jobs.</summary>
    public unsafe struct SelectionCloud
    {
        /// <summary>Page 0 and one for each chunk.</summary>
        public HierarchyPage* Pages;

        /// <summary>Its number in what is chosen.</summary>
        public int Cloud;
    }
}
