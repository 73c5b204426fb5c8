using System.Collections.Generic;
using FastPoints.Entities;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Entities;
using Unity.Jobs;

namespace FastPoints.Tests.Entities
{
    public sealed class CompareNodesTests
    {
        const int Max = 10, Count = 45;

        NativeArray<CachedNode> m_slots;
        NativeList<TrackedNode> m_tracked;
        NativeList<bool> m_isDrawn;
        NativeList<Entity> m_removed;
        NativeList<int> m_added, m_changed;
        NativeReference<int> m_first;

        [SetUp]
        public void Begin()
        {
            m_slots = new NativeArray<CachedNode>(Count, Allocator.Persistent);
            m_tracked = new NativeList<TrackedNode>(Allocator.Persistent);
            m_isDrawn = new NativeList<bool>(Allocator.Persistent);
            m_removed = new NativeList<Entity>(Allocator.Persistent);
            m_added = new NativeList<int>(Allocator.Persistent);
            m_changed = new NativeList<int>(Allocator.Persistent);
            m_first = new NativeReference<int>(Allocator.Persistent);
        }

        [TearDown]
        public void End()
        {
            m_slots.Dispose();
            m_tracked.Dispose();
            m_isDrawn.Dispose();
            m_removed.Dispose();
            m_added.Dispose();
            m_changed.Dispose();
            m_first.Dispose();
        }

        void Compare()
        {
            using var drawn = new NativeArray<DrawnNode>(0, Allocator.TempJob);
            new CompareNodesJob
            {
                Nodes = m_slots,
                Drawn = drawn,
                MaxChanges = Max,
                First = m_first,
                Tracked = m_tracked,
                IsDrawn = m_isDrawn,
                Removed = m_removed,
                Added = m_added,
                Changed = m_changed,
            }.Run();
            foreach (int slot in m_added)
                m_tracked.ElementAt(slot).Entity = new Entity { Index = slot + 1, Version = 1 };
        }

        void Set(CachePhase phase, int version)
        {
            for (int i = 0; i < Count; i++)
                m_slots[i] = new CachedNode { Phase = phase, Version = version };
        }

        List<(int Added, int Removed, int Changed)> Follow()
        {
            var done = new List<(int Added, int Removed, int Changed)>();
            for (Compare(); m_added.Length + m_removed.Length + m_changed.Length > 0; Compare())
                done.Add((m_added.Length, m_removed.Length, m_changed.Length));
            return done;
        }

        [Test]
        public void Execute_MoreChangesThanAFrameAllows_AreBatched()
        {
            Set(CachePhase.Requested, 1);
            Assert.That(Follow(), Is.EqualTo(new[] { (10, 0, 0), (10, 0, 0), (10, 0, 0), (10, 0, 0), (5, 0, 0) }));
            Set(CachePhase.Resident, 1);
            Assert.That(Follow(), Is.EqualTo(new[] { (0, 0, 10), (0, 0, 10), (0, 0, 10), (0, 0, 10), (0, 0, 5) }));
            // Others took their place.
            Set(CachePhase.Requested, 2);
            Assert.That(Follow(), Is.EqualTo(new[] { (10, 10, 0), (10, 10, 0), (10, 10, 0), (10, 10, 0), (5, 5, 0) }));
            Set(CachePhase.Free, 3);
            Assert.That(Follow(), Is.EqualTo(new[] { (0, 10, 0), (0, 10, 0), (0, 10, 0), (0, 10, 0), (0, 5, 0) }));
        }

        /// <summary>Slots at the beginning that change with every frame would starve the others.</summary>
        [Test]
        public void Execute_ConstantChanges_OthersAreNotStarved()
        {
            var made = new HashSet<int>();
            for (int frame = 1; frame <= 10; frame++)
            {
                for (int i = 0; i < Count; i++)
                    m_slots[i] = new CachedNode { Phase = CachePhase.Requested, Version = i < 2 * Max ? frame : 1 };
                Compare();
                foreach (int slot in m_added)
                    made.Add(slot);
            }
            Assert.That(made, Has.Count.EqualTo(Count));
        }

        [Test]
        public void Execute_NoSlots_DestroysAllEntities()
        {
            Set(CachePhase.Resident, 1);
            Follow();
            m_slots.Dispose();
            m_slots = new NativeArray<CachedNode>(0, Allocator.Persistent);
            Assert.That(Follow(), Has.Count.EqualTo(5));
        }
    }
}
