using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;

namespace FastPoints.Tests
{
    static class PcdTestFile
    {
        public const string Fields = "FIELDS x y z rgb _ intensity f\nSIZE 4 4 8 4 1 2 4\nTYPE F F F U U U F\n" +
            "COUNT 1 1 1 1 2 1 3\n";
        static readonly int[] s_fieldBytes = { 4, 4, 8, 4, 2, 2, 12 };

        public static uint ColorOf(int i) => (uint)(i * 7 % 256 << 16 | i * 5 % 256 << 8 | i * 3 % 256);

        public static byte[] Make(string data, int points, string head = "# .PCD v0.7 - Point Cloud Data file format\n")
        {
            string header = head + "VERSION 0.7\n" + Fields + "WIDTH " + points + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
                points + "\nDATA " + data + "\n";
            var file = new MemoryStream();
            byte[] text = Encoding.ASCII.GetBytes(header);
            file.Write(text, 0, text.Length);
            byte[] body = data == "ascii" ? Ascii(points) : data == "binary" ? Records(points) : Compressed(points);
            file.Write(body, 0, body.Length);
            return file.ToArray();
        }

        static byte[] Ascii(int points) => Encoding.ASCII.GetBytes(string.Concat(Enumerable.Range(0, points).Select(i =>
            i + ".5 " + -i + " " + i + "e-3 " + ColorOf(i) + " 0 0 " + i % 1000 + " " + i + " 1 2\n")));

        static byte[] Records(int points)
        {
            using var records = new MemoryStream();
            using var writer = new BinaryWriter(records);
            for (int i = 0; i < points; i++)
            {
                writer.Write(i + 0.5f);
                writer.Write((float)-i);
                writer.Write(i * 1e-3);
                writer.Write(ColorOf(i));
                writer.Write((short)0);
                writer.Write((ushort)(i % 1000));
                writer.Write((float)i);
                writer.Write(1f);
                writer.Write(2f);
            }
            return records.ToArray();
        }

        static byte[] Compressed(int points)
        {
            byte[] records = Records(points);
            int stride = s_fieldBytes.Sum(), at = 0;
            var columns = new List<byte>(records.Length);
            foreach (int bytes in s_fieldBytes)
            {
                for (int i = 0; i < points; i++)
                    columns.AddRange(new ArraySegment<byte>(records, i * stride + at, bytes));
                at += bytes;
            }
            byte[] lzf = Compress(columns.ToArray());
            return BitConverter.GetBytes(lzf.Length).Concat(BitConverter.GetBytes(columns.Count)).Concat(lzf).ToArray();
        }

        public static byte[] Compress(byte[] bytes)
        {
            var output = new List<byte>();
            var lastPlace = new Dictionary<int, int>();
            int literals = 0, at = 0;
            void Flush()
            {
                for (; literals > 0;)
                {
                    int run = Math.Min(32, literals);
                    output.Add((byte)(run - 1));
                    output.AddRange(new ArraySegment<byte>(bytes, at - literals, run));
                    literals -= run;
                }
            }
            while (at < bytes.Length)
            {
                int key = at + 2 < bytes.Length ? bytes[at] << 16 | bytes[at + 1] << 8 | bytes[at + 2] : -1;
                bool isKnown = lastPlace.TryGetValue(key, out int from) && key >= 0 && at - from <= 8192;
                lastPlace[key] = at;
                if (!isKnown)
                {
                    literals++;
                    at++;
                    continue;
                }
                Flush();
                int length = 3;
                while (length < 264 && at + length < bytes.Length && bytes[from + length] == bytes[at + length])
                    length++;
                int back = at - from - 1;
                output.Add((byte)(Math.Min(7, length - 2) << 5 | back >> 8));
                if (length - 2 >= 7)
                    output.Add((byte)(length - 9));
                output.Add((byte)back);
                at += length;
            }
            Flush();
            return output.ToArray();
        }
    }
}
