using System;
using System.Globalization;
using System.IO;
using System.Text;

namespace FastPoints.Benchmarks
{
    static class XyzBenchmarkFile
    {
        public static string Make(WorkloadContext context)
        {
            string path = context.PathOf("xyz", ".xyz");
            if (!File.Exists(path))
                Write(path, context.Points, (int)context.Seed);
            return path;
        }

        static void Write(string path, int points, int seed)
        {
            var random = new Random(seed);
            var lines = new StringBuilder();
            using var writer = new StreamWriter(path, false, new UTF8Encoding(false), 1 << 20);
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
