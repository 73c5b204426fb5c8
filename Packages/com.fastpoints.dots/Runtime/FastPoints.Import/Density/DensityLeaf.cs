using Unity.Mathematics;

namespace FastPoints.Density
{
    /// <summary>A cell of a <see cref="DensityEstimate"/> that is not divided any more.</summary>
    public readonly struct DensityLeaf
    {
        /// <summary>Lowest corner, georeferenced, in CRS units.</summary>
        public readonly double3 Min;

        /// <summary>In CRS units.</summary>
        public readonly double Edge;

        public readonly DensityCell Cell;

        public DensityLeaf(double3 min, double edge, DensityCell cell)
        {
            Min = min;
            Edge = edge;
            Cell = cell;
        }
    }
}
