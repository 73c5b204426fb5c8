using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>A converted cloud in a subscene: what is baked is where the cloud lies, and nothing of its points.</summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("FastPoints/Point Cloud Authoring")]
    public sealed class PointCloudAuthoring : MonoBehaviour
    {
        [Tooltip("The .fastpoints folder: absolute, or below StreamingAssets.")]
        public string Path;
    }
}
