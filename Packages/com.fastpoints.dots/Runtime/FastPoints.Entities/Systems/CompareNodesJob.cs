using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Entities;
using Unity.Jobs;

namespace FastPoints.Entities
{
    /// <summary>Finds where entities of nodes differ from the cache.</summary>
    [BurstCompile]
    internal struct CompareNodesJob : IJob
    {
        [ReadOnly] public NativeArray<CachedNode> Slots;
        [ReadOnly] public NativeArray<DrawnNode> Drawn;

        /// <summary>The most entities to make or destroy; the rest waits for the next frame.</summary>
        public int MostChanges;
        public NativeList<TrackedNode> Tracked;

        /// <summary>Scratch: indexed by slot.</summary>
        public NativeList<bool> IsDrawn;

        /// <summary>Entities of nodes that are gone.</summary>
        public NativeList<Entity> Gone;

        /// <summary>Slots whose nodes have no entity.</summary>
        public NativeList<int> Come;

        /// <summary>Slots whose entities have a new state, which is in <see cref="Tracked"/> already.</summary>
        public NativeList<int> Changed;

        public void Execute()
        {
            Gone.Clear();
            Come.Clear();
            Changed.Clear();
            while (Tracked.Length < Slots.Length)
                Tracked.Add(default);
            IsDrawn.ResizeUninitialized(Slots.Length);
            for (int slot = 0; slot < Slots.Length; slot++)
                IsDrawn[slot] = false;
            for (int i = 0; i < Drawn.Length; i++)
                IsDrawn[Drawn[i].Slot] = true;
            for (int slot = 0; slot < Slots.Length; slot++)
                Compare(slot);
        }

        void Compare(int slot)
        {
            var cached = Slots[slot];
            ref var tracked = ref Tracked.ElementAt(slot);
            bool isThere = cached.Phase != CachePhase.Free;
            bool isSame = isThere && tracked.Version == cached.Version;
            if (tracked.Entity != Entity.Null && !isSame)
            {
                if (Gone.Length == MostChanges)
                    return;
                Gone.Add(tracked.Entity);
                tracked.Entity = Entity.Null;
            }
            if (!isThere)
                return;
            byte state = (byte)((cached.Phase == CachePhase.Resident ? TrackedNode.IsResident : 0) |
                (IsDrawn[slot] ? TrackedNode.IsDrawn : 0));
            if (tracked.Entity == Entity.Null)
            {
                if (Come.Length == MostChanges)
                    return;
                Come.Add(slot);
                tracked.Version = cached.Version;
                tracked.State = state;
            }
            else if (tracked.State != state)
            {
                tracked.State = state;
                Changed.Add(slot);
            }
        }
    }

    /// <summary>What is known of a slot of the cache: the entity of its node.</summary>
    internal struct TrackedNode
    {
        public const byte IsResident = 1;
        public const byte IsDrawn = 2;

        /// <summary>Null if there is none.</summary>
        public Entity Entity;
        public int Version;

        /// <summary>The state that the entity shows.</summary>
        public byte State;
    }
}
