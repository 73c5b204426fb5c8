using System.IO;

namespace FastPoints.Benchmarks
{
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
}
