using FastPoints.Entities;
using UnityEngine;

namespace FastPoints.Samples.ManyClouds
{
    /// <summary>Many clouds, each with a transform of its own: rotated, scaled, moving. All share one point budget and one memory
    /// pool, so that a frame costs what is seen, not what exists.</summary>
    [AddComponentMenu("FastPoints/Samples/Cloud Grid")]
    public sealed class CloudGrid : MonoBehaviour
    {
        public PointCloudAsset Cloud;

        [Range(1, 32)]
        [Tooltip("Clouds along each side.")]
        public int Side = 8;

        [Min(1)]
        [Tooltip("From one cloud to the next, in metres.")]
        public float Distance = 120;

        [Tooltip("Every third cloud turns this far, in degrees a second.")]
        public float Turn = 6;

        Transform[] m_clouds = new Transform[0];
        float m_angle;

        void OnEnable()
        {
            m_clouds = new Transform[Side * Side];
            for (int i = 0; i < m_clouds.Length; i++)
            {
                var cloud = new GameObject("Cloud " + i).AddComponent<PointCloud>();
                cloud.transform.SetParent(transform, false);
                Place(cloud.transform, i, 0);
                cloud.transform.localScale = Vector3.one * (0.15f + 0.05f * (i % 4));
                cloud.Cloud = Cloud;
                m_clouds[i] = cloud.transform;
            }
        }

        void OnDisable()
        {
            foreach (var cloud in m_clouds)
                if (cloud != null)
                    Destroy(cloud.gameObject);
        }

        void Update()
        {
            m_angle += Turn * Time.deltaTime;
            for (int i = 0; i < m_clouds.Length; i += 3)
                Place(m_clouds[i], i, m_angle);
        }

        void Place(Transform cloud, int number, float degrees)
        {
            float half = (Side - 1) / 2f;
            var position = new Vector3(number % Side - half, 0, number / Side - half) * Distance;
            cloud.SetPositionAndRotation(transform.position + position, Quaternion.Euler(0, number * 37 + degrees, 0));
        }
    }
}
