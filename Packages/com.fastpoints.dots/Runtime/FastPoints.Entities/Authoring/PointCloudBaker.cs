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
            AddComponentObject(entity, new PointCloudFile
            {
                Path = authoring.Path,
                Color = authoring.Color,
                Gradient = authoring.Gradient,
                HiddenClasses = ClassMask.Of(authoring.HiddenClasses),
            });
        }
    }
}
