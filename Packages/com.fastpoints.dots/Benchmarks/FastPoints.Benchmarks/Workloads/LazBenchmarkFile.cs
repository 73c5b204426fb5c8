using System;
using System.IO;
using FastPoints.Base;
using FastPoints.Files;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>What the LAZ workloads share: real clouds, since made ones compress unlike them. Where these are absent a
    /// workload does nothing, and reports no points.</summary>
    static class LazBenchmarkFile
    {
        sealed class Counter : IBlockConsumer
        {
            public long Points;

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => decoded;

            public void Completed(BlockRead read, int slot) => Points += read.Points.Count;
        }

        /// <summary>Airborne, point format 2, pointwise chunks: 5.0 M points in 30 MB.</summary>
        public const string Pointwise = "ca13_d.laz";

        /// <summary>A sculpture, point format 7, layered chunks: 4.0 M points in 25 MB.</summary>
        public const string Layered = "lion.laz";

        /// <returns>Null where there is no such file.</returns>
        public static string Find(WorkloadContext context, string name)
        {
            if (context.DataFolder == null)
                return null;
            foreach (string folder in new[] { "data", "" })
            {
                string path = Path.Combine(context.DataFolder, folder, name);
                if (File.Exists(path))
                    return path;
            }
            return null;
        }

        /// <summary>Decodes attributes of all points, as many blocks at once as the machine has threads for.</summary>
        /// <param name="names">None for all attributes.</param>
        public static WorkloadResult Decode(string path, params string[] names)
        {
            if (path == null)
                return default;
            var counter = new Counter();
            using (var reader = PointReaders.Open(path))
            {
                var wanted = names.Length == 0 ? reader.Info.Schema : reader.Info.Schema.Select(names);
                WorkPump.RunToEnd(SourceScan.Run(reader, wanted, counter, SourceScan.DefaultSlots, null));
                return new WorkloadResult { Points = counter.Points, Bytes = reader.Info.FileBytes };
            }
        }

        /// <summary>Reads the file and copies as many bytes as its decoded records have.</summary>
        public static WorkloadResult ReadAndCopy(string path, byte[] from, byte[] to)
        {
            if (path == null)
                return default;
            using (var reader = PointReaders.Open(path))
            {
                using (var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, 1))
                    while (stream.Read(to, 0, to.Length) > 0)
                    {
                    }
                long bytes = reader.PointCount * reader.Info.RecordBytes;
                for (long at = 0; at < bytes; at += from.Length)
                    Buffer.BlockCopy(from, 0, to, 0, (int)Math.Min(from.Length, bytes - at));
                return new WorkloadResult { Points = reader.PointCount, Bytes = reader.Info.FileBytes };
            }
        }
    }
}
