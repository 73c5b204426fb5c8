using System.Collections;
using System.Diagnostics;

namespace Unity.PerformanceTesting.Measurements;

/// <summary>The time from one step of the coroutine to the next, which whoever steps it makes a frame.</summary>
public class FramesMeasurement
{
    private SampleGroup m_group = new SampleGroup("FrameTime");
    private int m_warmup;
    private int m_count;

    public FramesMeasurement SampleGroup(SampleGroup sampleGroup)
    {
        m_group = sampleGroup;
        return this;
    }

    public FramesMeasurement WarmupCount(int count)
    {
        m_warmup = count;
        return this;
    }

    public FramesMeasurement MeasurementCount(int count)
    {
        m_count = count;
        return this;
    }

    public IEnumerator Run()
    {
        for (int i = 0; i < m_warmup; i++)
            yield return null;
        for (int i = 0; i < m_count; i++)
        {
            var watch = Stopwatch.StartNew();
            yield return null;
            Measure.Custom(m_group, watch.Elapsed.TotalMilliseconds);
        }
    }
}
