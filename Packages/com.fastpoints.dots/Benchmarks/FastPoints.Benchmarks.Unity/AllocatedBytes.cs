using System;
using Unity.Profiling;

namespace FastPoints.Benchmarks
{
    /// <summary>Managed bytes that were allocated since the frame began: a test that is no coroutine lies within one
    /// frame.</summary>
    sealed class AllocatedBytes : IDisposable
    {
        readonly ProfilerRecorder m_recorder = ProfilerRecorder.StartNew(ProfilerCategory.Memory, "GC Allocated In Frame");
        public bool IsCounted => m_recorder.Valid; // False if this Unity does not count them: then no bytes are no news.

        public long Now => m_recorder.CurrentValue;

        public void Dispose() => m_recorder.Dispose();
    }
}
