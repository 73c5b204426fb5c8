using System;
using System.Collections.Generic;
using System.Diagnostics;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Takes a sample of a source by reading little of it, in waves, coarse to fine, each a prefix of the next one and
    /// spread over all of the source. The time it takes depends on the points wanted, hardly on the source's size.</summary>
    /// <remarks>The sample is the same for the same source, seed and number of points, on any number of threads and slots and any
    /// disk. All members belong to the thread of the coroutine.</remarks>
    internal abstract class PreviewSampler : IDisposable
    {
        /// <summary>Points at which a wave ends; the last one ends with the sample.</summary>
        static readonly int[] s_waves = { 2_000, 20_000, 200_000, 1_000_000, 4_000_000 };

        /// <summary>A wave that comes this near to the end continues to it: another one would show hardly more, and may decode
        /// all prefixes again.</summary>
        const double MinShareOfLast = 0.75;

        /// <summary>Where frames are farther apart, the machine was busy or the work was paused.</summary>
        const double MaxFrameMs = 250;

        readonly List<SampleWave> m_waves = new List<SampleWave>();
        readonly Stopwatch m_watch = new Stopwatch();
        PreviewSample m_sample;

        private protected PreviewSampler(PointReader reader, int placeCount, string method)
        {
            Reader = reader;
            Buffer = new SampleBuffer(SampleSchema.Of(reader.Info), placeCount);
            m_sample = Buffer.ShareSample(reader.Info.Transform);
            m_sample.Method = method;
            m_sample.HasKnownWeights = reader.Tree == null;
        }

        /// <summary>Raised on the coroutine's thread after each wave, which is a prefix of <see cref="Sample"/> that can be drawn
        /// from then on.</summary>
        public event Action<SampleWave> WaveReady;

        /// <summary>The waves so far.</summary>
        public IReadOnlyList<SampleWave> Waves => m_waves;

        /// <summary>The sample so far.</summary>
        public PreviewSample Sample => m_sample;

        private protected PointReader Reader { get; }

        private protected SampleBuffer Buffer { get; }

        private protected double Seconds => m_watch.Elapsed.TotalSeconds;

        private protected long BytesRead { get; set; }

        /// <summary>What fills the places up to <see cref="EndPlace"/>, where <see cref="Read"/> has not awaited it.</summary>
        private protected JobHandle Filling { get; set; }

        /// <summary>Number of places in the sample that the waves so far have reached.</summary>
        private protected int EndPlace { get; set; }

        /// <param name="reader">A reader whose blocks are known.</param>
        /// <param name="wanted">Number of points, limited to <see cref="PreviewSample.MaxPoints"/>.</param>
        /// <exception cref="PointCloudException">The source has no positions.</exception>
        public static PreviewSampler Create(PointReader reader, int wanted, uint seed)
        {
            wanted = Math.Max(0, Math.Min(wanted, PreviewSample.MaxPoints(SampleSchema.Of(reader.Info))));
            return reader is RecordReader ? (PreviewSampler)new RunSampler(reader, wanted, seed)
                : new PrefixSampler(reader, wanted, seed);
        }

        /// <summary>Reads in flight: so many, or at first as many as a coroutine needs that awaits each, and more where frames
        /// are so far apart that workers run out of them.</summary>
        internal static InFlightLimit LimitFor(PointReader reader, PointSchema schema, int slots, int first) => slots > 0
            ? new InFlightLimit(slots, slots, () => 0)
            : new InFlightLimit(first, SourceScan.SlotsIn(reader, schema, 0, SourceScan.MaxSlotBytes), () => MaxFrameMs);

        /// <summary>Takes the sample as a coroutine.</summary>
        /// <param name="slots">Reads in flight; 0 for a default.</param>
        public IEnumerator<JobStep> Run(int slots, StageProgress progress)
        {
            m_watch.Restart();
            try
            {
                for (int wave = 0; EndPlace < Buffer.Places; wave++)
                {
                    int first = EndPlace;
                    int wanted = PlacesOf(wave);
                    bool isLast = wanted == Buffer.Places;
                    yield return JobStep.Of(Read(wanted, isLast ? 0 : PlacesOf(wave + 1), slots, progress));
                    if (EndPlace > first)
                    {
                        yield return JobStep.Of(Close(first));
                        RaiseWave();
                        Report(progress);
                        // The wave belongs to the code that steps the work until the next step.
                        yield return default;
                    }
                    if (isLast)
                        break;
                }
            }
            finally
            {
                Free();
            }
        }

        /// <summary>The places that a wave is to reach.</summary>
        int PlacesOf(int wave) => wave >= s_waves.Length || s_waves[wave] >= MinShareOfLast * Buffer.Places ? Buffer.Places
            : s_waves[wave];

        /// <summary>Coroutine: reads more points into the following places, and moves <see cref="EndPlace"/> behind
        /// them.</summary>
        /// <param name="wanted">The approximate number of places to reach; all of them for the last wave.</param>
        /// <param name="next">The same of the wave after this one, which may be prepared; 0 for none.</param>
        private protected abstract IEnumerator<JobStep> Read(int wanted, int next, int slots, StageProgress progress);

        /// <summary>When <see cref="Filling"/> has ended.</summary>
        /// <exception cref="PointCloudException">A read failed.</exception>
        private protected virtual void EndReads() { }

        /// <summary>Coroutine: lists what the waves so far have read, by place.</summary>
        /// <param name="runs">An empty list to fill.</param>
        /// <param name="after">What its jobs come behind.</param>
        /// <param name="scheduled">Receives the handle of all jobs.</param>
        private protected abstract IEnumerator<JobStep> ListRuns(NativeList<SampleRun> runs, JobHandle after,
            Action<JobHandle> scheduled);

        /// <summary>Coroutine: all that makes a sample of a wave's places, in one chain behind what fills them.</summary>
        IEnumerator<JobStep> Close(int first)
        {
            var all = Filling;
            try
            {
                yield return JobStep.Of(Buffer.ScheduleClose(Reader.Info.Transform, first, EndPlace, all, closed =>
                    all = closed));
                if (m_sample.HasKnownWeights)
                {
                    m_sample.RunList.Clear();
                    yield return JobStep.Of(ListRuns(m_sample.RunList, all, listed => all = listed));
                    yield return JobStep.Of(Buffer.MoveRuns(m_sample.RunList, EndPlace, EndPlace, all));
                }
                yield return all;
            }
            finally
            {
                all.Complete();
            }
            Filling = default;
            EndReads();
            Buffer.EndClose();
        }

        /// <summary>Frees what <see cref="Read"/> needs and awaits jobs in flight. May be called twice.</summary>
        private protected abstract void Free();

        private protected void Report(StageProgress progress) =>
            progress?.Report(m_sample.Count / (double)Math.Max(1, Buffer.Places), m_sample.Count, BytesRead);

        void RaiseWave()
        {
            Buffer.Measure(m_sample);
            m_sample.BytesRead = BytesRead;
            m_sample.PointsInSource = Reader.PointCount;
            var wave = new SampleWave { Points = m_sample.Count, Seconds = Seconds, BytesRead = BytesRead };
            m_waves.Add(wave);
            WaveReady?.Invoke(wave);
        }

        /// <summary>Hands the sample over, once; null after that.</summary>
        public PreviewSample TakeSample()
        {
            var sample = m_sample;
            m_sample = null;
            return sample;
        }

        public void Dispose()
        {
            Free();
            Buffer.Dispose();
            m_sample?.Dispose();
            m_sample = null;
        }
    }

    /// <summary>What a preview keeps of each point: its position and what it can be coloured by.</summary>
    internal static class SampleSchema
    {
        /// <exception cref="PointCloudException">The source has no positions.</exception>
        public static PointSchema Of(SourceInfo info)
        {
            var names = new List<string>(info.SampledToo)
            {
                AttributeNames.X, AttributeNames.Y, AttributeNames.Z, AttributeNames.Intensity, AttributeNames.Classification,
                AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue,
            };
            var schema = info.Schema.Select(names.ToArray());
            if (!schema.Has(AttributeNames.X) || !schema.Has(AttributeNames.Y) || !schema.Has(AttributeNames.Z))
                throw new PointCloudException(FailureCode.Unsupported, info.Path, -1,
                    "nothing to draw: wanted attributes X, Y and Z, got " + info.Schema);
            return schema;
        }
    }

    /// <summary>A prefix of a sample that could be drawn before the rest was there.</summary>
    public struct SampleWave
    {
        /// <summary>The number of points in the prefix.</summary>
        public int Points;

        /// <summary>Time from the start of the sampling to the wave's last point.</summary>
        public double Seconds;

        /// <summary>Bytes of the file that were read up to here.</summary>
        public long BytesRead;
    }
}
