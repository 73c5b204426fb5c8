namespace FastPoints.Picking
{
    /// <summary>A node, or a page that is not loaded, that a ray might hit something in.</summary>
    struct PickCandidate
    {
        /// <summary>In place of <see cref="Node"/>.</summary>
        public const int WholePage = -1;

        /// <summary>Along the ray: no hit in it, or below it, is nearer.</summary>
        public double Distance;
        public int Page;
        public int Node;

        /// <summary>Of the points above it, in CRS units.</summary>
        public double SpacingAbove;

        public readonly bool IsPage => Node == WholePage;

        public readonly bool IsBefore(in PickCandidate other) => Distance != other.Distance ? Distance < other.Distance
            : Page != other.Page ? Page < other.Page : Node < other.Node;
    }
}
