using Unity.Entities;
using Unity.Transforms;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>A box that all clouds are clipped by: the cube of edge 1 around the GameObject's origin, with the GameObject's
    /// position, rotation and scale.</summary>
    [ExecuteAlways]
    [DisallowMultipleComponent]
    [AddComponentMenu("FastPoints/Point Cloud Clip Box")]
    [HelpPage("show")]
    [Icon("Packages/com.fastpoints.dots/Editor/Icons/PointCloudClipBox.png")]
    public sealed class PointCloudClipBox : MonoBehaviour
    {
        [Tooltip("Takes away what is in the box. Otherwise only what is in it is drawn, or in another such box.")]
        public bool Cuts;

        OwnedEntity m_entity;

        LocalToWorld m_placed;
        bool m_cuts;

        /// <summary>The box along the world's axes around this one at its current place.</summary>
        public Bounds WorldBounds => CloudBounds.Transform(transform.localToWorldMatrix, new Bounds(Vector3.zero, Vector3.one));

        void OnEnable() => Update();

        void OnDisable() => m_entity.Destroy();

        void Update()
        {
            if (!m_entity.TryGet(out var entities))
            {
                if (!m_entity.TryCreate(out entities))
                    return;
                entities.AddComponentData(m_entity.Value, new PointCloudClip { Cuts = m_cuts = Cuts });
                entities.AddComponentData(m_entity.Value, m_placed = TransformMatrix.Of(transform));
            }
            if (m_cuts != Cuts)
                entities.SetComponentData(m_entity.Value, new PointCloudClip { Cuts = m_cuts = Cuts });
        }

        void LateUpdate()
        {
            if (m_entity.TryGet(out var entities))
                TransformMatrix.Set(entities, m_entity.Value, transform, ref m_placed);
        }

        void OnDrawGizmosSelected()
        {
            Gizmos.matrix = transform.localToWorldMatrix;
            Gizmos.DrawWireCube(Vector3.zero, Vector3.one);
        }
    }

    /// <summary>For subscenes. An open one has both entities; clipping twice by one box changes nothing.</summary>
    internal sealed class ClipBoxBaker : Baker<PointCloudClipBox>
    {
        public override void Bake(PointCloudClipBox authoring) =>
            AddComponent(GetEntity(TransformUsageFlags.Dynamic), new PointCloudClip { Cuts = authoring.Cuts });
    }
}
