namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public struct FrameTiming
{
    public double cpuFrameTime;
    public double cpuMainThreadFrameTime;
    public double cpuMainThreadPresentWaitTime;
    public double cpuRenderThreadFrameTime;
    public double gpuFrameTime;
    public ulong frameStartTimestamp;
    public ulong firstSubmitTimestamp;
    public ulong cpuTimePresentCalled;
    public ulong cpuTimeFrameComplete;
    public float heightScale;
    public float widthScale;
    public uint syncInterval;
}

/// <summary>Off, as in players, until a test gives the frames' times.</summary>
public static class FrameTimingManager
{
    const int LatencyFrames = 4;

    static readonly List<double> s_gpuMs = new List<double>();
    static int s_captured;

    /// <summary>A frame has ended that took the device so long; 0 was not measured. Null turns measuring off.</summary>
    internal static void EndFrame(double? gpuMs)
    {
        if (gpuMs is { } ms)
            s_gpuMs.Add(ms);
        else
            s_gpuMs.Clear();
        s_captured = System.Math.Min(s_captured, s_gpuMs.Count);
    }

    public static bool IsFeatureEnabled() => s_gpuMs.Count > 0;

    public static void CaptureFrameTimings() => s_captured = System.Math.Max(0, s_gpuMs.Count - LatencyFrames);

    /// <returns>How many there are: of what was captured, the latest first, four frames late.</returns>
    public static uint GetLatestTimings(uint numFrames, FrameTiming[] timings)
    {
        int count = System.Math.Min(s_captured, System.Math.Min((int)numFrames, timings.Length));
        for (int i = 0; i < count; i++)
        {
            int frame = s_captured - 1 - i;
            timings[i] = new FrameTiming { gpuFrameTime = s_gpuMs[frame], frameStartTimestamp = (ulong)frame + 1 };
        }
        return (uint)count;
    }
}
