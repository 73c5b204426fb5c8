using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Entities;
using Unity.Jobs;

namespace FastPoints.Entities
{
    [BurstCompile]
    internal struct CompareNodesJob : IJob
    {
        [ReadOnly] public NativeArray<CachedNode> Nodes;
        [ReadOnly] public NativeArray<DrawnNode> Drawn;
        public int MaxChanges; // The most entities to make, to destroy, and to update; the rest waits for the next frame.
        public NativeReference<int> First; // The slot to begin with, so that none is starved.
        public NativeList<TrackedNode> Tracked;
        public NativeList<bool> IsDrawn; // Scratch: indexed by slot.

        public NativeList<Entity> Removed;

        public NativeList<int> Added;
        public NativeList<int> Changed; // Slots whose entities have a new state, which is in Tracked already.

        public void Execute()
        {
            Removed.Clear();
            Added.Clear();
            Changed.Clear();
            if (Tracked.Length < Nodes.Length)
                Tracked.Resize(Nodes.Length, NativeArrayOptions.ClearMemory);
            IsDrawn.ResizeUninitialized(Nodes.Length);
            for (int slot = 0; slot < Nodes.Length; slot++)
                IsDrawn[slot] = false;
            for (int i = 0; i < Drawn.Length; i++)
                IsDrawn[Drawn[i].Slot] = true;
            int first = First.Value < Tracked.Length ? First.Value : 0, next = -1;
            for (int i = 0; i < Tracked.Length; i++)
            {
                int slot = first + i < Tracked.Length ? first + i : first + i - Tracked.Length;
                if (!Compare(slot) && next < 0)
                    next = slot;
            }
            First.Value = next < 0 ? 0 : next;
        }

        /// <returns>Whether its entity is up to date afterwards.</returns>
        bool Compare(int slot)
        {
            var cached = slot < Nodes.Length ? Nodes[slot] : default;
            ref var tracked = ref Tracked.ElementAt(slot);
            bool exists = cached.Phase != CachePhase.Free;
            bool isSame = exists && tracked.Version == cached.Version;
            if (tracked.Entity != Entity.Null && !isSame)
            {
                if (Removed.Length == MaxChanges)
                    return false;
                Removed.Add(tracked.Entity);
                tracked.Entity = Entity.Null;
            }
            if (!exists)
                return true;
            byte state = (byte)((cached.Phase == CachePhase.Resident ? TrackedNode.ResidentFlag : 0) |
                (IsDrawn[slot] ? TrackedNode.DrawnFlag : 0));
            if (tracked.Entity == Entity.Null)
            {
                if (Added.Length == MaxChanges)
                    return false;
                Added.Add(slot);
                tracked.Version = cached.Version;
                tracked.State = state;
                // The state of a copy of the prefab.
                tracked.Changes = state;
            }
            else if (tracked.State != state)
            {
                if (Changed.Length == MaxChanges)
                    return false;
                tracked.Changes = (byte)(tracked.State ^ state);
                tracked.State = state;
                Changed.Add(slot);
            }
            return true;
        }
    }

    internal struct TrackedNode
    {
        public const byte ResidentFlag = 1;
        public const byte DrawnFlag = 2;
        public Entity Entity; // Null if there is none.
        public int Version;

        public byte State;

        public byte Changes;
    }
}
