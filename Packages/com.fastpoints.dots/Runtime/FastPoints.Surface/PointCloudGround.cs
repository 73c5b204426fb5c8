#if FASTPOINTS_DOTS_PHYSICS
using FastPoints.Drawing;
using Unity.Entities;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>Ground and walls of a converted cloud for com.unity.physics, near entities with <see cref="Followed"/>: beside the
    /// <see cref="FastPoints.Entities.PointCloudFile"/> of a cloud's entity, whose bodies come and go as the colliders of
    /// PointCloudCollider do. Begin with <see cref="Default"/>.</summary>
    public struct PointCloudGround : IComponentData
    {
        /// <summary>What moves, with a LocalToWorld: there are bodies around it, and nowhere else.</summary>
        public struct Followed : IComponentData { }

        public float Radius;
        public float VoxelSize;
        public float HoleSize;
        public ClassMask HiddenClasses;
        public int MaxCells;
        public int MaxTriangles;
        public int CacheMegabytes;

        /// <summary>Time of the main thread in each step of physics, in ms, while cells are made.</summary>
        public float StepMs;

        public static PointCloudGround Default => new PointCloudGround
        {
            Radius = 10,
            VoxelSize = 0.1f,
            HoleSize = 0.3f,
            MaxCells = 256,
            MaxTriangles = 1_000_000,
            CacheMegabytes = 256,
            StepMs = 0.5f,
        };

        /// <summary>Whether the cells of a cloud around a position of the world are made, with ground in them or
        /// without.</summary>
        public static bool IsReady(World world, Entity cloud, float3 position, float reach = 2) =>
            world.GetExistingSystemManaged<MakeGroundSystem>()?.IsReady(cloud, position, reach) == true;
    }
}
#endif
