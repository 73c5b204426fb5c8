using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Jobs;

namespace FastPoints.Reading
{
    /// <summary>Numbers of slots that are used in turn: those in flight end in the order in which they were begun, so that
    /// results keep the order of what was asked for.</summary>
    internal struct SlotRing
    {
        /// <summary>What a slot says that is begun before its last work was completed, and one that is completed before it was
        /// begun.</summary>
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

        /// <summary>The slot that was begun first of those in flight.</summary>
        public readonly int Oldest => IsEmpty ? throw new InvalidOperationException(NotInFlight) : (int)(m_ended % m_count);

        /// <summary>Takes the next slot, which must be idle.</summary>
        public int Begin() => IsFull ? throw new InvalidOperationException(InFlight) : (int)(m_begun++ % m_count);

        /// <summary>Gives the oldest slot back.</summary>
        public int End()
        {
            int oldest = Oldest;
            m_ended++;
            return oldest;
        }

        /// <summary>Coroutine: begins things with a few slots, and ends each when it is done.</summary>
        /// <param name="begin">Begins the thing of a number with a slot.</param>
        /// <param name="end">Ends what a slot has, whose handle is complete.</param>
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
