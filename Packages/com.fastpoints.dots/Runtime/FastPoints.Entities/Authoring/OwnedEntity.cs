using System;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The entity that belongs to a GameObject's component in the shown world, in edit mode too. It is destroyed with
    /// the component; if others destroy it, or its world, its component makes it again.</summary>
    struct OwnedEntity
    {
        /// <summary>Whether this is an import worker process, set by the editor: it opens scenes as well, and needs no
        /// world.</summary>
        internal static bool IsImportWorker { get; set; }

        World m_world;

        public Entity Value { get; private set; } // Null if there is no entity.

        /// <summary>Makes the entity, without components.</summary>
        /// <returns>Whether there is a world, in which no system iterates.</returns>
        public bool TryCreate(out EntityManager entities)
        {
            // In edit mode, the world may not have been made yet.
            if (!IsImportWorker)
                DefaultWorldInitialization.DefaultLazyEditModeInitialize();
            m_world = PointCloudSystemGroup.ObjectGroup?.World ?? World.DefaultGameObjectInjectionWorld;
            Value = Entity.Null;
            if (m_world == null)
            {
                entities = default;
                return false;
            }
            entities = m_world.EntityManager;
            try
            {
                Value = entities.CreateEntity();
                return true;
            }
            // A system that iterates has enabled the component, which tries again with its next update.
            catch (InvalidOperationException)
            {
                return false;
            }
        }

        public readonly bool TryGet(out EntityManager entities)
        {
            bool exists = Value != Entity.Null && m_world.IsCreated && m_world.EntityManager.Exists(Value);
            entities = exists ? m_world.EntityManager : default;
            return exists;
        }

        public void Destroy()
        {
            if (TryGet(out var entities))
                Destroy(entities, Value);
            Value = Entity.Null;
        }

        static void Destroy(EntityManager entities, Entity entity)
        {
            try
            {
                entities.DestroyEntity(entity);
            }
            // A system that iterates has disabled the component.
            catch (InvalidOperationException) when (entities.World.GetExistingSystemManaged<PointCloudSystemGroup>() != null)
            {
                entities.World.GetExistingSystemManaged<PointCloudSystemGroup>().DestroyLater(entity);
            }
        }
    }
}
