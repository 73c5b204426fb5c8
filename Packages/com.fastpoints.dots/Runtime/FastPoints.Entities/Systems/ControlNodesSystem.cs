using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;

namespace FastPoints.Entities
{
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateAfter(typeof(ReceiveNodesSystem))]
    internal partial class ControlNodesSystem : StreamSystem
    {
        EntityQuery m_hidden;
        EntityQuery m_pinned;
        EntityQuery m_tinted;

        NativeList<PointCloudNode> m_controlled;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_hidden = GetEntityQuery(ComponentType.ReadOnly<PointCloudNode>(), ComponentType.ReadOnly<Hidden>());
            m_pinned = GetEntityQuery(ComponentType.ReadOnly<PointCloudNode>(), ComponentType.ReadOnly<Pinned>());
            m_tinted = GetEntityQuery(ComponentType.ReadOnly<PointCloudNode>(), ComponentType.ReadOnly<Tint>());
            m_controlled = new NativeList<PointCloudNode>(Allocator.Persistent);
        }

        protected override void OnUpdate()
        {
            var cache = Group.Stream.Cache;
            foreach (var node in m_controlled)
            {
                if (!cache.IsValid(node.Slot, node.SlotVersion))
                    continue;
                cache.SetHidden(node.Slot, false);
                cache.SetPinned(node.Slot, false);
                cache.SetTint(node.Slot, CachedNode.White);
            }
            m_controlled.Clear();
            if (!m_hidden.IsEmpty)
                Hide(cache);
            if (!m_pinned.IsEmpty)
                Pin(cache);
            if (!m_tinted.IsEmpty)
                Tint(cache);
        }

        protected override void OnDestroy()
        {
            m_controlled.Dispose();
            base.OnDestroy();
        }

        void Hide(NodeCache cache)
        {
            using var nodes = m_hidden.ToComponentDataArray<PointCloudNode>(Allocator.Temp);
            foreach (var node in nodes)
                if (TrySet(cache, node))
                    cache.SetHidden(node.Slot, true);
        }

        void Pin(NodeCache cache)
        {
            using var nodes = m_pinned.ToComponentDataArray<PointCloudNode>(Allocator.Temp);
            foreach (var node in nodes)
                if (TrySet(cache, node))
                    cache.SetPinned(node.Slot, true);
        }

        void Tint(NodeCache cache)
        {
            using var nodes = m_tinted.ToComponentDataArray<PointCloudNode>(Allocator.Temp);
            using var tints = m_tinted.ToComponentDataArray<Tint>(Allocator.Temp);
            for (int i = 0; i < nodes.Length; i++)
                if (TrySet(cache, nodes[i]))
                    cache.SetTint(nodes[i].Slot, tints[i].Rgba);
        }

        bool TrySet(NodeCache cache, PointCloudNode node)
        {
            if (!cache.IsValid(node.Slot, node.SlotVersion))
                return false;
            m_controlled.Add(node);
            return true;
        }
    }
}
