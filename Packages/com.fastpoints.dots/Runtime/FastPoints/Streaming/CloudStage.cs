namespace FastPoints.Streaming
{
    /// <summary>How far a cloud has come that is shown before it is whole.</summary>
    public enum CloudStage
    {
        /// <summary>All of it, thinned.</summary>
        Preview,
        /// <summary>A build in progress: all points of some regions, few of the others.</summary>
        Building,
        /// <summary>All that there is.</summary>
        Whole,
    }
}
