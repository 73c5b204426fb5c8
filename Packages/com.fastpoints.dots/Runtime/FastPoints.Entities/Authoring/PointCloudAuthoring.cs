using FastPoints.Drawing;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>A converted cloud in a subscene: baking stores where the cloud lies, and none of its points.</summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("FastPoints/Point Cloud Authoring")]
    [HelpPage("show")]
    [Icon("Packages/com.fastpoints.dots/Editor/Icons/PointCloud.png")]
    public sealed class PointCloudAuthoring : MonoBehaviour
    {
        [Tooltip("The cloud: what the editor makes of a file that is dropped into the project.")]
        public PointCloudAsset Cloud;

        [Tooltip("Without a cloud above, the .fastpoints folder: absolute, below StreamingAssets, or a web server's address.")]
        public string Path;

        [Tooltip("What points are coloured by; another where the cloud has nothing for it.")]
        public ColorMode Color = ColorMode.Auto;

        [Tooltip("Of elevation and intensity.")]
        public ColorRamp ColorRamp = ColorRamp.Auto;

        [Tooltip("Classes, 0 to 255, whose points are not drawn.")]
        public int[] HiddenClasses = new int[0];

        [Range(0, 1)]
        [Tooltip(PointCloud.LightTip)]
        public float Light;
    }

    /// <summary>Does not open the folder: bakers run in a process without a screen.</summary>
    internal sealed class PointCloudBaker : Baker<PointCloudAuthoring>
    {
        public override void Bake(PointCloudAuthoring authoring)
        {
            var entity = GetEntity(TransformUsageFlags.Dynamic);
            var cloud = DependsOn(authoring.Cloud);
            var file = cloud != null ? cloud.File() : new PointCloudFile();
            var paths = cloud != null ? cloud.Paths : new PointCloudPaths { Path = authoring.Path };
            file.Color = authoring.Color;
            file.ColorRamp = authoring.ColorRamp;
            file.HiddenClasses = ClassMask.Of(authoring.HiddenClasses);
            file.Light = authoring.Light;
            if (TryGetPosition(out var position))
                (file.HasOrigin, file.OriginGeo) = (true, position);
            AddComponent(entity, file);
            // Players find nothing there, and nobody needs to know a developer's folders.
            if (!IsBakingForEditor())
                (paths.ProjectPath, paths.ProjectSources) = ("", new string[0]);
            paths.WriteTo(AddBuffer<PointCloudPathByte>(entity));
            AddComponent(entity, new PointCloudLayer { Value = GetLayer() });
        }

        /// <summary>The place of an origin above. Until it has one, the first cloud beneath it decides, as in scenes.</summary>
        bool TryGetPosition(out double3 position)
        {
            var origin = GetComponentInParent<PointCloudOrigin>();
            bool exists = origin != null && origin.enabled;
            position = exists ? origin.PositionGeo : default;
            if (!exists || origin.HasPosition)
                return exists;
            foreach (var other in GetComponentsInChildren<PointCloudAuthoring>(origin))
                if (other.Cloud != null && DependsOn(other.Cloud).TryGetSpace(out _, out var space))
                {
                    position = space.OriginGeo;
                    return true;
                }
            return false;
        }
    }
}
