using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Every point of a source once, block by block, several blocks in flight, in bounded memory.</summary>
    public static class SourceScan
    {
        /// <summary>Blocks in flight: one decoding on each worker and one being read for it.</summary>
        public static int DefaultSlots => 2 * Math.Max(1, Unity.Jobs.LowLevel.Unsafe.JobsUtility.JobWorkerCount + 1);

        /// <summary>Memory that the slots of one scan may take: with it a scan's resident set is bounded, whatever the number of
        /// cores and the size of the blocks.</summary>
        public const long MaxSlotBytes = 96L << 20;

        /// <summary>As many slots as <see cref="DefaultSlots"/>, or as fit into <see cref="MaxSlotBytes"/>: a block's columns and its
        /// bytes in the file.</summary>
        public static int SlotsFor(PointReader reader, PointSchema wanted)
        {
            if (reader.BlockCount == 0)
                return 1;
            long fileBytes = reader.BytesOfRange(new BlockRange(0, 0, reader.PointsInBlock(0)));
            long bytesPerSlot = (long)reader.MaxPointsPerBlock * wanted.BytesPerPoint + fileBytes;
            return (int)Math.Max(1, Math.Min(DefaultSlots, MaxSlotBytes / Math.Max(1, bytesPerSlot)));
        }

        /// <summary>Work for a pump: decodes <paramref name="wanted"/> of every block and hands each to the consumer.</summary>
        /// <param name="slots">Blocks in flight: memory is that of so many blocks.</param>
        public static IEnumerator<JobHandle> Run(PointReader reader, PointSchema wanted, IBlockConsumer consumer, int slots,
            StageProgress progress)
        {
            int blockCount = reader.BlockCount;
            if (blockCount == 0)
                yield break;
            slots = Math.Min(slots, blockCount);
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
                        reads[slot].Begin(new BlockRange(block, 0, reader.PointsInBlock(block)));
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
