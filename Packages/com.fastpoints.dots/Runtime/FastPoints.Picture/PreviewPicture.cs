using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using FastPoints.Drawing;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Collections;
using Unity.Mathematics;

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

    // Guesses the up axis of formats that do not say it: across the plane that most points lie in, the ground or a floor. Without
    // one it is Y, as models have it, but where coordinates are a survey's.
    static class UpAxisGuess
    {
        const double Thickness = 1.0 / 32; // Of the longest edge.
        const double MinRatio = 1.5; // So many times as many points lie in it as in the best plane across another axis.

        // Models lie about their origin. What is so many times its own size away from it was surveyed.
        const double MinSizesFromOrigin = 100;

        // All formats but PLY have Z up, by their standards or by custom.
        public static bool Applies(string format) => format != null && format.StartsWith("PLY", StringComparison.Ordinal);

        // The positions are a fair sample, outliers apart; the reason is a line for people.
        public static UpAxis Of(double3[] positions, out string reason)
        {
            var shares = new double3();
            double longest = 0, farthest = 0;
            var values = new double[3][];
            for (int axis = 0; axis < 3; axis++)
            {
                values[axis] = new double[positions.Length];
                for (int i = 0; i < positions.Length; i++)
                    values[axis][i] = positions[i][axis];
                Array.Sort(values[axis]);
                if (positions.Length == 0)
                    continue;
                longest = math.max(longest, values[axis][positions.Length - 1] - values[axis][0]);
                farthest = math.max(farthest, math.abs(values[axis][positions.Length / 2]));
            }
            int best = 2;
            for (int axis = 0; axis < 3; axis++)
            {
                shares[axis] = MaxPointsWithin(values[axis], longest * Thickness) / (double)math.max(1, positions.Length);
                best = shares[axis] > shares[best] ? axis : best;
            }
            double other = math.max(shares[(best + 1) % 3], shares[(best + 2) % 3]);
            bool isClear = shares[best] > MinRatio * other;
            string share = (100 * shares[best]).ToString("0", CultureInfo.InvariantCulture) + " %";
            bool isModel = positions.Length > 0 && farthest <= MinSizesFromOrigin * longest;
            var up = isClear ? (UpAxis)best : isModel ? UpAxis.Y : UpAxis.Z;
            reason = up + " is taken for up: " + (isClear ? share + " of the points lie in one plane across it"
                : "no plane across an axis has most points, and this looks like a " + (isModel ? "model" : "survey"));
            return up;
        }

        static int MaxPointsWithin(double[] sorted, double length)
        {
            int max = 0;
            for (int first = 0, end = 0; first < sorted.Length; first++)
            {
                while (end < sorted.Length && sorted[end] - sorted[first] <= length)
                    end++;
                max = math.max(max, end - first);
            }
            return max;
        }
    }
}
