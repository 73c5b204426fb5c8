using System.Collections;
using NUnit.Framework;
using Unity.PerformanceTesting;
using UnityEngine;
using UnityEngine.TestTools;

namespace FastPoints.UnityTests.Performance
{
    /// <summary>How a conversion leaves the editor's frames alone: frames without one and beside one, in one test, so that both
    /// see the same machine.</summary>
    public sealed class FrameRateTests : TestProjectFixture
    {
        const int Frames = 200, WarmUpFrames = 20;
        const int Points = 5_000_000; // Enough to last longer than the frames that are measured.

        [UnityTest, Performance]
        public IEnumerator EditorFrames_BesideAConversion_AreMeasured()
        {
            if (Application.isBatchMode)
                Assert.Ignore("in batch mode no window is drawn, and nothing is converted by itself");
            yield return Measure.Frames().SampleGroup(new SampleGroup("Frame, nothing converted")).WarmupCount(WarmUpFrames)
                .MeasurementCount(Frames).Run();

            TestProject.TakeScan(Points);
            yield return Measure.Frames().SampleGroup(new SampleGroup("Frame beside a conversion")).WarmupCount(WarmUpFrames)
                .MeasurementCount(Frames).Run();

            Assert.That(TestProject.IsConverting, Is.True, "the conversion was over before the frames were");
        }
    }
}
