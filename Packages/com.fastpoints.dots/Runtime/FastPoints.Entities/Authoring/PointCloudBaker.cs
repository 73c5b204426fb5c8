using FastPoints.Gpu;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Bakers run in a process without a screen: the folder is not opened here.</summary>
    public sealed class PointCloudBaker : Baker<PointCloudAuthoring>
    {
        public override void Bake(PointCloudAuthoring authoring)
        {
            var entity = GetEntity(TransformUsageFlags.Dynamic);
            var cloud = DependsOn(authoring.Cloud);
            var file = cloud != null ? cloud.File() : new PointCloudFile { Path = authoring.Path };
            file.Color = authoring.Color;
            file.Gradient = authoring.Gradient;
            file.HiddenClasses = ClassMask.Of(authoring.HiddenClasses);
            AddComponentObject(entity, file);
        }
    }
}
