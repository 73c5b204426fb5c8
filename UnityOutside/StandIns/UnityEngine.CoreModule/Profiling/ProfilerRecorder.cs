namespace Unity.Profiling;

public readonly partial struct ProfilerCategory(string categoryName)
{
    private readonly string m_name = categoryName;

    public string Name => m_name;
    public static ProfilerCategory Memory => new ProfilerCategory("Memory");
}

[Flags]
public enum ProfilerRecorderOptions
{
    None = 0,
    WrapAroundWhenCapacityReached = 8,
    SumAllSamplesInFrame = 16,
    Default = WrapAroundWhenCapacityReached | SumAllSamplesInFrame,
}

/// <summary>Knows one counter, the bytes that a frame allocates, which has no frames here to begin anew.</summary>
public struct ProfilerRecorder : IDisposable
{
    private readonly bool m_isKnown;
    private readonly long m_begin;

    private ProfilerRecorder(bool isKnown)
    {
        m_isKnown = isKnown;
        m_begin = Allocated();
    }

    public bool Valid => m_isKnown;
    public long CurrentValue => m_isKnown ? Allocated() - m_begin : 0;

    public static ProfilerRecorder StartNew(ProfilerCategory category, string statName, int capacity = 1,
        ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) =>
        new ProfilerRecorder(category.Name == ProfilerCategory.Memory.Name && statName == "GC Allocated In Frame");

    public void Dispose() { }

#if NETSTANDARD
    private static long Allocated() => GC.GetTotalMemory(false);
#else
    private static long Allocated() => GC.GetTotalAllocatedBytes(true);
#endif
}
