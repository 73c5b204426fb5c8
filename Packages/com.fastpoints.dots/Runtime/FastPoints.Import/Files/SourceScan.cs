using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Visits every point of a source once, block by block, with several blocks in flight, in bounded memory.</summary>
    internal static class SourceScan
    {
        /// <summary>Blocks in flight: one decoding on each worker and one being read for it.</summary>
        public static int DefaultSlots => 2 * Math.Max(1, Unity.Jobs.LowLevel.Unsafe.JobsUtility.JobWorkerCount + 1);

        /// <summary>Limit of the memory of one scan's slots: it bounds a scan's resident set, whatever the number of cores and
        /// the size of blocks.</summary>
        public const long MaxSlotBytes = 96L << 20;

        /// <summary>Number of slots: <see cref="DefaultSlots"/>, or as many as fit into <see cref="MaxSlotBytes"/> with a block's
        /// columns and its bytes in the file.</summary>
        public static int SlotsFor(PointReader reader, PointSchema wanted) => SlotsFor(reader, wanted, 0, MaxSlotBytes);

        /// <param name="extraBytesPerPoint">Bytes that the consumer keeps for each point of a slot.</param>
        /// <param name="maxBytes">The limit for all slots together; there is always one.</param>
        public static int SlotsFor(PointReader reader, PointSchema wanted, int extraBytesPerPoint, long maxBytes) =>
            reader.BlockCount == 0 ? 1
                : Math.Min(DefaultSlots, SlotsIn(reader, wanted, extraBytesPerPoint, maxBytes));

        static int SlotsIn(PointReader reader, PointSchema wanted, int extraBytesPerPoint, long maxBytes)
        {
            long fileBytes = reader.BytesOfRange(new BlockRange(0, 0, reader.PointsInBlock(0)));
            long bytesPerSlot = (long)reader.MaxPointsPerBlock * (wanted.BytesPerPoint + extraBytesPerPoint) + fileBytes;
            return (int)Math.Max(1, Math.Min(int.MaxValue, maxBytes / Math.Max(1, bytesPerSlot)));
        }

        /// <summary>Slots for a pump that is ticked: as many at first as one that awaits each needs, and as many as memory
        /// allows where workers run out of them. See <see cref="SlotsFor(PointReader, PointSchema, int, long)"/>.</summary>
        /// <param name="chains">As in <see cref="Run(PointReader, PointSchema, IBlockConsumer, WorkAhead, int, int, int,
        /// StageProgress)"/>.</param>
        public static WorkAhead AheadFor(PointReader reader, PointSchema wanted, int extraBytesPerPoint, long maxBytes,
            int chains, Func<double> ms)
        {
            if (reader.BlockCount == 0)
                return new WorkAhead(1, 1, ms);
            int first = chains > 0 ? Math.Min(DefaultSlots, 2 * chains) : DefaultSlots;
            return new WorkAhead(first, SlotsIn(reader, wanted, extraBytesPerPoint, maxBytes), ms);
        }

        /// <summary>Work for a pump: decodes <paramref name="wanted"/> of every block and hands each to the consumer.</summary>
        /// <param name="slots">Blocks in flight, which determine the memory.</param>
        public static IEnumerator<Work> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer, int slots,
            StageProgress progress) =>
            Run(reader, wanted, consumer, new WorkAhead(slots, slots, () => 0), 0, 0, reader.BlockCount, progress);

        /// <summary>The same for some blocks: from <paramref name="firstBlock"/> to before <paramref name="endBlock"/>.</summary>
        /// <param name="ahead">Blocks in flight.</param>
        /// <param name="chains">The most blocks whose jobs run side by side; 0 for all that are in flight.</param>
        public static IEnumerator<Work> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer, WorkAhead ahead,
            int chains, int firstBlock, int endBlock, StageProgress progress) =>
            Run(reader, wanted, consumer, ahead, chains, firstBlock, endBlock,
                block => new BlockRange(block, 0, reader.PointsInBlock(block)), reader.MaxPointsPerBlock, progress);

        /// <summary>The same for ranges of blocks.</summary>
        /// <param name="rangeOf">A range by its number, from <paramref name="first"/> to before <paramref name="end"/>.</param>
        /// <param name="longest">The most points of a range.</param>
        public static IEnumerator<Work> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer, WorkAhead ahead,
            int chains, int first, int end, Func<int, BlockRange> rangeOf, int longest, StageProgress progress)
        {
            var throttle = consumer as IThrottledConsumer;
            long pointsDone = 0, bytesDone = 0;
            var reads = new List<BlockRead>();
            var consumed = new List<JobHandle>();
            var last = new JobHandle[chains];
            var inFlight = new Queue<int>();
            var spare = new Stack<int>();
            var newest = default(JobHandle);
            try
            {
                for (int next = first; next < end || inFlight.Count > 0;)
                {
                    if (next == end || inFlight.Count >= ahead.Count)
                    {
                        int done = inFlight.Peek();
                        ahead.Await();
                        yield return consumed[done];
                        ahead.Resume(next < end && newest.IsCompleted);
                        inFlight.Dequeue();
                        spare.Push(done);
                        consumed[done].Complete();
                        var read = reads[done];
                        read.Complete();
                        consumer.Completed(read, done);
                        pointsDone += read.Points.Count;
                        bytesDone += reader.BytesOfRange(read.Range);
                        progress?.Report((next - first - inFlight.Count) / (double)(end - first), pointsDone, bytesDone);
                        continue;
                    }
                    while (throttle != null && !throttle.IsReady)
                        yield return default;
                    if (spare.Count == 0)
                    {
                        spare.Push(reads.Count);
                        reads.Add(reader.CreateRead(wanted, longest, Allocator.Persistent));
                        consumed.Add(default);
                    }
                    int slot = spare.Pop();
                    if (chains > 0)
                        reads[slot].After = last[next % chains];
                    reads[slot].Begin(rangeOf(next));
                    consumed[slot] = newest = consumer.Schedule(reads[slot], slot, reads[slot].Decoded);
                    if (chains > 0)
                        last[next % chains] = newest;
                    inFlight.Enqueue(slot);
                    next++;
                    JobHandle.ScheduleBatchedJobs();
                    // The pump looks at its budget.
                    yield return default;
                }
            }
            finally
            {
                for (int i = 0; i < reads.Count; i++)
                {
                    consumed[i].Complete();
                    reads[i].Dispose();
                }
            }
        }
    }
}
