using System.Diagnostics;

// Nothing is profiled.
namespace Unity.Profiling
{
    public struct ProfilerMarker
    {
        public ProfilerMarker(string name) { }
        public ProfilerMarker(ProfilerCategory category, string name) { }
        public unsafe ProfilerMarker(char* name, int nameLen) { }
        public IntPtr Handle => default;
        [Conditional("ENABLE_PROFILER")] public void Begin() { }
        [Conditional("ENABLE_PROFILER")] public void End() { }
        public AutoScope Auto() => default;

        public struct AutoScope : IDisposable
        {
            public void Dispose() { }
        }
    }

    public readonly partial struct ProfilerCategory
    {
        public static ProfilerCategory Loading => new ProfilerCategory("Loading");
        public static ProfilerCategory Scripts => new ProfilerCategory("Scripts");
    }

    public enum ProfilerMarkerDataUnit : byte { Undefined, TimeNanoseconds, Bytes, Count, Percent, FrequencyHz }

    [Flags]
    public enum ProfilerCounterOptions : ushort { None = 0, FlushOnEndOfFrame = 2, ResetToZeroOnFlush = 4 }
}

namespace Unity.Profiling.LowLevel
{
    [Flags]
    public enum MarkerFlags : ushort { Default = 0, Script = 2, AvailabilityNonDevelopment = 8, Counter = 128 }

    public enum ProfilerMarkerDataType : byte
    {
        InstanceId = 1,
        Int32 = 2,
        UInt32 = 3,
        Int64 = 4,
        UInt64 = 5,
        Float = 6,
        Double = 7,
        String16 = 9,
        Blob8 = 11,
    }
}

namespace UnityEngine.Profiling
{
    public static class Profiler
    {
        public static bool enabled => false;
        [Conditional("ENABLE_PROFILER")] public static void BeginSample(string name) { }
        [Conditional("ENABLE_PROFILER")] public static void EndSample() { }
    }
}
