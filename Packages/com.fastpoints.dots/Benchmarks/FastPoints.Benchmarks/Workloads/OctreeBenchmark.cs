using System;
using System.IO;
using FastPoints.Base;
using FastPoints.Files;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>What the workloads of EPT and Potree folders share: a whole scan into columns, and the bound of that.</summary>
    static class OctreeBenchmark
    {
        sealed class Counter : IBlockConsumer
        {
            public long Points;

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => decoded;

            public void Completed(BlockRead read, int slot) => Points += read.Points.Count;
        }

        /// <summary>Opens a cloud, reads its hierarchy and all attributes of all points.</summary>
        /// <param name="path">Null where there is no such cloud: nothing is done.</param>
        public static WorkloadResult Decode(string path)
        {
            if (path == null)
                return default;
            var counter = new Counter();
            using (var reader = PointReaders.Open(path))
            {
                WorkPump.RunToEnd(reader.FindBlocks());
                WorkPump.RunToEnd(SourceScan.Run(reader, reader.Info.Schema, counter, SourceScan.DefaultSlots, null));
                return new WorkloadResult { Points = counter.Points, Bytes = BytesOf(path) };
            }
        }

        /// <summary>Reads a cloud's files and copies as many bytes as its columns have, on one thread.</summary>
        public static WorkloadResult ReadAndCopy(string path, byte[] from, byte[] to)
        {
            if (path == null)
                return default;
            long points, bytes;
            using (var reader = PointReaders.Open(path))
            {
                WorkPump.RunToEnd(reader.FindBlocks());
                points = reader.PointCount;
                bytes = points * reader.Info.Schema.BytesPerPoint;
            }
            foreach (string file in Directory.EnumerateFiles(path, "*", SearchOption.AllDirectories))
                using (var stream = new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.Read, 1))
                    while (stream.Read(to, 0, to.Length) > 0)
                    {
                    }
            for (long at = 0; at < bytes; at += from.Length)
                Buffer.BlockCopy(from, 0, to, 0, (int)Math.Min(from.Length, bytes - at));
            return new WorkloadResult { Points = points, Bytes = BytesOf(path) };
        }

        /// <returns>A folder of the sample collection, or null where it is not there.</returns>
        public static string FindSample(WorkloadContext context, string format, string name)
        {
            if (context.DataFolder == null)
                return null;
            foreach (string folder in new[] { "data", "" })
            {
                string path = Path.Combine(context.DataFolder, folder, "samples", format, name);
                if (Directory.Exists(path))
                    return path;
            }
            return null;
        }

        static long BytesOf(string folder)
        {
            long bytes = 0;
            foreach (string file in Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories))
                bytes += new FileInfo(file).Length;
            return bytes;
        }
    }
}
