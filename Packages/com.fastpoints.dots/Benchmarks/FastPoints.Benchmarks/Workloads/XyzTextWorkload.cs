using System;
using System.Globalization;
using System.IO;
using System.Text;
using FastPoints.Base;
using FastPoints.Files;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    /// <summary>A text file (x, y, z in millimetres, intensity, colour) to columns; finding the lines is part of it.</summary>
    public struct XyzTextWorkload : IWorkload
    {
        sealed class Consumer : IBlockConsumer
        {
            public long Points;

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => decoded;

            public void Completed(BlockRead read, int slot) => Points += read.Points.Count;
        }

        string m_path;

        public string Name => "xyz text";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = Path.Combine(context.ScratchFolder, "xyz-" + context.Points + "-" + context.Seed + ".xyz");
            if (!File.Exists(m_path))
                Write(m_path, context.Points, (int)context.Seed);
            Run();
        }

        public WorkloadResult Run()
        {
            var consumer = new Consumer();
            using (var reader = PointReaders.Open(m_path))
            {
                WorkPump.RunToEnd(reader.FindBlocks());
                var wanted = reader.Info.Schema;
                WorkPump.RunToEnd(SourceScan.Run(reader, wanted, consumer, SourceScan.DefaultSlots, null));
                return new WorkloadResult { Points = consumer.Points, Bytes = reader.Info.FileBytes };
            }
        }

        public void Dispose()
        {
        }

        static void Write(string path, int points, int seed)
        {
            var random = new Random(seed);
            var lines = new StringBuilder();
            using (var writer = new StreamWriter(path, false, new UTF8Encoding(false), 1 << 20))
                for (int i = 0; i < points; i++)
                {
                    lines.Clear();
                    lines.Append((500000 + random.NextDouble() * 1000).ToString("F3", CultureInfo.InvariantCulture)).Append(' ');
                    lines.Append((4000000 + random.NextDouble() * 1000).ToString("F3", CultureInfo.InvariantCulture)).Append(' ');
                    lines.Append((random.NextDouble() * 50).ToString("F3", CultureInfo.InvariantCulture)).Append(' ');
                    int color = random.Next(1 << 24);
                    lines.Append(random.Next(1 << 16)).Append(' ').Append(color & 255).Append(' ')
                        .Append(color >> 8 & 255).Append(' ').Append(color >> 16).Append('\n');
                    writer.Write(lines.ToString());
                }
        }
    }
}
