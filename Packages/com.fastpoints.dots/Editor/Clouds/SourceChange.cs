namespace FastPoints.Editor
{
    /// <summary>What became of a cloud's source since it was converted.</summary>
    public enum SourceChange
    {
        /// <summary>Its bytes are the same, as far as is looked; its time may be another.</summary>
        None,
        Changed,
        /// <summary>A file of it is not there, or cannot be read.</summary>
        Missing,
    }
}
