using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>The cubes that divide a cloud among its nodes: each level halves those above. CRS units from the root's
    /// corner.</summary>
    public unsafe struct NodeCubes
    {
        /// <summary>Corner of the cube of level 0.</summary>
        public double3 Corner;
        public double3 Size;

        /// <summary>Step of the grid if NodeAddress.Corner is the cube's; else 0, and the middle of a node's box is in its
        /// cube.</summary>
        public double3 Step;

        /// <summary>Some position in a node's cube.</summary>
        public double3 PositionInCube(HierarchyPage* page, int node)
        {
            var corner = page->Addresses[node].Corner;
            return Step.x > 0 ? (new double3(corner.X, corner.Y, corner.Z) + 0.5) * Step : page->Nodes[node].Center;
        }

        public double3 SizeAt(int level) => Size * math.pow(0.5, level);

        /// <summary>The index of the cube of a level that contains a position, counted from the corner.</summary>
        public double3 IndexAt(double3 position, int level) => math.floor((position - Corner) / SizeAt(level));

        /// <summary>The corner of that cube.</summary>
        public double3 CornerAt(double3 position, int level) => Corner + IndexAt(position, level) * SizeAt(level);
    }
}
