using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Drawing;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Collections;

namespace FastPoints.Picture
{
    /// <summary>Makes a first picture of an open source: finds the blocks if necessary, takes a sample, measures and draws it.
    /// If finding blocks takes a pass over the whole file, waves from prefixes come before that.</summary>
    public sealed class PreviewPicture : IDisposable
    {
        readonly PointReader m_reader;
        readonly PreviewOptions m_options;
        readonly PreviewSampling m_sampling;

        public PreviewPicture(PointReader reader, PreviewOptions options)
        {
            m_reader = reader;
            m_options = options;
            var info = reader.Info;
            info.ExtraSampledAttributes = info.ExtraSampledAttributes
                .Union(options.Picture.AttributesToMeasure().Where(info.Schema.Has)).ToArray();
            m_sampling = new PreviewSampling(reader, options);
        }

        /// <summary>Raised when there is a sample to draw, coarse to fine; it is valid until the next step.</summary>
        public event Action<PreviewSample, PreviewSample.Wave> WaveReady
        {
            add => m_sampling.WaveReady += value;
            remove => m_sampling.WaveReady -= value;
        }

        public PreviewSample Sample => m_sampling.Sample;

        /// <summary>When each sample was ready, coarse to fine; the last one is <see cref="Sample"/>.</summary>
        public IReadOnlyList<PreviewSample.Wave> Waves => m_sampling.Waves;

        public DisplayRanges Ranges { get; private set; }

        internal PicturePlan Plan { get; private set; }

        /// <summary>Null until the work has ended.</summary>
        public RgbaImage Image { get; private set; }

        /// <summary>Coroutine, with the stages <c>sample</c>, FindBlocksStage, RefineStage and <c>draw</c>.</summary>
        public IEnumerator<JobStep> Run(StageProgress progress)
        {
            yield return JobStep.Of(TakeSample(progress));
            yield return JobStep.Of(PlanPicture());

            progress?.Begin("draw");
            // Here and below: each of these takes milliseconds.
            yield return default;
            using (var canvas = new PictureCanvas(m_options.Picture.WidthPx, m_options.Picture.HeightPx, Allocator.Persistent))
            {
                yield return default;
                yield return JobStep.Of(SamplePicture.ChooseSize(canvas, Sample.Points, Plan, Sample.Count));
                canvas.UseShadows(Plan.ShadowFrameOfPicture());
                yield return JobStep.Of(SamplePicture.DrawAndResolve(canvas, Sample.Points, Plan, progress));
                Image = canvas.ToImage();
            }
            progress?.End();
        }

        /// <summary>Coroutine: takes the sample alone.</summary>
        public IEnumerator<JobStep> TakeSample(StageProgress progress) => m_sampling.Run(progress);

        /// <summary>Coroutine, with a sample: finds <see cref="Ranges"/> and <see cref="Plan"/>.</summary>
        public IEnumerator<JobStep> PlanPicture()
        {
            yield return JobStep.Of(MeasureSample());
            string reason = null;
            if (m_options.Picture.GuessesUpAxis && UpAxisGuess.Applies(m_reader.Info.Format))
            {
                m_options.Picture.UpAxis = UpAxisGuess.Of(Ranges.FramingSample, out reason);
                Ranges = Ranges.WithUp(m_options.Picture.UpAxis);
            }
            Plan = new PicturePlan(m_options.Picture, Ranges, Sample.Transform);
            if (reason != null)
                Plan.Assumptions.Add(reason);
            int max = PreviewSample.MaxPoints(Sample.Points.Schema);
            if (m_options.Points > max && Sample.PointsInSource > max)
                Plan.Assumptions.Add("a sample of " + m_options.Points + " points does not fit in its memory: lowered to " +
                    max);
            if (Sample.NonFiniteCount > 0)
                Plan.Assumptions.Add(Sample.NonFiniteCount + " points of the sample have no finite position: left out");
        }

        IEnumerator<JobStep> MeasureSample()
        {
            Ranges = m_options.Picture.NewRanges(m_reader.Info.Crs.Units);
            return Ranges.Measure(Sample.Points, Sample.Transform, m_options.Picture.UpAxis);
        }

        public void Dispose() => m_sampling.Dispose();
    }

    /// <summary>Options of a <see cref="PreviewPicture"/>.</summary>
    public sealed class PreviewOptions : SampleOptions
    {
        public PictureOptions Picture = new PictureOptions();
    }
}
