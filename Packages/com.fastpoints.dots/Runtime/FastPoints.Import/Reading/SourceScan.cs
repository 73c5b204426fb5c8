using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Jobs;

namespace FastPoints.Reading
{
    internal static class SourceScan
    {
        // One block is decoded on each worker, and one read for it.
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

        // Coroutine: decodes what is wanted of every block and hands each to the consumer. The slots determine the memory.
        public static IEnumerator<JobStep> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer, int slots,
            StageProgress progress) =>
            Run(ScanRanges.Blocks(reader, 0, reader.BlockCount), wanted, consumer, new InFlightLimit(slots, slots, () => 0), 0,
                progress);

        // chains: the most ranges whose jobs run side by side; 0 for all that are in flight.
        public static IEnumerator<JobStep> Run(ScanRanges ranges, PointSchema wanted, IBlockConsumer consumer,
            InFlightLimit limit, int chains, StageProgress progress)
        {
            using var slots = new ReadSlots(ranges.Reader, wanted, ranges.Longest, limit, chains);
            yield return JobStep.Of(slots.Run(consumer, ranges.First, ranges.End,
                (read, n) => read.Begin(ranges.RangeOf(n)), progress));
            yield return JobStep.Of(slots.Free());
        }
    }

    // What is scanned of a source: ranges by their numbers, from First to before End.
    internal sealed class ScanRanges
    {
        public PointReader Reader;
        public int First;
        public int End;
        public Func<int, BlockRange> RangeOf;

        // Points of the longest range, or more.
        public int Longest;

        public static ScanRanges Blocks(PointReader reader, int first, int end) => new ScanRanges
        {
            Reader = reader,
            First = first,
            End = end,
            RangeOf = block => new BlockRange(block, 0, reader.PointsInBlock(block)),
            Longest = reader.MaxPointsPerBlock,
        };

        public static ScanRanges Of(PointReader reader, List<BlockRange> ranges, int longest) =>
            new ScanRanges { Reader = reader, End = ranges.Count, RangeOf = n => ranges[n], Longest = longest };
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
        // It may wait for a millisecond. Main thread.
        bool IsReady { get; }
    }
}
