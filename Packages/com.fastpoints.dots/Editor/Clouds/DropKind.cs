namespace FastPoints.Editor
{
    /// <summary>What becomes of files that are dropped.</summary>
    public enum DropKind
    {
        /// <summary>Others decide: there is something else among them.</summary>
        NotOurs,
        /// <summary>Point clouds that are small enough to be copied into the project and imported there.</summary>
        Copy,
        /// <summary>They stay where they are, and each gets a handle.</summary>
        Handle,
    }
}
