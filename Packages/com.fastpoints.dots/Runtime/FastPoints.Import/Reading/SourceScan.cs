using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Jobs;

namespace FastPoints.Reading
{
    internal static class SourceScan
    {
        /// <summary>Blocks in flight: one decoding on each worker and one being read for it.</summary>
        public static int DefaultSlots => 2 * Math.Max(1, Unity.Jobs.LowLevel.Unsafe.JobsUtility.JobWorkerCount + 1);

        // Bounds a scan's resident set, whatever the number of cores and the size of blocks.
        public const long MaxSlotBytes = 96L << 20;

        public static int SlotsFor(PointReader reader, PointSchema wanted) => SlotsFor(reader, wanted, 0, MaxSlotBytes);

        // maxBytes is for all slots together; there is always one.
        public static int SlotsFor(PointReader reader, PointSchema wanted, int extraBytesPerPoint, long maxBytes) =>
            reader.BlockCount == 0 ? 1 : Math.Min(DefaultSlots, SlotsIn(reader, wanted, extraBytesPerPoint, maxBytes));

        internal static int SlotsIn(PointReader reader, PointSchema wanted, int extraBytesPerPoint, long maxBytes)
        {
            long fileBytes = reader.BytesOfRange(new BlockRange(0, 0, reader.PointsInBlock(0)));
            long bytesPerSlot = (long)reader.MaxPointsPerBlock * (wanted.BytesPerPoint + extraBytesPerPoint) + fileBytes
                + reader.DecoderBytes;
            return (int)Math.Max(1, Math.Min(int.MaxValue, maxBytes / Math.Max(1, bytesPerSlot)));
        }

        // Points that a worker takes in a millisecond at most: of records of one length, and of all others.
        const double RecordsPerMs = 8000, OthersPerMs = 2000;

        /// <summary>Slots for a coroutine that is ticked: as many at first as are done in the time, or as one that awaits each
        /// needs, and as many as memory allows where workers run out of them. See
        /// <see cref="SlotsFor(PointReader, PointSchema, int, long)"/>.</summary>
        /// <param name="chains">As in <see cref="Run(PointReader, PointSchema, IBlockConsumer, InFlightLimit, int, int, int,
        /// StageProgress)"/>.</param>
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

        /// <summary>Coroutine: decodes <paramref name="wanted"/> of every block and hands each to the consumer.</summary>
        /// <param name="slots">Blocks in flight, which determine the memory.</param>
        public static IEnumerator<JobStep> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer, int slots,
            StageProgress progress) =>
            Run(reader, wanted, consumer, new InFlightLimit(slots, slots, () => 0), 0, 0, reader.BlockCount, progress);

        /// <summary>The same for some blocks: from <paramref name="firstBlock"/> to before <paramref name="endBlock"/>.</summary>
        /// <param name="limit">Blocks in flight.</param>
        /// <param name="chains">The most blocks whose jobs run side by side; 0 for all that are in flight.</param>
        public static IEnumerator<JobStep> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer,
            InFlightLimit limit,
            int chains, int firstBlock, int endBlock, StageProgress progress) =>
            Run(reader, wanted, consumer, limit, chains, firstBlock, endBlock,
                block => new BlockRange(block, 0, reader.PointsInBlock(block)), reader.MaxPointsPerBlock, progress);

        /// <summary>The same for ranges of blocks.</summary>
        /// <param name="rangeOf">A range by its number, from <paramref name="first"/> to before <paramref name="end"/>.</param>
        /// <param name="longest">The most points of a range.</param>
        public static IEnumerator<JobStep> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer,
            InFlightLimit limit,
            int chains, int first, int end, Func<int, BlockRange> rangeOf, int longest, StageProgress progress)
        {
            using var slots = new ReadSlots(reader, wanted, longest, limit, chains);
            yield return JobStep.Of(slots.Run(consumer, first, end, (read, n) => read.Begin(rangeOf(n)), progress));
            yield return JobStep.Of(slots.Free());
        }
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
