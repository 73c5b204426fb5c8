using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Samples prefixes of blocks from all over a source where nothing else is cheap (LAZ chunks): see
    /// <see cref="PrefixPlan"/> for how many of which.</summary>
    /// <remarks>A later wave decodes a block's prefix again to reach what follows it: a tenth of its own work if waves are ten
    /// times as large. Points of one prefix are neighbours, so the sample is coarser than a uniform one of as many
    /// points.</remarks>
    sealed class PrefixSampler : PreviewSampler
    {
        /// <summary>Shorter prefixes are decoded about as fast as they are read, so more of them are requested at a time, which a
        /// slow disk needs as well. A LAZ slot takes 1.5 MB.</summary>
        const int ShortPrefix = 1024, SlotsForShortPrefixes = 12;

        readonly PrefixPlan m_plan;
        readonly List<Prefix> m_taken = new List<Prefix>();
        BlockRead[] m_reads;
        NativeArray<PointColumn>[] m_columnsOfSlot;
        JobHandle[] m_copied;

        public PrefixSampler(PointReader reader, int wanted, uint seed)
            : base(reader, reader.PrefixesAreSpread && !reader.BlocksAreKnown ? wanted : (int)Math.Min(wanted, reader.PointCount),
                reader.Tree == null ? "prefixes of blocks, in waves" : "levels of its octree, in waves")
        {
            m_plan = new PrefixPlan(reader, seed);
        }

        /// <summary>Work for a pump: finds as many as the wave is spread over, and more if these have too few points.</summary>
        IEnumerator<Work> FindPrefixes(int wanted)
        {
            for (long places = wanted / PrefixPlan.LeastPoints + 1L; ; places *= 2)
            {
                yield return Work.Of(Reader.FindPrefixes((int)Math.Min(places, Reader.MaxPrefixes)));
                if (Reader.PointCount >= wanted || places >= Reader.MaxPrefixes)
                    break;
            }
        }

        private protected override IEnumerator<Work> Read(int wanted, int slots, StageProgress progress)
        {
            // Slots for prefixes of another length than in the wave before are made.
            Free();
            if (Reader.PrefixesAreSpread && !Reader.BlocksAreKnown)
                yield return Work.Of(FindPrefixes(wanted));
            var prefixes = m_plan.Next(wanted);
            int longest = 0;
            foreach (var prefix in prefixes)
                longest = Math.Max(longest, prefix.Count);
            if (longest == 0)
                yield break;
            if (slots < 1)
                slots = longest <= ShortPrefix ? SlotsForShortPrefixes : SourceScan.SlotsFor(Reader, Buffer.Points.Schema);
            Allocate(Math.Min(slots, prefixes.Count), longest);
            slots = m_reads.Length;
            for (int i = 0; i < prefixes.Count + slots; i++)
            {
                int slot = i % slots;
                if (i >= slots && i - slots < prefixes.Count)
                {
                    yield return m_copied[slot];
                    m_copied[slot].Complete();
                    m_reads[slot].Complete();
                    BytesRead += Reader.BytesOfRange(m_reads[slot].Range);
                    Report(progress);
                }
                if (i < prefixes.Count)
                    Begin(slot, prefixes[i]);
            }
            EndPlace = m_plan.Taken;
            m_taken.AddRange(prefixes);
        }

        void Allocate(int slots, int longest)
        {
            m_reads = new BlockRead[slots];
            m_columnsOfSlot = new NativeArray<PointColumn>[slots];
            m_copied = new JobHandle[slots];
            for (int i = 0; i < slots; i++)
            {
                m_reads[i] = Reader.CreateRead(Buffer.Points.Schema, longest, Allocator.Persistent);
                m_columnsOfSlot[i] = SampleBuffer.ColumnsOf(m_reads[i].Points);
            }
        }

        void Begin(int slot, in Prefix prefix)
        {
            var read = m_reads[slot];
            read.Begin(new BlockRange(prefix.Block, prefix.First, prefix.Count));
            m_copied[slot] = new CopyPrefixJob
            {
                Decoded = read.Points.Bytes,
                ColumnsOfDecoded = m_columnsOfSlot[slot],
                Result = read.Result,
                End = prefix.Count,
                ColumnsOfSample = Buffer.Columns,
                FirstPlace = prefix.Place,
                Sample = Buffer.Points.Bytes,
                Filled = Buffer.Filled,
            }.Schedule(read.Decoded);
            JobHandle.ScheduleBatchedJobs();
        }

        private protected override IEnumerator<Work> ListRuns(NativeList<SampleRun> runs)
        {
            // This is the file's order, which is not that in which lines were found by jumping.
            m_taken.Sort((a, b) => a.Block == b.Block ? a.First.CompareTo(b.First)
                : Reader.PlaceOfBlock(a.Block).CompareTo(Reader.PlaceOfBlock(b.Block)));
            double pointsOfBlocks = 0;
            for (int i = 0; i < m_taken.Count; i++)
                if (i == 0 || m_taken[i].Block != m_taken[i - 1].Block)
                    pointsOfBlocks += Reader.PointsInBlock(m_taken[i].Block);
            double scale = Reader.PointCount / Math.Max(1, pointsOfBlocks);
            // An end that is not read because another place was chosen by chance does not make a prefix.
            bool isSpread = Reader.PrefixesAreSpread && !Reader.BlocksAreKnown;
            bool isOfPrefixes = false;
            runs.Capacity = Math.Max(runs.Capacity, m_taken.Count);
            int stretch = 0;
            for (int first = 0, end; first < m_taken.Count; first = end, stretch++)
            {
                int block = m_taken[first].Block, taken = 0;
                for (end = first; end < m_taken.Count && m_taken[end].Block == block; end++)
                    taken += m_taken[end].Count;
                isOfPrefixes |= !isSpread && taken < Reader.PointsInBlock(block);
                for (int i = first; i < end; i++)
                    runs.Add(new SampleRun
                    {
                        Stretch = stretch,
                        First = m_taken[i].Place,
                        Count = m_taken[i].Count,
                        Weight = scale * Reader.PointsInBlock(block) / taken,
                    });
            }
            Sample.IsOfBlockPrefixes = isOfPrefixes;
            yield break;
        }

        private protected override void Free()
        {
            if (m_reads == null)
                return;
            for (int i = 0; i < m_reads.Length; i++)
            {
                m_copied[i].Complete();
                m_reads[i]?.Dispose();
                if (m_columnsOfSlot[i].IsCreated)
                    m_columnsOfSlot[i].Dispose();
            }
            m_reads = null;
        }
    }
}
