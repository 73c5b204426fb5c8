using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Entities;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>State that the systems keep for the entity of a cloud. It is no component, since copies of the entity have none
    /// of it: they open their own cloud.</summary>
    sealed class EntityCloud : IDisposable
    {
        public GameObject Object; // The GameObject of the PointCloud that places it; null for none.

        public OpenedCloud Opened;

        public string Error;

        /// <summary>The source that the stream takes next; null for none. If the stream has one already, this is a newer
        /// state of the same cloud and replaces it when it is ready.</summary>
        public NodeSource NextSource;

        /// <summary>How <see cref="NextSource"/> is coloured, which becomes the entity's look when it is shown. Null keeps the
        /// current look.</summary>
        public PointCloudLook? NextLook;
        public CloudStage NextStage; // Of that source too.

        public CloudVersions Versions;

        /// <summary>How states that are not <see cref="CloudVersions.ShownNumber"/> are coloured, by their number in the stream.
        /// The entity's own look is that of the shown state.</summary>
        public readonly Dictionary<int, PointCloudLook> Looks = new Dictionary<int, PointCloudLook>();

        /// <summary>Sets the next source, replacing one that the stream has not taken.</summary>
        public void SetSource(NodeSource source, PointCloudLook? look, CloudStage stage)
        {
            DropSource();
            (NextSource, NextLook, NextStage) = (source, look, stage);
        }

        public void DropSource()
        {
            NextSource?.Dispose();
            NextSource = null;
        }

        public void Dispose()
        {
            Opened?.Dispose();
            DropSource();
        }
    }

    /// <summary>The live clouds of a world, by their entities: an entity's index and version are the index into this table and
    /// the version of the entry. Main thread.</summary>
    sealed class EntityClouds : IDisposable
    {
        readonly Dictionary<Entity, EntityCloud> m_all = new Dictionary<Entity, EntityCloud>();
        readonly List<Entity> m_removed = new List<Entity>();

        public Dictionary<Entity, EntityCloud>.Enumerator GetEnumerator() => m_all.GetEnumerator();

        /// <summary>The entry of an entity, made if there is none.</summary>
        public EntityCloud GetOrAdd(Entity entity)
        {
            if (!m_all.TryGetValue(entity, out var live))
                m_all.Add(entity, live = new EntityCloud());
            return live;
        }

        /// <returns>Null if there is none.</returns>
        public EntityCloud Find(Entity entity) => m_all.TryGetValue(entity, out var live) ? live : null;

        /// <summary>The entity of the cloud whose shown state has a number in the stream; null if there is none.</summary>
        public Entity EntityShowing(int number)
        {
            foreach (var (entity, live) in m_all)
                if (live.Versions != null && live.Versions.ShownNumber == number)
                    return entity;
            return Entity.Null;
        }

        public void RemoveDestroyed(EntityManager entities)
        {
            foreach (var entity in m_all.Keys)
                if (!entities.Exists(entity))
                    m_removed.Add(entity);
            foreach (var entity in m_removed)
                Remove(entity);
            m_removed.Clear();
        }

        public void Remove(Entity entity)
        {
            Find(entity)?.Dispose();
            m_all.Remove(entity);
        }

        public void Dispose()
        {
            foreach (var live in m_all.Values)
                live.Dispose();
            m_all.Clear();
        }
    }
}
