using System;
using System.IO;
using System.Text;

namespace FastPoints.Benchmarks
{
    static class PlyBenchmarkFile
    {
        public const int RecordBytes = 15;

        public static string Make(WorkloadContext context, bool isAscii)
        {
            string path = context.PathOf(isAscii ? "ply-ascii" : "ply-binary", ".ply");
            if (File.Exists(path))
                return path;
            var random = new Random((int)context.Seed);
            using var stream = new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.None, 1 << 20);
            Write(stream, "ply\nformat " + (isAscii ? "ascii" : "binary_little_endian") + " 1.0\nelement vertex " +
                          context.Points + "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n" +
                          "property uchar green\nproperty uchar blue\nend_header\n");
            var record = new byte[RecordBytes];
            var line = new StringBuilder();
            for (int i = 0; i < context.Points; i++)
            {
                float x = (float)(random.NextDouble() * 1000), y = (float)(random.NextDouble() * -1000);
                float z = (float)(random.NextDouble() * 50);
                int color = random.Next(1 << 24);
                if (isAscii)
                {
                    line.Clear();
                    line.Append(NumberText.Of(x)).Append(' ');
                    line.Append(NumberText.Of(y)).Append(' ');
                    line.Append(NumberText.Of(z)).Append(' ');
                    line.Append(color & 255).Append(' ').Append(color >> 8 & 255).Append(' ')
                        .Append(color >> 16).Append('\n');
                    Write(stream, line.ToString());
                    continue;
                }
                BitConverter.TryWriteBytes(new Span<byte>(record, 0, 4), x);
                BitConverter.TryWriteBytes(new Span<byte>(record, 4, 4), y);
                BitConverter.TryWriteBytes(new Span<byte>(record, 8, 4), z);
                record[12] = (byte)color;
                record[13] = (byte)(color >> 8);
                record[14] = (byte)(color >> 16);
                stream.Write(record, 0, RecordBytes);
            }
            return path;
        }

        public static unsafe void Decode(byte* source, byte* target, int points)
        {
            const int Segment = PlainPassWorkload.SegmentPoints;
            uint* x = (uint*)target, y = x + Segment, z = y + Segment;
            byte* red = (byte*)(z + Segment), green = red + Segment, blue = green + Segment;
            for (int i = 0; i < points; i++, source += RecordBytes)
            {
                x[i] = *(uint*)source;
                y[i] = *(uint*)(source + 4);
                z[i] = *(uint*)(source + 8);
                red[i] = source[12];
                green[i] = source[13];
                blue[i] = source[14];
            }
        }

        static void Write(Stream stream, string text)
        {
            byte[] bytes = Encoding.ASCII.GetBytes(text);
            stream.Write(bytes, 0, bytes.Length);
        }
    }
}
