namespace FastPoints.Streaming
{
    /// <summary>What changes about a node: the only place where it is kept.</summary>
    public struct NodeState
    {
        public const int NoSlot = -1;
        public const int IsHole = int.MaxValue;

        /// <summary>Frame of the last selection that chose the node.</summary>
        public uint SelectedFrame;

        /// <summary>Frame of the last selection that had it in view, with its parent chosen.</summary>
        public uint SeenFrame;

        /// <summary>Its place in the cache, or <see cref="NoSlot"/>.</summary>
        public int Slot;

        /// <summary>Times that its bytes were damaged, or <see cref="IsHole"/>: it is not asked for any more.</summary>
        public int Failures;

        /// <summary>Of a node that is made: whether it was, so that its length is known.</summary>
        public bool WasMade;
    }
}
