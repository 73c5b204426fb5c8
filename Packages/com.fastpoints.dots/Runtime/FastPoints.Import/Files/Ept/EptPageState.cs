namespace FastPoints.Files
{
    /// <summary>How far a hierarchy page has been parsed, from slice to slice.</summary>
    public struct EptPageState
    {
        /// <summary>The next byte.</summary>
        public int At;

        /// <summary>Entries so far, those without a key among them.</summary>
        public int Entries;

        public bool IsDone;

        /// <summary>Whether the text is no such page at <see cref="At"/>; entries before it stand.</summary>
        public bool IsBroken;
    }
}
