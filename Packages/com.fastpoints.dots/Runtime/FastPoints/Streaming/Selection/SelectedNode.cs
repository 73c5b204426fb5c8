namespace FastPoints.Streaming
{
    /// <summary>A node that was chosen: parents before children, the most needed first.</summary>
    public struct SelectedNode
    {
        public int Cloud;
        public int Page;
        public int Node;

        /// <summary>Place of its parent among the chosen; -1 for a root.</summary>
        public int Parent;
    }
}
