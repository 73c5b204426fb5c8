using FastPoints.Build;
using FastPoints.Export;
using FastPoints.Nodes;
using FastPoints.Scenes;
using NUnit.Framework;
using StandIns.Scheduling;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.HostTests.Preview
{
    /// <summary>What verifying does to all points is cut; and what is measured across chunks is what comparing all with all
    /// gives.</summary>
    [NonParallelizable]
    public sealed class VerifySliceTests
    {
        string m_folder;

        [SetUp]
        public void MakeFolder() => m_folder = Directory.CreateTempSubdirectory("fastpoints-verify-").FullName;

        [TearDown]
        public void DeleteFolder() => Directory.Delete(m_folder, true);

        [Test]
        public void Verify_IsCut()
        {
            const int points = 400_000, maxPoints = 1 << 13, maxSearched = 1 << 12;
            string las = Path.Combine(m_folder, "a.las"), cloud = Path.Combine(m_folder, "a.fastpoints");
            JobCoroutine.RunToEnd(LasScan.Run(las, points, 1, ScanOrder.Strip, null));
            using (var reader = PointReaders.Open(las))
            {
                var settings = new ConvertSettings { Sampler = Sampler.Random, PointsPerChunk = 100_000 };
                JobCoroutine.RunToEnd(ConvertCloud.Run([reader], cloud, settings, _ => { }, null));
            }
            var result = new VerifyResult();
            JobTimes.Begin();
            Dictionary<Type, JobRuns> runs = null;
            try
            {
                JobCoroutine.RunToEnd(VerifyCloud.Run(cloud, [], result, null));
            }
            finally
            {
                runs = JobTimes.End();
            }
            Assert.That(result.Problems, Is.Empty);
            Assert.That(runs[typeof(VerifyNodesJob)].Count, Is.GreaterThanOrEqualTo(points / maxPoints));
            long sampled = result.Levels.Sum(level => level.SampledPoints);
            Assert.That(runs[typeof(MeasureSpacingJob)].Count, Is.GreaterThanOrEqualTo(sampled / maxSearched));
        }

        [TestCase(0.001)]
        [TestCase(0.02)]
        [TestCase(2)]
        public void CrossCheck_OfAnySpacing_IsAllAgainstAll(double spacing)
        {
            const int count = 9000, maxSearched = 1 << 12;
            var random = new Unity.Mathematics.Random(7);
            using var points = new NativeList<double3>(Allocator.Persistent);
            for (int i = 0; i < count; i++)
                points.Add(random.NextDouble3());
            using var none = new NativeList<double3>(Allocator.Persistent);
            using var equal = new NativeList<double3>(Allocator.Persistent) { points[0], points[1], points[0] };
            var levels = new List<VerifyResult.Level>();
            for (int i = 0; i < 3; i++)
                levels.Add(new VerifyResult.Level { Spacing = spacing });
            JobTimes.Begin();
            JobCoroutine.RunToEnd(CrossCheck.Run([none, points, equal], levels));
            var runs = JobTimes.End();
            double smallest = double.PositiveInfinity;
            int near = 0;
            for (int i = 0; i < count; i++)
            {
                double nearest = double.PositiveInfinity;
                for (int other = 0; other < count; other++)
                    if (other != i)
                        nearest = Math.Min(nearest, math.distancesq(points[i], points[other]));
                smallest = Math.Min(smallest, Math.Sqrt(nearest));
                near += Math.Sqrt(nearest) < spacing * (1 - 1e-9) ? 1 : 0;
            }
            Assert.That(levels[0].MinDistanceAcrossChunks, Is.EqualTo(double.PositiveInfinity));
            Assert.That(levels[1].MinDistanceAcrossChunks, Is.EqualTo(smallest));
            Assert.That(levels[1].NearAcrossChunks, Is.EqualTo(near));
            Assert.That(levels[2].MinDistanceAcrossChunks, Is.Zero);
            Assert.That(runs[typeof(CountNearJob)].Count, Is.GreaterThan(count / maxSearched));
        }
    }
}
