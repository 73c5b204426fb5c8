using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>A box in the world, turned and sheared as one likes, that clouds are clipped by. Boxes that cut take away what is
    /// in them; of boxes that do not, only what is in one of them is left. Blittable.</summary>
    public struct ClipBox
    {
        public double3 CenterWorld;

        /// <summary>World vectors of the box's three edges. Nothing is in a box without volume.</summary>
        public double3x3 EdgesWorld;
        public bool Cuts;

        public ClipBox(double3 minWorld, double3 maxWorld, bool cuts = false)
        {
            var size = maxWorld - minWorld;
            CenterWorld = (minWorld + maxWorld) / 2;
            EdgesWorld = new double3x3(new double3(size.x, 0, 0), new double3(0, size.y, 0), new double3(0, 0, size.z));
            Cuts = cuts;
        }
    }
}
