using Unity.Entities;
using Unity.Transforms;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>A box that all clouds are clipped by: the cube of edge 1 around the GameObject's origin, moved, turned and scaled as the
    /// GameObject is.</summary>
    [ExecuteAlways]
    [DisallowMultipleComponent]
    [AddComponentMenu("FastPoints/Point Cloud Clip Box")]
    public sealed class PointCloudClipBox : MonoBehaviour
    {
        [Tooltip("Takes away what is in the box. Otherwise only what is in it is drawn, or in another such box.")]
        public bool Cuts;

        World m_world;
        Entity m_entity;

        void OnEnable()
        {
            DefaultWorldInitialization.DefaultLazyEditModeInitialize();
            m_world = World.DefaultGameObjectInjectionWorld;
            if (m_world == null)
                return;
            m_entity = m_world.EntityManager.CreateEntity(ComponentType.ReadWrite<PointCloudClip>(),
                ComponentType.ReadWrite<LocalToWorld>());
            Update();
        }

        void OnDisable()
        {
            if (m_world != null && m_world.IsCreated && m_entity != Entity.Null)
                m_world.EntityManager.DestroyEntity(m_entity);
            m_entity = Entity.Null;
        }

        void Update()
        {
            if (m_entity == Entity.Null || !m_world.IsCreated)
                return;
            m_world.EntityManager.SetComponentData(m_entity, new PointCloudClip { Cuts = Cuts });
            m_world.EntityManager.SetComponentData(m_entity, TransformMatrix.Of(transform));
        }

        void OnDrawGizmosSelected()
        {
            Gizmos.matrix = transform.localToWorldMatrix;
            Gizmos.DrawWireCube(Vector3.zero, Vector3.one);
        }
    }
}
