using FastPoints.Entities;
using FastPoints.Rendering;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Samples.Dissolve
{
    /// <summary>Lets a cloud blow away: takes the points that are shown, hides the cloud, and draws them as particles. The points
    /// stay in graphics memory meanwhile; a shader moves them by time alone.</summary>
    [RequireComponent(typeof(PointCloud))]
    [AddComponentMenu("FastPoints/Samples/Dissolve Cloud")]
    public sealed class DissolveCloud : MonoBehaviour
    {
        static readonly int s_dissolve = Shader.PropertyToID("_Dissolve");
        static readonly int s_height = Shader.PropertyToID("_DissolveHeight");

        [Tooltip("Draws the particles: Dissolve.shader of this sample.")]
        public Shader Shader;

        [Range(1, PointCloudBuffers.MaxPointsLimit)]
        [Tooltip("Of more points an even share flies. 16 bytes each.")]
        public int MaxParticles = 1_000_000;

        [Range(0.5f, 60)]
        public float Seconds = 8;

        [Min(0)]
        [Tooltip("How far particles fly, in world units.")]
        public float Distance = 15;

        [Min(0)]
        [Tooltip("Radius of a particle, in world units.")]
        public float Radius = 0.08f;

        PointCloudBuffers m_points;
        MaterialPropertyBlock m_properties;
        Material m_material;
        Bounds m_bounds;

        /// <summary>From 0 to 1; less than 0 while the cloud is shown.</summary>
        public float Progress { get; private set; } = -1;

        /// <returns>False while the cloud is not shown.</returns>
        public bool Begin()
        {
            var cloud = GetComponent<PointCloud>();
            m_points ??= new PointCloudBuffers(MaxParticles);
            if (!cloud.TryGetWorldBounds(out m_bounds) ||
                !m_points.Update(cloud.Number, new double3(m_bounds.center.x, m_bounds.center.y, m_bounds.center.z)))
                return false;
            cloud.enabled = false;
            Progress = 0;
            return true;
        }

        /// <summary>Shows the cloud again.</summary>
        public void End()
        {
            Progress = -1;
            GetComponent<PointCloud>().enabled = true;
        }

        void Update()
        {
            if (Progress < 0)
                return;
            Progress = math.min(1, Progress + Time.deltaTime / Seconds);
            Draw();
        }

        void Draw()
        {
            if (m_material == null)
                m_material = new Material(Shader);
            m_properties ??= new MaterialPropertyBlock();
            m_points.Bind(m_properties);
            float height = math.max(1e-3f, m_bounds.size.y);
            m_properties.SetVector(s_dissolve, new Vector4(Progress, Distance, Radius, 0));
            m_properties.SetVector(s_height, new Vector4(m_bounds.center.y - height / 2, 1 / height, 0, 0));
            var size = m_bounds.size + 4 * Distance * new Vector3(1, 1, 1);
            var drawing = new RenderParams(m_material)
            {
                matProps = m_properties,
                worldBounds = new Bounds(m_bounds.center, size),
            };
            if (m_points.Count > 0)
                Graphics.RenderPrimitives(drawing, MeshTopology.Triangles, 3 * m_points.Count);
        }

        void OnGUI()
        {
            if (GUILayout.Button(Progress < 0 ? "Dissolve" : "Show the cloud"))
            {
                if (Progress < 0)
                    Begin();
                else
                    End();
            }
            if (Progress >= 0)
                GUILayout.Label($"{m_points.Count} particles, {m_points.Fraction:P0} of the points that were shown");
        }

        void OnDisable()
        {
            if (Progress >= 0)
                End();
            m_points?.Dispose();
            m_points = null;
            if (m_material != null)
                Destroy(m_material);
            m_material = null;
        }
    }
}
