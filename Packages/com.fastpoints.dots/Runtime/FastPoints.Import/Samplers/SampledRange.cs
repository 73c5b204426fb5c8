namespace FastPoints.Samplers
{
    /// <summary>The points of one cube, while a sampler works on them: a range of the ordered points. Blittable.</summary>
    public struct SampledRange
    {
        public int First;
        public int End;

        /// <summary>The nearest node above, or -1.</summary>
        public int Parent;

        /// <summary>At first a cube that has the points; then the smallest of the octree that does.</summary>
        public byte SideLog2;

        /// <summary>Edge of the sampling cells: the spacing.</summary>
        public byte CellLog2;

        /// <summary>Points that are taken into the node.</summary>
        public int Count;

        /// <summary>The next range of the same spacing, or -1.</summary>
        public int Next;
    }
}
