using System.Linq;
using FastPoints.Benchmarks;
using NUnit.Framework;

namespace FastPoints.Tests.Benchmarks
{
    public sealed class WorkloadSamplesTests
    {
        static WorkloadSamples Of(WorkloadResult result, WorkloadSamples limit, params double[] ms)
        {
            var samples = new WorkloadSamples("work", limit);
            foreach (double time in ms)
                samples.Add(time, 0, result);
            return samples;
        }

        static SampleSeries Series(WorkloadSamples samples, string name) => samples.Series().Single(s => s.Name == name);

        [Test]
        public void Series_PointsAndBytes_AreByTheSecondOfEachSample()
        {
            WorkloadSamples samples = Of(new WorkloadResult { Points = 100, Bytes = 3000 }, null, 1, 2);

            Assert.That(Series(samples, WorkloadSamples.Time).Samples, Is.EqualTo(new[] { 1.0, 2.0 }));
            Assert.That(Series(samples, WorkloadSamples.PointsPerSecond).Samples, Is.EqualTo(new[] { 100_000.0, 50_000.0 }));
            Assert.That(Series(samples, WorkloadSamples.PointsPerSecond).IncreaseIsBetter, Is.True);
            Assert.That(Series(samples, WorkloadSamples.BytesPerSecond).Samples, Is.EqualTo(new[] { 3_000_000.0, 1_500_000.0 }));
        }

        [Test]
        public void Series_ExactWork_HasZeroError()
        {
            SampleSeries error = Series(Of(new WorkloadResult { Points = 1 }, null, 1, 2), WorkloadSamples.Error);

            Assert.That(error.Samples, Is.EqualTo(new[] { 0.0, 0.0 }));
        }

        [Test]
        public void Series_ErrorInDecibels_HasItsUnitAndDirection()
        {
            var result = new WorkloadResult { Points = 1, Error = 30, ErrorUnit = "dB", ErrorIncreaseIsBetter = true };

            SampleSeries error = Series(Of(result, null, 1), "Error (dB)");

            Assert.That(error.Samples, Is.EqualTo(new[] { 30.0 }));
            Assert.That(error.IncreaseIsBetter, Is.True);
        }

        [Test]
        public void Series_InfiniteError_IsSkipped() => Assert.That(
            Series(Of(new WorkloadResult { Points = 1, Error = double.PositiveInfinity }, null, 1),
                WorkloadSamples.Error).Samples, Is.Empty);

        [Test]
        public void TimesTheLimit_OtherNumberOfPoints_IsByPoint()
        {
            WorkloadSamples limit = Of(new WorkloadResult { Points = 200 }, null, 10, 20);
            WorkloadSamples work = Of(new WorkloadResult { Points = 100 }, limit, 10, 30);

            Assert.That(work.RatioToLimit, Is.EqualTo(new[] { 2.0, 3.0 }));
        }

        [Test]
        public void TimesTheLimit_WithoutInput_IsNone()
        {
            WorkloadSamples work = Of(default, Of(new WorkloadResult { Points = 1 }, null, 10), 10);

            Assert.That(work.HadInput, Is.False);
            Assert.That(work.RatioToLimit, Is.Empty);
        }

        [TestCase(2.0, 3.0, 1.0, 2.0), TestCase(1.5, 1.0, 2.0), TestCase(0.0)]
        public void Median_OfValues_IsTheMiddle(double median, params double[] values) =>
            Assert.That(WorkloadSamples.Median(values), Is.EqualTo(median));
    }
}
