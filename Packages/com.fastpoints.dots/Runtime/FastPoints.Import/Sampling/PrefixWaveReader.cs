using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Samples prefixes of blocks from all over a source where nothing else is cheap (LAZ chunks): see
    /// <see cref="PrefixPlan"/> for how many of which.</summary>
    /// <remarks>A later wave decodes a block's prefix again to reach what follows it: a tenth of its own work if waves are ten
    /// times as large. Points of one prefix are neighbours, so the sample is coarser than a uniform one of as many
    /// points.</remarks>
    sealed class PrefixWaveReader : PreviewWaveReader, IBlockConsumer
    {
        /// <summary>Shorter prefixes are decoded about as fast as they are read, so more of them are requested at a time, which a
        /// slow disk needs as well. A LAZ slot takes 1.5 MB.</summary>
        const int ShortPrefix = 1024, SlotsForShortPrefixes = 12;

        readonly PrefixPlan m_plan;
        readonly List<NativeArray<PointColumn>> m_columnsOfSlot = new List<NativeArray<PointColumn>>();
        ReadSlots m_slots;
        StageProgress m_progress;

        PrefixRange m_begun;

        public PrefixWaveReader(PointReader reader, int wanted, uint seed)
            : base(reader, reader is LineReader && !reader.BlocksAreKnown ? wanted : (int)Math.Min(wanted, reader.PointCount),
                reader.Tree == null ? "prefixes of blocks, in waves" : "levels of its octree, in waves")
        {
            m_plan = new PrefixPlan(reader, wanted, seed);
        }

        /// <summary>Coroutine: finds as many as the wave is spread over, and more if these have too few points.</summary>
        IEnumerator<JobStep> FindPrefixes(int wanted)
        {
            int max = Reader.TakesFewRanges ? PrefixPlan.MaxRemoteBlocks : LineReader.MaxPrefixes;
            for (long count = wanted / PrefixPlan.MinPoints + 1L; ; count *= 2)
            {
                yield return JobStep.Of(((LineReader)Reader).FindPrefixes((int)Math.Min(count, max)));
                if (Reader.PointCount >= wanted || count >= max)
                    break;
            }
        }

        public override IEnumerator<JobStep> Read(int wanted, int next, int slots, StageProgress progress)
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
            var ranges = prefixes.ConvertAll(p => new BlockRange(p.Block, p.First, p.Count));
            yield return JobStep.Of(m_slots.Run(this, ScanRanges.Of(Reader, ranges, longest), (read, n) =>
            {
                m_begun = prefixes[n];
                read.Begin(ranges[n]);
            }, null));
            // The next wave has prefixes of another length, and needs other slots.
            yield return JobStep.Of(m_slots.Free());
            Free();
            EndIndex = m_plan.Taken;
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
                MaxPoints = m_begun.Count,
                ColumnsOfSample = Buffer.Columns,
                FirstInSample = m_begun.FirstInSample,
                Sample = Buffer.Points.Bytes,
                Filled = Buffer.Filled,
            }.Schedule(decoded);
        }

        void IBlockConsumer.Completed(BlockRead read, int slot)
        {
            BytesRead += Reader.BytesOfRange(read.Range);
            Report(m_progress);
        }

        public override void Free()
        {
            m_slots?.Dispose();
            m_slots = null;
            foreach (var columns in m_columnsOfSlot)
                columns.Dispose();
            m_columnsOfSlot.Clear();
        }
    }

    /// <summary>Copies the first points of a decoded range to consecutive entries of the sample. Ranges go to disjoint entries,
    /// so any number of these may run at the same time.</summary>
    [BurstCompile]
    struct CopyPrefixJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Decoded;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfDecoded;
        [ReadOnly] public NativeReference<DecodeResult> Result;
        public int MaxPoints;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;
        public int FirstInSample;

        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Sample;
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Filled; // Set to 1 at each entry that is written.

        public unsafe void Execute()
        {
            int count = math.min(MaxPoints, Result.Value.Points);
            if (count <= 0)
                return;
            byte* from = (byte*)Decoded.GetUnsafeReadOnlyPtr();
            byte* to = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Sample);
            for (int column = 0; column < ColumnsOfSample.Length; column++)
            {
                int size = ColumnsOfSample[column].Type.SizeOf();
                UnsafeUtility.MemCpy(to + ColumnsOfSample[column].OffsetBytes + (long)FirstInSample * size,
                    from + ColumnsOfDecoded[column].OffsetBytes, (long)count * size);
            }
            var filled = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Filled);
            UnsafeUtility.MemSet(filled + FirstInSample, 1, count);
        }
    }
}
