using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Streaming;
using Unity.Collections;

namespace FastPoints.Sources
{
    // The states of files that are not converted: waves of a preview, coarse to fine, copied in jobs; or, for a source with an
    // octree, the whole of it, streamed directly.
    internal sealed class SourceFeed : CloudFeed
    {
        public const int PreviewPoints = 1_000_000; // About what a screen shows, with the slots of its reads below 200 MB.
        const int PointsOfTop = 50_000; // Points of an octree's upper levels from which colours are chosen.

        readonly StageProgress m_progress = new StageProgress();
        readonly string m_path;
        readonly JobCoroutine m_coroutine;
        readonly int m_previewPoints;
        PointReader m_reader;
        SampleReader m_sample;
        PreviewSample m_wave;
        CloudFacts m_newest;
        bool m_skipsFullPass;

        // It owns the reader. previewPoints: of a source without an octree; a smaller one is shown whole.
        public SourceFeed(PointReader reader, int previewPoints = PreviewPoints)
        {
            m_reader = reader;
            m_previewPoints = previewPoints;
            m_path = reader.Info.Path;
            m_coroutine = new JobCoroutine(reader.Tree != null ? OpenTree() : SamplePreview());
        }

        public override CloudFacts Newest => m_newest;
        public override bool IsEnded => m_coroutine.IsDone;

        public override NodeSource Take(params string[] planes)
        {
            m_newest = null;
            var source = new TreeSource(m_sample ?? m_reader, planes);
            if (source.Reader == m_sample)
                m_sample = null;
            else
                m_reader = null;
            return source;
        }

        public override void Update(double budgetMs)
        {
            m_coroutine.Tick(budgetMs);
            // The octree's reader is passed on, or waits for that.
            if (!m_coroutine.IsDone || m_reader == null || m_reader.Tree != null)
                return;
            m_reader.Dispose();
            m_reader = null;
        }

        public override void SkipFullPass() => m_skipsFullPass = true;

        public override void Dispose()
        {
            m_coroutine.Cancel();
            m_sample?.Dispose();
            m_sample = null;
            m_reader?.Dispose();
            m_reader = null;
        }

        IEnumerator<JobStep> OpenTree()
        {
            yield return JobStep.Of(TreeSource.ReadTop(m_reader));
            PointBatch top = null;
            var ranges = NewRanges();
            try
            {
                yield return JobStep.Of(TreeTop.Read(m_reader, ColorModes.AttributesToMeasure(ColorMode.Auto), PointsOfTop,
                    batch => top = batch));
                yield return JobStep.Of(ranges.Measure(top, m_reader.Info.Transform, UpAxis.Z));
            }
            finally
            {
                top?.Dispose();
            }
            m_newest = Describe(CloudStage.Whole, ranges, m_reader.Tree.Cube);
        }

        IEnumerator<JobStep> SamplePreview()
        {
            using var preview = new PreviewSampling(m_reader, new SampleOptions { Points = m_previewPoints });
            preview.WaveReady += (sample, _) => m_wave = sample;
            using var sampling = new CoroutineStack(preview.Run(m_progress));
            while (!IsPassSkipped && sampling.MoveNext())
            {
                if (m_wave != null)
                    yield return JobStep.Of(KeepWave());
                yield return sampling.Current;
            }
        }

        // The next step would decode all of the source, which a build does anyway.
        bool IsPassSkipped => m_skipsFullPass &&
            (m_progress.Current == PreviewSampling.RefineStage || m_progress.Current == PreviewSampling.FindBlocksStage);

        IEnumerator<JobStep> KeepWave()
        {
            var wave = m_wave;
            m_wave = null;
            SampleReader copy = null;
            bool isKept = false;
            try
            {
                yield return JobStep.Of(SampleReader.Copy(wave, m_path, copied => copy = copied));
                copy.Info.Crs = m_reader.Info.Crs;
                var ranges = NewRanges();
                yield return JobStep.Of(ranges.Measure(copy.Points, wave.Transform, UpAxis.Z));
                m_sample?.Dispose();
                m_sample = copy;
                m_newest = Describe(wave.HasAllPoints ? CloudStage.Whole : CloudStage.Preview, ranges, wave.Bounds);
                isKept = true;
            }
            finally
            {
                if (!isKept)
                    copy?.Dispose();
            }
        }

        DisplayRanges NewRanges() => new DisplayRanges { Units = m_reader.Info.Crs.Units };

        // seen: bounds to use if the source claims none.
        CloudFacts Describe(CloudStage stage, DisplayRanges ranges, BoundsGeo seen)
        {
            var info = m_reader.Info;
            return new CloudFacts
            {
                Stage = stage,
                BoundsGeo = info.BoundsIfFinite.IsEmpty ? seen : info.BoundsIfFinite,
                Units = info.Crs.Units,
                Ranges = ranges,
            };
        }
    }

    internal static class TreeTop
    {
        const int MaxSlots = 8;

        // Coroutine, after ReadTop. Whole nodes until there are as many points as wanted; the receiver owns the batch.
        public static IEnumerator<JobStep> Read(PointReader reader, string[] attributes, int wanted, Action<PointBatch> read)
        {
            var blocks = new List<int>();
            int points = 0, max = 1;
            for (int node = 0; node < reader.Tree.NodeCount && points < wanted; node++)
            {
                if (reader.Tree[node].Block < 0)
                    continue;
                blocks.Add(reader.Tree[node].Block);
                points += reader.Tree[node].PointCount;
                max = Math.Max(max, reader.Tree[node].PointCount);
            }
            var names = new List<string> { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            names.AddRange(attributes);
            var schema = reader.Info.Schema.Select(names.ToArray());
            var top = new PointBatch(schema, Math.Max(1, points), Allocator.Persistent);
            var slots = new BlockRead[Math.Min(MaxSlots, blocks.Count)];
            BlockRange RangeOf(int i) => new BlockRange(blocks[i], 0, reader.PointsInBlock(blocks[i]));
            using var window = reader.WindowOf(0, blocks.Count, RangeOf);
            bool isDone = false;
            try
            {
                yield return JobStep.Of(SlotRing.Run(slots.Length, blocks.Count, (slot, i) =>
                {
                    slots[slot] ??= reader.CreateRead(schema, max, Allocator.Persistent);
                    slots[slot].Fetched = window?.Take();
                    slots[slot].Begin(RangeOf(i));
                    return slots[slot].Decoded;
                }, slot =>
                {
                    slots[slot].Complete();
                    Append(slots[slot].Points, top);
                }, window));
                isDone = true;
            }
            finally
            {
                foreach (var slot in slots)
                    slot?.Dispose();
                if (!isDone)
                    top.Dispose();
            }
            read(top);
        }

        static void Append(PointBatch from, PointBatch to)
        {
            for (int c = 0; c < to.Schema.Count; c++)
            {
                int size = to.Schema[c].Type.SizeOf();
                NativeArray<byte>.Copy(from.Bytes, from.Column(c).OffsetBytes, to.Bytes,
                    to.Column(c).OffsetBytes + to.Count * size, from.Count * size);
            }
            to.Count += from.Count;
        }
    }
}
