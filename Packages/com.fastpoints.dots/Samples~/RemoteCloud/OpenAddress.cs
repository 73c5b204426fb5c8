using System;
using System.Globalization;
using System.IO;
using FastPoints.Entities;
using Unity.Entities;
using UnityEngine;

namespace FastPoints.Samples.RemoteCloud
{
    /// <summary>Shows the cloud of an address, which is set here or typed in play mode, and moves the camera to see all of it.
    /// What has come stays on disk.</summary>
    [RequireComponent(typeof(PointCloud))]
    [AddComponentMenu("FastPoints/Samples/Open Address")]
    public sealed class OpenAddress : MonoBehaviour
    {
        [Tooltip("https://, or http:// of this machine: a converted cloud, COPC, EPT, Potree, or a LAS, LAZ or PLY file.")]
        public string Address = "";

        [Min(0)]
        [Tooltip("What is kept on disk at most; 0 keeps nothing.")]
        public int CacheMegabytes = 1024;

        bool m_isSeen;

        /// <summary>One line for the user: what is there, or what went wrong.</summary>
        public string Status
        {
            get
            {
                var cloud = GetComponent<PointCloud>();
                if (cloud.Error != null || string.IsNullOrEmpty(cloud.Path))
                    return cloud.Error ?? "";
                if (!cloud.TryGetSpace(out _))
                    return "opening";
                var world = PointCloudSystemGroup.ObjectWorld ?? World.DefaultGameObjectInjectionWorld;
                var stats = world.GetExistingSystemManaged<PointCloudSystemGroup>().Stats;
                return string.Format(CultureInfo.InvariantCulture, "{0:N0} of {1:N0} points{2}", stats.DrawnPoints,
                    stats.SelectedPoints, stats.IsSettled ? "" : ", more on their way");
            }
        }

        /// <summary>Opens the address, or tries it again.</summary>
        public void Open()
        {
            m_isSeen = false;
            var cloud = GetComponent<PointCloud>();
            string address = Address.Trim();
            if (cloud.Path == address)
                cloud.Reopen();
            cloud.Path = address;
        }

        void OnEnable()
        {
            RemoteAccess.CacheFolder = Path.Combine(Application.temporaryCachePath, "clouds");
            RemoteAccess.CacheBytes = (long)CacheMegabytes << 20;
            Open();
        }

        void Update()
        {
            if (m_isSeen || !GetComponent<PointCloud>().TryGetWorldBounds(out var bounds))
                return;
            m_isSeen = true;
            float radius = bounds.size.magnitude / 2;
            var camera = Camera.main;
            camera.farClipPlane = Math.Max(camera.farClipPlane, 4 * radius);
            // With Unity's 60 degrees a sphere fills the picture at twice its radius.
            var forward = new Vector3(0, -0.6f, 0.8f);
            camera.transform.SetPositionAndRotation(bounds.center - 2 * radius * forward, Quaternion.LookRotation(forward));
        }

        void OnGUI()
        {
            Address = GUILayout.TextField(Address);
            if (GUILayout.Button("Open"))
                Open();
            GUILayout.Label(Status);
        }
    }
}
