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
        public void Verify_LargeCloud_IsSliced()
        {
            const int points = 400_000, maxPoints = 1 << 13;
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
        }

        [TestCase(0.001)]
        [TestCase(0.02)]
        [TestCase(2)]
        public void CountNear_AnySpacing_MatchesBruteForce(double spacing)
        {
            const int count = 9000;
            var random = new Unity.Mathematics.Random(7);
            using var points = new NativeList<double3>(Allocator.Persistent);
            for (int i = 0; i < count; i++)
                points.Add(random.NextDouble3());
            using var none = new NativeList<double3>(Allocator.Persistent);
            using var equal = new NativeList<double3>(Allocator.Persistent) { points[0], points[1], points[0] };
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
            Assert.That(CountNear(none, spacing), Is.EqualTo((double.PositiveInfinity, 0L)));
            Assert.That(CountNear(points, spacing), Is.EqualTo((smallest, (long)near)));
            Assert.That(CountNear(equal, spacing).Smallest, Is.Zero);
        }

        static (double Smallest, long Near) CountNear(NativeList<double3> points, double spacing)
        {
            (double, long) found = default;
            JobCoroutine.RunToEnd(MeasureSpacing.CountNear(points, spacing, (smallest, near) => found = (smallest, near)));
            return found;
        }
    }
}
