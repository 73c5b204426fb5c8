using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>A converted cloud in a scene of GameObjects: makes the entity that streams it, which stands where the GameObject
    /// does, in edit mode too.</summary>
    [ExecuteAlways]
    [DisallowMultipleComponent]
    [AddComponentMenu("FastPoints/Point Cloud")]
    public sealed class PointCloud : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The .fastpoints folder: absolute, or below StreamingAssets.")]
        string m_path;

        World m_world;

        /// <summary>The <c>.fastpoints</c> folder: absolute, or below StreamingAssets.</summary>
        public string Path
        {
            get => m_path;
            set
            {
                if (m_path == value)
                    return;
                m_path = value;
                if (!isActiveAndEnabled)
                    return;
                Remove();
                Add();
            }
        }

        /// <summary>Null while the component is disabled.</summary>
        public Entity Entity { get; private set; }

        void OnEnable() => Add();

        void OnDisable() => Remove();

        void Update()
        {
            if (Entity != Entity.Null && m_world.IsCreated)
                m_world.EntityManager.SetComponentData(Entity, PlaceOf(transform));
        }

        void Add()
        {
            // In edit mode nobody else may have made the world yet.
            DefaultWorldInitialization.DefaultLazyEditModeInitialize();
            m_world = World.DefaultGameObjectInjectionWorld;
            if (m_world == null || string.IsNullOrEmpty(m_path))
                return;
            var entities = m_world.EntityManager;
            Entity = entities.CreateEntity();
            entities.AddComponentData(Entity, PlaceOf(transform));
            entities.AddComponentObject(Entity, new PointCloudFile { Path = m_path });
        }

        void Remove()
        {
            if (m_world != null && m_world.IsCreated && Entity != Entity.Null)
                m_world.EntityManager.DestroyEntity(Entity);
            Entity = Entity.Null;
        }

        static LocalToWorld PlaceOf(Transform transform)
        {
            var matrix = transform.localToWorldMatrix;
            return new LocalToWorld
            {
                Value = new float4x4(
                    new float4(matrix.m00, matrix.m10, matrix.m20, matrix.m30),
                    new float4(matrix.m01, matrix.m11, matrix.m21, matrix.m31),
                    new float4(matrix.m02, matrix.m12, matrix.m22, matrix.m32),
                    new float4(matrix.m03, matrix.m13, matrix.m23, matrix.m33)),
            };
        }
    }
}
