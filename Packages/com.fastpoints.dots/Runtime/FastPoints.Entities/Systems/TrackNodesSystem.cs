using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;
using Unity.Jobs;

namespace FastPoints.Entities
{
    /// <summary>Creates and destroys the entities of nodes, some in each frame, and updates their nodes' state. It does nothing
    /// when idle, and nothing at all unless entities are requested (<see cref="PointCloudNodesWanted"/>).</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderLast = true)]
    internal unsafe partial class TrackNodesSystem : StreamSystem
    {
        internal const int MaxChanges = 512; // The most entities that one frame makes, destroys, and updates.
        Entity m_prefab; // A node that was just requested: copies need little more than its bounds.
        int m_count;
        EntityQuery m_wanted;
        NativeReference<int> m_first;
        NativeList<TrackedNode> m_tracked;
        NativeList<bool> m_isDrawn;
        NativeList<Entity> m_removed;
        NativeList<int> m_added;
        NativeList<int> m_changed;
        NativeList<Entity> m_created;
        NativeList<Entity> m_entityOfCloud;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_wanted = GetEntityQuery(ComponentType.ReadOnly<PointCloudNodesWanted>());
            m_first = new NativeReference<int>(Allocator.Persistent);
            m_tracked = new NativeList<TrackedNode>(1024, Allocator.Persistent);
            m_isDrawn = new NativeList<bool>(1024, Allocator.Persistent);
            m_removed = new NativeList<Entity>(MaxChanges, Allocator.Persistent);
            m_added = new NativeList<int>(MaxChanges, Allocator.Persistent);
            m_changed = new NativeList<int>(1024, Allocator.Persistent);
            m_created = new NativeList<Entity>(MaxChanges, Allocator.Persistent);
            m_entityOfCloud = new NativeList<Entity>(Allocator.Persistent);
        }

        protected override void OnUpdate()
        {
            bool isWanted = !m_wanted.IsEmpty;
            if (!isWanted && m_count == 0)
                return;
            var slots = Group.Stream.Cache.Nodes;
            var drawn = Group.Stream.Drawn.AsArray();
            new CompareNodesJob
            {
                Nodes = isWanted ? slots : slots.GetSubArray(0, 0),
                Drawn = isWanted ? drawn : drawn.GetSubArray(0, 0),
                MaxChanges = MaxChanges,
                First = m_first,
                Tracked = m_tracked,
                IsDrawn = m_isDrawn,
                Removed = m_removed,
                Added = m_added,
                Changed = m_changed,
            }.Run();
            if (m_removed.Length > 0)
                EntityManager.DestroyEntity(m_removed.AsArray());
            if (m_added.Length > 0)
                CreateEntities();
            m_count += m_added.Length - m_removed.Length;
            for (int i = 0; i < m_changed.Length; i++)
                UpdateEntity(m_tracked[m_changed[i]]);
        }

        protected override void OnDestroy()
        {
            m_tracked.Dispose();
            m_first.Dispose();
            m_isDrawn.Dispose();
            m_removed.Dispose();
            m_added.Dispose();
            m_changed.Dispose();
            m_created.Dispose();
            m_entityOfCloud.Dispose();
            base.OnDestroy();
        }

        void CreateEntities()
        {
            FindClouds();
            if (!EntityManager.Exists(m_prefab))
                CreatePrefab();
            m_created.ResizeUninitialized(m_added.Length);
            EntityManager.Instantiate(m_prefab, m_created.AsArray());
            for (int i = 0; i < m_added.Length; i++)
            {
                int slot = m_added[i];
                var entity = m_created[i];
                ref var tracked = ref m_tracked.ElementAt(slot);
                tracked.Entity = entity;
                Describe(entity, slot, Group.Stream.Cache[slot]);
                UpdateEntity(tracked);
            }
        }

        void CreatePrefab()
        {
            m_prefab = EntityManager.CreateEntity(ComponentType.ReadWrite<PointCloudNode>(),
                ComponentType.ReadWrite<PointCloudNodeBounds>(), ComponentType.ReadWrite<Requested>(),
                ComponentType.ReadWrite<Resident>(), ComponentType.ReadWrite<Drawn>(),
                ComponentType.ReadWrite<Hidden>(),
                ComponentType.ReadWrite<Pinned>(), ComponentType.ReadWrite<Tint>(), ComponentType.ReadWrite<Prefab>());
            EntityManager.SetComponentData(m_prefab, new Tint { Rgba = CachedNode.White });
            EntityManager.SetComponentEnabled<Resident>(m_prefab, false);
            EntityManager.SetComponentEnabled<Drawn>(m_prefab, false);
            EntityManager.SetComponentEnabled<Hidden>(m_prefab, false);
            EntityManager.SetComponentEnabled<Pinned>(m_prefab, false);
            EntityManager.SetComponentEnabled<Tint>(m_prefab, false);
        }

        void Describe(Entity entity, int slot, CachedNode cached)
        {
            var node = Group.Stream.Clouds[cached.Cloud].Pages[cached.Page].Nodes[cached.Node];
            EntityManager.SetComponentData(entity, new PointCloudNode
            {
                Cloud = m_entityOfCloud[cached.Cloud],
                Page = cached.Page,
                Node = cached.Node,
                PointCount = node.PointCount,
                Slot = slot,
                SlotVersion = cached.Version,
            });
            EntityManager.SetComponentData(entity, new PointCloudNodeBounds { Center = node.Center, Half = node.Half });
        }

        void UpdateEntity(TrackedNode tracked)
        {
            // Users may have destroyed all entities of the world.
            if (!EntityManager.Exists(tracked.Entity))
                return;
            if ((tracked.Changes & TrackedNode.ResidentFlag) != 0)
            {
                bool isResident = (tracked.State & TrackedNode.ResidentFlag) != 0;
                EntityManager.SetComponentEnabled<Requested>(tracked.Entity, !isResident);
                EntityManager.SetComponentEnabled<Resident>(tracked.Entity, isResident);
            }
            if ((tracked.Changes & TrackedNode.DrawnFlag) != 0)
                EntityManager.SetComponentEnabled<Drawn>(tracked.Entity, (tracked.State & TrackedNode.DrawnFlag) != 0);
        }

        void FindClouds()
        {
            m_entityOfCloud.Clear();
            for (int c = 0; c < Group.Stream.Clouds.Count; c++)
                m_entityOfCloud.Add(Entity.Null);
            foreach (var (entity, live) in Group.Live)
            {
                if (live.Versions == null)
                    continue;
                m_entityOfCloud[live.Versions.ShownNumber] = entity;
                if (live.Versions.Preview != CloudVersions.None)
                    m_entityOfCloud[live.Versions.Preview] = entity;
                if (live.Versions.Next != CloudVersions.None)
                    m_entityOfCloud[live.Versions.Next] = entity;
            }
        }
    }
}
