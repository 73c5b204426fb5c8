using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>One step of <see cref="PointCloudSystemGroup"/>.</summary>
    internal abstract partial class StreamSystem : SystemBase
    {
        protected PointCloudSystemGroup Group { get; private set; }

        protected override void OnCreate()
        {
            base.OnCreate();
            Group = World.GetOrCreateSystemManaged<PointCloudSystemGroup>();
        }
    }
}
