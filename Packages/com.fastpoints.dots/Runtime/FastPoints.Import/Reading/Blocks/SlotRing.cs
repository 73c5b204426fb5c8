using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Jobs;

namespace FastPoints.Reading
{
    // Slots used in turn: those in flight end in the order in which they were begun, so that results keep the order.
    internal struct SlotRing
    {
        public const string InFlight = "the slot is in flight: Complete it first";
        public const string NotInFlight = "the slot is not in flight: Begin it first";

        readonly int m_count;
        long m_begun;
        long m_ended;

        public SlotRing(int count)
        {
            m_count = count;
            m_begun = m_ended = 0;
        }

        public readonly bool IsEmpty => m_begun == m_ended;
        public readonly bool IsFull => m_begun - m_ended == m_count;
        public readonly int Oldest => IsEmpty ? throw new InvalidOperationException(NotInFlight) : (int)(m_ended % m_count);

        public int Begin() => IsFull ? throw new InvalidOperationException(InFlight) : (int)(m_begun++ % m_count);

        public int End()
        {
            int oldest = Oldest;
            m_ended++;
            return oldest;
        }

        public static IEnumerator<JobStep> Run(int slots, int things, Func<int, int, JobHandle> begin, Action<int> end)
        {
            var ring = new SlotRing(slots);
            var handles = new JobHandle[slots];
            for (int next = 0; next < things || !ring.IsEmpty;)
            {
                if (next < things && !ring.IsFull)
                {
                    int slot = ring.Begin();
                    handles[slot] = begin(slot, next++);
                    continue;
                }
                yield return handles[ring.Oldest];
                handles[ring.Oldest].Complete();
                end(ring.End());
            }
        }
    }
}
