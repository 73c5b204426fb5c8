using FastPoints.Entities;
using UnityEngine;

namespace FastPoints.Samples.StreamingFlight
{
    /// <summary>Flies this GameObject, usually a camera, around in a cloud: an ellipse within its bounds, over its floor, looking
    /// ahead and down.</summary>
    [AddComponentMenu("FastPoints/Samples/Fly Through")]
    public sealed class FlyThrough : MonoBehaviour
    {
        public PointCloud Cloud;

        [Range(1, 600)]
        [Tooltip("Of one round.")]
        public float Seconds = 60;

        [Range(0, 1)]
        [Tooltip("Of the ellipse, as a share of the cloud's width and length.")]
        public float Size = 0.3f;

        [Min(0)]
        [Tooltip("Above the cloud's floor, in metres.")]
        public float Height = 20;

        float m_turns;

        void Update()
        {
            var asset = Cloud != null ? Cloud.Cloud : null;
            // A cloud that is not converted yet has no bounds.
            if (asset == null || !asset.TryGetSpace(out var bounds, out var space))
                return;
            var low = space.FromGeo(bounds.Min);
            var high = space.FromGeo(bounds.Max);
            m_turns += Time.deltaTime / Seconds;
            float angle = m_turns * 2 * Mathf.PI;
            var across = 0.5f * Size * new Vector3((float)(high.x - low.x), 0, (float)(high.z - low.z));
            var middle = new Vector3((float)(low.x + high.x) / 2, (float)low.y + Height, (float)(low.z + high.z) / 2);
            var toWorld = Cloud.transform.localToWorldMatrix;
            var position = toWorld.MultiplyPoint3x4(middle + On(across, angle));
            var down = new Vector3(0, Height / 2, 0);
            var limit = toWorld.MultiplyPoint3x4(middle - down + On(across, angle + 0.6f));
            transform.SetPositionAndRotation(position, Quaternion.LookRotation(limit - position));
        }

        static Vector3 On(Vector3 across, float angle) =>
            new Vector3(across.x * Mathf.Cos(angle), 0, across.z * Mathf.Sin(angle));
    }
}
