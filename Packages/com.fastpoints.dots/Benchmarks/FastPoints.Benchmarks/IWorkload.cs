using System;

namespace FastPoints.Benchmarks
{
    /// <summary>One piece of work that is measured, prepared once, then run as often as the driver likes. The headless driver and
    /// Unity's performance tests time the same ones.</summary>
    public interface IWorkload : IDisposable
    {
        /// <summary>What is measured, for example <c>las columns</c>; unique over all workloads.</summary>
        string Name { get; }

        /// <summary>Name of the workload that bounds this one (a plain read and copy, the same loop over raw pointers), whose
        /// time in the same run this one's is divided by; or null.</summary>
        string LimitName { get; }

        /// <summary>Allocates, makes its input and loads it. Not timed.</summary>
        void Prepare(WorkloadContext context);

        /// <summary>The timed work, finished when it returns.</summary>
        WorkloadResult Run();
    }
}
