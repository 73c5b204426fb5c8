using Unity.PerformanceTesting.Measurements;

namespace Unity.PerformanceTesting;

public static class Measure
{
    public static void Custom(SampleGroup sampleGroup, double value)
    {
        if (double.IsNaN(value))
            throw new ArgumentException($"{sampleGroup.Name}: not a number");
        SampleGroup known = PerformanceTest.GetSampleGroup(sampleGroup.Name);
        if (known == null)
            PerformanceTest.AddSampleGroup(known = sampleGroup);
        known.Samples.Add(value);
    }

    public static FramesMeasurement Frames() => new FramesMeasurement();
}
