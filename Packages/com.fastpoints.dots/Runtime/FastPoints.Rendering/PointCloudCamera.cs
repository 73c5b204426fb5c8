using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>Whether its camera draws point clouds. Without it all cameras do, except URP's overlay cameras. Which
    /// clouds a camera draws depends on its culling mask and their layers.</summary>
    [DisallowMultipleComponent]
    [RequireComponent(typeof(Camera))]
    [AddComponentMenu("FastPoints/Point Cloud Camera")]
    [HelpPage("show")]
    [Icon("Packages/com.fastpoints.dots/Editor/Icons/PointCloud.png")]
    public sealed class PointCloudCamera : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Off: this camera draws no clouds. On: it does, as an overlay camera of URP, too.")]
        bool m_drawsClouds = true;

        public bool DrawsClouds
        {
            get => m_drawsClouds;
            set => m_drawsClouds = value;
        }

        // Without it, Unity shows no checkbox to disable the component with.
        void OnEnable()
        {
        }
    }
}
