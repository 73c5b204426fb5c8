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
        public static int SlotsFor(PointReader reader, PointSchema wanted, int extraBytesPerPoint, long maxBytes)
        {
            if (reader.BlockCount == 0)
                return 1;
            long fileBytes = reader.BytesOfRange(new BlockRange(0, 0, reader.PointsInBlock(0)));
            long bytesPerSlot = (long)reader.MaxPointsPerBlock * (wanted.BytesPerPoint + extraBytesPerPoint) + fileBytes;
            return (int)Math.Max(1, Math.Min(DefaultSlots, maxBytes / Math.Max(1, bytesPerSlot)));
        }

        /// <summary>Work for a pump: decodes <paramref name="wanted"/> of every block and hands each to the consumer.</summary>
        /// <param name="slots">Blocks in flight, which determine the memory.</param>
        public static IEnumerator<Work> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer, int slots,
            StageProgress progress) => Run(reader, wanted, consumer, slots, 0, reader.BlockCount, progress);

        /// <summary>The same for some blocks: from <paramref name="firstBlock"/> to before <paramref name="endBlock"/>.</summary>
        public static IEnumerator<Work> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer, int slots,
            int firstBlock, int endBlock, StageProgress progress)
        {
            int blockCount = endBlock - firstBlock;
            if (blockCount <= 0)
                yield break;
            slots = Math.Min(slots, blockCount);
            var throttle = consumer as IThrottledConsumer;
            long pointsDone = 0, bytesDone = 0;
            var reads = new BlockRead[slots];
            var consumed = new JobHandle[slots];
            try
            {
                for (int i = 0; i < slots; i++)
                    reads[i] = reader.CreateRead(wanted, reader.MaxPointsPerBlock, Allocator.Persistent);

                for (int block = 0; block < blockCount + slots; block++)
                {
                    int slot = block % slots;
                    if (block >= slots)
                    {
                        yield return consumed[slot];
                        consumed[slot].Complete();
                        var read = reads[slot];
                        read.Complete();
                        consumer.Completed(read, slot);
                        pointsDone += read.Points.Count;
                        bytesDone += reader.BytesOfRange(read.Range);
                        progress?.Report((block - slots + 1) / (double)blockCount, pointsDone, bytesDone);
                    }
                    if (block < blockCount)
                    {
                        while (throttle != null && !throttle.IsReady)
                            yield return default;
                        reads[slot].Begin(new BlockRange(firstBlock + block, 0, reader.PointsInBlock(firstBlock + block)));
                        consumed[slot] = consumer.Schedule(reads[slot], slot, reads[slot].Decoded);
                        JobHandle.ScheduleBatchedJobs();
                    }
                }
            }
            finally
            {
                for (int i = 0; i < slots; i++)
                {
                    consumed[i].Complete();
                    reads[i]?.Dispose();
                }
            }
        }
    }
}
