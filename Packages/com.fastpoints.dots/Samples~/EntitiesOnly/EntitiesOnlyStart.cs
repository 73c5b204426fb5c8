using FastPoints.Entities;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;
using UnityEngine;

namespace FastPoints.Samples.EntitiesOnly
{
    /// <summary>Makes the entities of a cloud and of its budget by hand, asks for nodes, and runs a system of our
    /// own on the cloud's nodes. It is the scene's only GameObject besides the camera: in a game, the bootstrap does
    /// this.</summary>
    [AddComponentMenu("FastPoints/Samples/Entities Only Start")]
    public sealed class EntitiesOnlyStart : MonoBehaviour
    {
        [Tooltip("The cloud: what the editor makes of a file that is dropped into the project.")]
        public PointCloudAsset Cloud;

        World m_world;
        Entity m_cloud, m_budget, m_wanted;

        void OnEnable()
        {
            m_world = PointCloudSystemGroup.ObjectWorld ?? World.DefaultGameObjectInjectionWorld;
            var entities = m_world.EntityManager;

            m_cloud = entities.CreateEntity();
            entities.AddComponentData(m_cloud, new LocalToWorld { Value = float4x4.identity });
            entities.AddComponentData(m_cloud, Cloud.File());
            Cloud.Paths.WriteTo(entities.AddBuffer<PointCloudPathByte>(m_cloud));

            m_budget = entities.CreateEntity();
            entities.AddComponentData(m_budget, new PointCloudBudget
            {
                Points = 1_000_000,
                PoolBytes = 256 << 20,
                MaxUploadBytesPerFrame = 4 << 20,
                MinNodePx = 1,
            });

            // The system below looks at nodes.
            m_wanted = entities.CreateEntity(ComponentType.ReadWrite<PointCloudNodesWanted>());
            var tint = m_world.GetOrCreateSystemManaged<TintNodesSystem>();
            m_world.GetExistingSystemManaged<SimulationSystemGroup>().AddSystemToUpdateList(tint);
        }

        void OnDisable()
        {
            if (!m_world.IsCreated)
                return;
            var tint = m_world.GetExistingSystemManaged<TintNodesSystem>();
            m_world.GetExistingSystemManaged<SimulationSystemGroup>().RemoveSystemFromUpdateList(tint);
            m_world.EntityManager.DestroyEntity(m_cloud);
            m_world.EntityManager.DestroyEntity(m_budget);
            m_world.EntityManager.DestroyEntity(m_wanted);
        }
    }
}
