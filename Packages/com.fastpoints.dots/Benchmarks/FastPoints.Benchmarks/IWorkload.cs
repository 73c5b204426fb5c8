using System;
using System.IO;

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

    /// <summary>What the driver gives a workload to prepare with.</summary>
    public sealed class WorkloadContext
    {
        /// <summary>An existing folder for inputs that a workload makes; the driver deletes it afterwards.</summary>
        public string ScratchFolder;

        /// <summary>Folder of the real clouds, or null where there is none: a workload then makes its own input.</summary>
        public string DataFolder;

        /// <summary>Points that a made input should have.</summary>
        public int Points = 4_000_000;

        public uint Seed = 1;

        /// <summary>Where an input of a kind lies or is to be made.</summary>
        public string PathOf(string kind, string extension) =>
            Path.Combine(ScratchFolder, kind + "-" + Points + "-" + Seed + extension);
    }

    /// <summary>What one run of a workload did, beside the time that the driver takes.</summary>
    public struct WorkloadResult
    {
        /// <summary>Points (or elements, slices: whatever the workload counts) worked on.</summary>
        public long Points;

        /// <summary>Bytes of input worked on, or 0 where bytes mean nothing.</summary>
        public long Bytes;

        /// <summary>Error of the approximation in <see cref="ErrorUnit"/>; 0 for exact work.</summary>
        public double Error;

        /// <summary>Unit of <see cref="Error"/>, or null for exact work.</summary>
        public string ErrorUnit;

        /// <summary>Whether a larger <see cref="Error"/> is a better one, as of decibels.</summary>
        public bool ErrorIncreaseIsBetter;

        /// <summary>What a number does not say, or null.</summary>
        public string Note;
    }
}
