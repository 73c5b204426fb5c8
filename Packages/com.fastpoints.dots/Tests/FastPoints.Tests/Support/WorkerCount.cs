using System;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Tests
{
    public readonly struct WorkerCount : IDisposable
    {
        readonly int m_before;

        public WorkerCount(int workers)
        {
            m_before = JobsUtility.JobWorkerCount;
            JobsUtility.JobWorkerCount = Math.Min(workers, JobsUtility.JobWorkerMaximumCount);
        }

        public void Dispose() => JobsUtility.JobWorkerCount = m_before;
    }
}
