using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>The cubes that a cloud's nodes divide among them: each level halves those of the one above. In CRS units from the
    /// corner of the cloud's root cube. Blittable.</summary>
    public struct NodeCubes
    {
        /// <summary>Of level 0.</summary>
        public double3 Corner;
        public double3 Size;

        public double3 SizeAt(int level) => Size * math.pow(0.5, level);

        /// <summary>Which cube of a level has a place: counted from the corner.</summary>
        public double3 IndexAt(double3 place, int level) => math.floor((place - Corner) / SizeAt(level));

        /// <summary>The corner of that cube.</summary>
        public double3 CornerAt(double3 place, int level) => Corner + IndexAt(place, level) * SizeAt(level);
    }
}
