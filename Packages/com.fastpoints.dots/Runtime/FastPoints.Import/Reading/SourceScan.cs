using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Reading
{
    internal static class SourceScan
    {
        // For each worker, one block is decoded and one read.
        public static int DefaultSlots => 2 * Math.Max(1, Unity.Jobs.LowLevel.Unsafe.JobsUtility.JobWorkerCount + 1);

        // Bounds a scan's resident set, whatever the number of cores and the size of blocks.
        public const long MaxSlotBytes = 96L << 20;

        public static int SlotsFor(PointReader reader, PointSchema wanted) =>
            reader.BlockCount == 0 ? 1 : Math.Min(DefaultSlots, SlotsIn(reader, wanted, 0, MaxSlotBytes));

        // maxBytes is for all slots together; there is always one.
        internal static int SlotsIn(PointReader reader, PointSchema wanted, int extraBytesPerPoint, long maxBytes)
        {
            long fileBytes = reader.BytesOfRange(new BlockRange(0, 0, reader.PointsInBlock(0)));
            long bytesPerSlot = (long)reader.MaxPointsPerBlock * (wanted.BytesPerPoint + extraBytesPerPoint) + fileBytes
                + reader.DecoderBytes;
            return (int)Math.Max(1, Math.Min(int.MaxValue, maxBytes / Math.Max(1, bytesPerSlot)));
        }

        // Points that a worker takes in a millisecond at most: of records of one length, and of all others.
        const double RecordsPerMs = 8000, OthersPerMs = 2000;

        // For a coroutine that is ticked: as many at first as are done in the time, or as one that awaits each needs, and as many
        // as memory allows where workers run out of them.
        public static InFlightLimit LimitFor(PointReader reader, PointSchema wanted, int extraBytesPerPoint, long maxBytes,
            int chains, Func<double> ms)
        {
            if (reader.BlockCount == 0)
                return new InFlightLimit(1, 1, ms);
            int min = chains > 0 ? Math.Min(DefaultSlots, 2 * chains) : DefaultSlots;
            int first = InFlightLimit.ValueFor(min, ms(), (min + 1) / 2,
                reader.MaxPointsPerBlock / (reader is RecordReader ? RecordsPerMs : OthersPerMs));
            return new InFlightLimit(first, SlotsIn(reader, wanted, extraBytesPerPoint, maxBytes), ms);
        }

        // Coroutine: decodes every block and passes it to the consumer. The slots determine the memory.
        public static IEnumerator<JobStep> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer, int slots,
            StageProgress progress) =>
            Run(ScanRanges.Blocks(reader, 0, reader.BlockCount), wanted, consumer, new InFlightLimit(slots, slots, () => 0), 0,
                progress);

        // chains: the most ranges whose jobs run side by side; 0 for all that are in flight.
        public static IEnumerator<JobStep> Run(ScanRanges ranges, PointSchema wanted, IBlockConsumer consumer,
            InFlightLimit limit, int chains, StageProgress progress)
        {
            using var slots = new ReadSlots(ranges.Reader, wanted, ranges.MaxPoints, limit, chains);
            yield return JobStep.Of(slots.Run(consumer, ranges, (read, n) => read.Begin(ranges.RangeOf(n)), progress));
            yield return JobStep.Of(slots.Free());
        }
    }

    // The scanned ranges of a source, from First to before End.
    internal sealed class ScanRanges
    {
        public PointReader Reader;
        public int First;
        public int End;
        public Func<int, BlockRange> RangeOf;
        public int MaxPoints; // Points of the longest range, or more.

        public static ScanRanges Blocks(PointReader reader, int first, int end) => new ScanRanges
        {
            Reader = reader,
            First = first,
            End = end,
            RangeOf = block => new BlockRange(block, 0, reader.PointsInBlock(block)),
            MaxPoints = reader.MaxPointsPerBlock,
        };

        public static ScanRanges Of(PointReader reader, IReadOnlyList<BlockRange> ranges, int maxPoints) =>
            new ScanRanges { Reader = reader, End = ranges.Count, RangeOf = n => ranges[n], MaxPoints = maxPoints };
    }

    internal interface IBlockConsumer
    {
        // The jobs must depend on decoded and use the count in read.Result; a consumer whose jobs share state chains them itself.
        // slot: from 0 to slots - 1, so that state for each slot needs no locks.
        JobHandle Schedule(BlockRead read, int slot, JobHandle decoded);

        // The block's jobs are complete; blocks arrive in order. Main thread.
        void Completed(BlockRead read, int slot);
    }

    internal interface IThrottledConsumer : IBlockConsumer
    {
        bool IsReady { get; } // It may wait for a millisecond. Main thread.
    }

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
        readonly Stack<int> m_idle = new Stack<int>();
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

        public bool TryEnableStates()
        {
            Add();
            return m_keepsStates = m_reads[0].TryEnableStates();
        }

        public IEnumerator<JobStep> Run(IBlockConsumer consumer, ScanRanges ranges, Action<BlockRead, int> begin,
            StageProgress progress)
        {
            int first = ranges.First, end = ranges.End;
            using var window = m_reader.WindowOf(first, end, ranges.RangeOf);
            long pointsDone = 0, bytesDone = 0;
            var throttle = consumer as IThrottledConsumer;
            var newest = default(JobHandle);
            for (int next = first; next < end || m_inFlight.Count > 0;)
            {
                if (next == end || m_inFlight.Count >= m_limit.Value)
                {
                    int done = m_inFlight.Peek();
                    m_limit.BeginWait();
                    yield return m_consumed[done];
                    m_limit.EndWait(next < end && newest.IsCompleted);
                    m_inFlight.Dequeue();
                    m_idle.Push(done);
                    m_consumed[done].Complete();
                    var read = m_reads[done];
                    read.Complete();
                    consumer.Completed(read, done);
                    pointsDone += read.Points.Count;
                    bytesDone += m_reader.BytesOfRange(read.Range);
                    progress?.Report((next - first - m_inFlight.Count) / (double)(end - first), pointsDone, bytesDone);
                    continue;
                }
                while (throttle != null && !throttle.IsReady || window != null && !window.TryPrepareNext())
                    yield return default;
                if (m_idle.Count == 0)
                {
                    Add();
                    // Lets the coroutine check its budget.
                    yield return default;
                }
                int slot = m_idle.Pop();
                if (m_last.Length > 0)
                    m_reads[slot].Dependency = m_last[next % m_last.Length];
                m_reads[slot].Fetched = window?.Take();
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
            m_idle.Clear();
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
            m_idle.Push(m_reads.Count);
            m_reads.Add(read);
            m_consumed.Add(default);
            if (m_keepsStates)
                read.TryEnableStates();
        }
    }

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

        public static IEnumerator<JobStep> Run(int slots, int things, Func<int, int, JobHandle> begin, Action<int> end,
            FetchWindow window = null)
        {
            var ring = new SlotRing(slots);
            var handles = new JobHandle[slots];
            for (int next = 0; next < things || !ring.IsEmpty;)
            {
                if (next < things && !ring.IsFull)
                {
                    while (window != null && !window.TryPrepareNext())
                        yield return default;
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
