using System.IO;

namespace FastPoints.Benchmarks
{
    /// <summary>Real clouds for workloads, since synthetic ones compress differently (Documentation~/figures.md). Where one is
    /// absent, its workloads do nothing and report no points.</summary>
    static class BenchmarkSamples
    {
        public const string LazPointwise = "ca13_d.laz"; // Airborne, point format 2, pointwise chunks: 5.0 M points in 30 MB.
        public const string LazLayered = "lion.laz"; // A sculpture, point format 7, layered chunks: 4.0 M points in 25 MB.

        public const string PotreeDefault = "samples/potree/v2-mixedconifer-default";
        public const string EptLaszip = "samples/ept/lone-star-laszip";
        public const string PotreeBrotli = "samples/potree/v2-autzen-brotli";

        public static string Find(WorkloadContext context, string name)
        {
            if (context.DataFolder == null)
                return null;
            foreach (string folder in new[] { "data", "" })
            {
                string path = Path.Combine(context.DataFolder, folder, name);
                if (File.Exists(path) || Directory.Exists(path))
                    return path;
            }
            return null;
        }

        public static string FindCopc(WorkloadContext context) =>
            Find(context, "ca13_d.copc.laz") ?? Find(context, "samples/copc/lone-star.copc.laz");
    }
}
