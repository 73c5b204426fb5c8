namespace Unity.PerformanceTesting;

/// <summary>The test that runs, and its samples.</summary>
public class PerformanceTest
{
    public List<SampleGroup> SampleGroups = new List<SampleGroup>();

    public PerformanceTest() => Active = this;

    public static PerformanceTest Active { get; set; }

    public static SampleGroup GetSampleGroup(string name) => Active.SampleGroups.Find(g => g.Name == name);
    public static void AddSampleGroup(SampleGroup sampleGroup) => Active.SampleGroups.Add(sampleGroup);
}
