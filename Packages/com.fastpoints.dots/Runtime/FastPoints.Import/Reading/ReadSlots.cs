using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Reading
{
    // The reads in flight of a source, as many as keep workers busy; a slot's memory is allocated when it is first needed.
    internal sealed class ReadSlots : IDisposable
    {
        readonly PointReader m_reader;
        readonly PointSchema m_wanted;
        readonly InFlightLimit m_limit;
        readonly int m_longest;
        readonly JobHandle[] m_last;
        readonly List<BlockRead> m_reads = new List<BlockRead>();
        readonly List<JobHandle> m_consumed = new List<JobHandle>();
        readonly Queue<int> m_inFlight = new Queue<int>();
        readonly Stack<int> m_spare = new Stack<int>();
        bool m_keepsStates;

        // longest: the most points of a read; chains: the most reads whose jobs run side by side, 0 for all in flight.
        public ReadSlots(PointReader reader, PointSchema wanted, int longest, InFlightLimit limit, int chains)
        {
            m_reader = reader;
            m_wanted = wanted;
            m_longest = longest;
            m_limit = limit;
            m_last = new JobHandle[chains];
        }

        public int Count => m_reads.Count;
        public int InFlight => m_inFlight.Count;

        public bool TryKeepStates()
        {
            Add();
            return m_keepsStates = m_reads[0].TryKeepStates();
        }

        public IEnumerator<JobStep> Run(IBlockConsumer consumer, int first, int end, Action<BlockRead, int> begin,
            StageProgress progress)
        {
            long pointsDone = 0, bytesDone = 0;
            var throttle = consumer as IThrottledConsumer;
            var newest = default(JobHandle);
            for (int next = first; next < end || m_inFlight.Count > 0;)
            {
                if (next == end || m_inFlight.Count >= m_limit.Value)
                {
                    int done = m_inFlight.Peek();
                    m_limit.Await();
                    yield return m_consumed[done];
                    m_limit.Resume(next < end && newest.IsCompleted);
                    m_inFlight.Dequeue();
                    m_spare.Push(done);
                    m_consumed[done].Complete();
                    var read = m_reads[done];
                    read.Complete();
                    consumer.Completed(read, done);
                    pointsDone += read.Points.Count;
                    bytesDone += m_reader.BytesOfRange(read.Range);
                    progress?.Report((next - first - m_inFlight.Count) / (double)(end - first), pointsDone, bytesDone);
                    continue;
                }
                while (throttle != null && !throttle.IsReady)
                    yield return default;
                if (m_spare.Count == 0)
                {
                    Add();
                    // The coroutine checks its budget.
                    yield return default;
                }
                int slot = m_spare.Pop();
                if (m_last.Length > 0)
                    m_reads[slot].Dependency = m_last[next % m_last.Length];
                begin(m_reads[slot], next);
                m_consumed[slot] = newest = consumer.Schedule(m_reads[slot], slot, m_reads[slot].Decoded);
                if (m_last.Length > 0)
                    m_last[next % m_last.Length] = newest;
                m_inFlight.Enqueue(slot);
                next++;
                JobHandle.ScheduleBatchedJobs();
                yield return default;
            }
        }

        // Coroutine: frees a slot a step, since large blocks take a millisecond.
        public IEnumerator<JobStep> Free()
        {
            for (; m_reads.Count > 0; m_reads.RemoveAt(m_reads.Count - 1))
            {
                m_reads[m_reads.Count - 1].Dispose();
                yield return default;
            }
            m_spare.Clear();
        }

        public void Dispose()
        {
            for (int i = 0; i < m_reads.Count; i++)
            {
                m_consumed[i].Complete();
                m_reads[i].Dispose();
            }
            m_reads.Clear();
        }

        void Add()
        {
            var read = m_reader.CreateRead(m_wanted, m_longest, Allocator.Persistent);
            m_spare.Push(m_reads.Count);
            m_reads.Add(read);
            m_consumed.Add(default);
            if (m_keepsStates)
                read.TryKeepStates();
        }
    }
}
