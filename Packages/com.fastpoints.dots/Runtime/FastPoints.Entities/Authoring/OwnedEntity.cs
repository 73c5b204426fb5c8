using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The entity that a GameObject's component has in the default world, in edit mode too. Goes with the component, or
    /// with the world.</summary>
    struct OwnedEntity
    {
        World m_world;

        /// <summary>Null where there is none.</summary>
        public Entity Value { get; private set; }

        /// <summary>Makes the entity, without components.</summary>
        /// <returns>Whether there is a world.</returns>
        public bool TryCreate(out EntityManager entities)
        {
            // In edit mode nobody else may have made the world yet.
            DefaultWorldInitialization.DefaultLazyEditModeInitialize();
            m_world = World.DefaultGameObjectInjectionWorld;
            if (m_world == null)
            {
                entities = default;
                return false;
            }
            entities = m_world.EntityManager;
            Value = entities.CreateEntity();
            return true;
        }

        /// <returns>Whether there is an entity, in a world that still is.</returns>
        public readonly bool TryGet(out EntityManager entities)
        {
            bool isThere = Value != Entity.Null && m_world.IsCreated;
            entities = isThere ? m_world.EntityManager : default;
            return isThere;
        }

        public void Destroy()
        {
            if (TryGet(out var entities))
                entities.DestroyEntity(Value);
            Value = Entity.Null;
        }
    }
}
