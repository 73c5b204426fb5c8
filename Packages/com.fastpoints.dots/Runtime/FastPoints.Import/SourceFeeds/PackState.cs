namespace FastPoints.SourceFeeds
{
    /// <summary>How far the packing of a node is, from slice to slice.</summary>
    public struct PackState
    {
        /// <summary>The source did not give the node's points, or one lies where no packed number reaches.</summary>
        public bool IsDamaged;

        /// <summary>Byte at which the plane that is written begins.</summary>
        public long PlaneStart;

        /// <summary>Of that plane, where the next packed words go.</summary>
        public long Word;
    }
}
