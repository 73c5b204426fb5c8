using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Samples prefixes of blocks from all over a source where nothing else is cheap (LAZ chunks): see
    /// <see cref="PrefixPlan"/> for how many of which.</summary>
    /// <remarks>A later wave decodes a block's prefix again to reach what follows it: a tenth of its own work if waves are ten
    /// times as large. Points of one prefix are neighbours, so the sample is coarser than a uniform one of as many
    /// points.</remarks>
    sealed class PrefixSampler : PreviewSampler, IBlockConsumer
    {
        /// <summary>Shorter prefixes are decoded about as fast as they are read, so more of them are requested at a time, which a
        /// slow disk needs as well. A LAZ slot takes 1.5 MB.</summary>
        const int ShortPrefix = 1024, SlotsForShortPrefixes = 12;

        readonly PrefixPlan m_plan;
        readonly List<Prefix> m_taken = new List<Prefix>();
        readonly List<NativeArray<PointColumn>> m_columnsOfSlot = new List<NativeArray<PointColumn>>();
        ReadSlots m_slots;
        StageProgress m_progress;

        /// <summary>The one that begins.</summary>
        Prefix m_begun;

        public PrefixSampler(PointReader reader, int wanted, uint seed)
            : base(reader, reader is LineReader && !reader.BlocksAreKnown ? wanted : (int)Math.Min(wanted, reader.PointCount),
                reader.Tree == null ? "prefixes of blocks, in waves" : "levels of its octree, in waves")
        {
            m_plan = new PrefixPlan(reader, seed);
        }

        /// <summary>Coroutine: finds as many as the wave is spread over, and more if these have too few points.</summary>
        IEnumerator<JobStep> FindPrefixes(int wanted)
        {
            for (long places = wanted / PrefixPlan.MinPoints + 1L; ; places *= 2)
            {
                yield return JobStep.Of(((LineReader)Reader).FindPrefixes((int)Math.Min(places, LineReader.MaxPrefixes)));
                if (Reader.PointCount >= wanted || places >= LineReader.MaxPrefixes)
                    break;
            }
        }

        private protected override IEnumerator<JobStep> Read(int wanted, int next, int slots, StageProgress progress)
        {
            if (Reader is LineReader && !Reader.BlocksAreKnown)
                yield return JobStep.Of(FindPrefixes(wanted));
            var prefixes = m_plan.Next(wanted);
            int longest = 0;
            foreach (var prefix in prefixes)
                longest = Math.Max(longest, prefix.Count);
            if (longest == 0)
                yield break;
            int first = longest <= ShortPrefix ? SlotsForShortPrefixes : SourceScan.SlotsFor(Reader, Buffer.Points.Schema);
            m_progress = progress;
            m_slots = new ReadSlots(Reader, Buffer.Points.Schema, longest,
                LimitFor(Reader, Buffer.Points.Schema, slots, first), 0);
            yield return JobStep.Of(m_slots.Run(this, 0, prefixes.Count, (read, n) =>
            {
                m_begun = prefixes[n];
                read.Begin(new BlockRange(m_begun.Block, m_begun.First, m_begun.Count));
            }, null));
            // Slots for prefixes of another length than in this wave are made.
            yield return JobStep.Of(m_slots.Free());
            Free();
            EndPlace = m_plan.Taken;
            m_taken.AddRange(prefixes);
        }

        JobHandle IBlockConsumer.Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            while (m_columnsOfSlot.Count <= slot)
                m_columnsOfSlot.Add(SampleBuffer.ColumnsOf(read.Points));
            return new CopyPrefixJob
            {
                Decoded = read.Points.Bytes,
                ColumnsOfDecoded = m_columnsOfSlot[slot],
                Result = read.Result,
                End = m_begun.Count,
                ColumnsOfSample = Buffer.Columns,
                FirstPlace = m_begun.Place,
                Sample = Buffer.Points.Bytes,
                Filled = Buffer.Filled,
            }.Schedule(decoded);
        }

        void IBlockConsumer.Completed(BlockRead read, int slot)
        {
            BytesRead += Reader.BytesOfRange(read.Range);
            Report(m_progress);
        }

        private protected override IEnumerator<JobStep> ListRuns(NativeList<SampleRun> runs, JobHandle after,
            Action<JobHandle> scheduled)
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
            bool isSpread = Reader is LineReader && !Reader.BlocksAreKnown;
            bool isOfPrefixes = false;
            runs.Capacity = Math.Max(runs.Capacity, m_taken.Count);
            int segment = 0;
            for (int first = 0, end; first < m_taken.Count; first = end, segment++)
            {
                int block = m_taken[first].Block, taken = 0;
                for (end = first; end < m_taken.Count && m_taken[end].Block == block; end++)
                    taken += m_taken[end].Count;
                isOfPrefixes |= !isSpread && taken < Reader.PointsInBlock(block);
                for (int i = first; i < end; i++)
                    runs.Add(new SampleRun
                    {
                        Segment = segment,
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
            m_slots?.Dispose();
            m_slots = null;
            foreach (var columns in m_columnsOfSlot)
                columns.Dispose();
            m_columnsOfSlot.Clear();
        }
    }
}
