using System.IO;

namespace FastPoints.Benchmarks
{
    /// <summary>The COPC file that workloads share: five million points, where it was made (Documentation~/benchmarks.md); else
    /// half a million.</summary>
    static class CopcBenchmarkFile
    {
        static readonly string[] s_files = { "ca13_d.copc.laz", Path.Combine("samples", "copc", "lone-star.copc.laz") };

        /// <returns>Null where there is none.</returns>
        public static string Find(WorkloadContext context)
        {
            foreach (string file in s_files)
                if (LazBenchmarkFile.Find(context, file) is string path)
                    return path;
            return null;
        }
    }
}
