using System;
using System.IO;

namespace FastPoints.Benchmarks
{
    /// <summary>One piece of work that is measured, prepared once, then run as often as the driver likes. The headless driver and
    /// Unity's performance tests time the same ones.</summary>
    public interface IWorkload : IDisposable
    {
        string Name { get; } // What is measured, for example las columns; unique over all workloads.

        /// <summary>Name of the workload that bounds this one (a plain read and copy, the same loop over raw pointers), whose
        /// time in the same run this one's is divided by; or null.</summary>
        string LimitName { get; }

        void Prepare(WorkloadContext context);

        WorkloadResult Run();
    }

    public sealed class WorkloadContext
    {
        public string ScratchFolder;

        /// <summary>Folder of the real clouds, or null if there is none: a workload then makes its own input.</summary>
        public string DataFolder;

        public int Points = 4_000_000;
        public uint Seed = 1;

        public string PathOf(string kind, string extension) =>
            Path.Combine(ScratchFolder, kind + "-" + Points + "-" + Seed + extension);
    }

    public struct WorkloadResult
    {
        public long Points;

        /// <summary>Bytes of input, or 0 if meaningless.</summary>
        public long Bytes;

        /// <summary>Error of the approximation in <see cref="ErrorUnit"/>; 0 for exact work.</summary>
        public double Error;

        /// <summary>Unit of <see cref="Error"/>, or null for exact work.</summary>
        public string ErrorUnit;

        public bool ErrorIncreaseIsBetter;

        /// <summary>What the numbers do not show, or null.</summary>
        public string Note;
    }
}
