using System.Runtime.CompilerServices;

namespace FastPoints.Streaming
{
    /// <summary>A node that can be chosen next, or a page whose nodes are not known yet.</summary>
    public struct SelectionCandidate
    {
        /// <summary>On the screen, of the points above: the gaps that the node would fill.</summary>
        public float SpacingPx;
        public int Cloud;
        public int Page;

        /// <summary>-1 for the page itself.</summary>
        public int Node;
        public int Parent;

        /// <summary>Widest gaps first. Ties by place, so that a choice can be repeated.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool IsBefore(in SelectionCandidate other)
        {
            if (SpacingPx != other.SpacingPx)
                return SpacingPx > other.SpacingPx;
            if (Cloud != other.Cloud)
                return Cloud < other.Cloud;
            return Page != other.Page ? Page < other.Page : Node < other.Node;
        }
    }
}
