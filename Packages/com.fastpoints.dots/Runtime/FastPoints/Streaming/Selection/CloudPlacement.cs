using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>Where a cloud stands: world = Linear * local + OriginWorld, in double, where local is in CRS units from the
    /// corner of the root cube. Any affine transform is allowed.</summary>
    public struct CloudPlacement
    {
        public double3x3 Linear;
        public double3 OriginWorld;
        internal CloudVisibility Visibility;

        public CloudPlacement(double3x3 linear, double3 originWorld)
        {
            Linear = linear;
            OriginWorld = originWorld;
            Visibility = default;
        }

        /// <summary>The placement whose world is the cloud's own georeferenced space.</summary>
        public static CloudPlacement Geo(CloudGrid grid, GridCube root) =>
            new CloudPlacement(double3x3.identity, grid.ToGeo(root.Corner));

        /// <summary>Converts this placement of one version of a cloud to that of another version.</summary>
        public CloudPlacement ForVersion(NodeSource here, NodeSource other) => new CloudPlacement(Linear, OriginWorld +
            math.mul(Linear, other.Grid.ToGeo(other.Root.Corner) - here.Grid.ToGeo(here.Root.Corner)))
        {
            Visibility = Visibility,
        };

        /// <summary>Whether it has a volume: a cloud that is flattened to nothing is not shown.</summary>
        public bool IsValid
        {
            get
            {
                double volume = math.determinant(Linear);
                return math.all(math.isfinite(OriginWorld)) && volume - volume == 0 && volume != 0;
            }
        }
    }

    internal struct CloudVisibility
    {
        public uint Layer; // A bit; 0 for one that no culling mask hides.
        public ulong Scenes; // The editor's scene culling mask; 0 for any scene.
        public bool IsHiddenInSceneViews; // By the eye in the editor's hierarchy.

        public bool IsHidden;
    }

    internal struct ViewMask
    {
        public uint HiddenLayers; // A bit for each layer that the camera's culling mask has not.
        public ulong Scenes;

        public bool IsSceneView;

        public readonly bool Shows(in CloudVisibility cloud) => !cloud.IsHidden && (cloud.Layer & HiddenLayers) == 0 &&
            (Scenes == 0 || cloud.Scenes == 0 || (Scenes & cloud.Scenes) != 0) && !(IsSceneView && cloud.IsHiddenInSceneViews);
    }
}
