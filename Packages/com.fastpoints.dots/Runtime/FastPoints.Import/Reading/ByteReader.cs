using System;
using System.Text;
using FastPoints.Core;

namespace FastPoints.Reading
{
    /// <summary>Reads little-endian fields of a piece of a file, addressed by their offset in the piece. A field outside the
    /// piece is a failure that names the byte in the file.</summary>
    internal readonly struct ByteReader
    {
        public readonly byte[] Bytes;
        public readonly string Path;
        public readonly long FileOffset;

        public ByteReader(byte[] bytes, string path, long fileOffset)
        {
            Bytes = bytes;
            Path = path;
            FileOffset = fileOffset;
        }

        public int Length => Bytes.Length;

        public bool Has(int at, int count) => at >= 0 && count >= 0 && count <= Bytes.Length - at;

        public byte UInt8(int at, string field) => Bytes[Start(at, 1, field)];

        public ushort UInt16(int at, string field)
        {
            int i = Start(at, 2, field);
            return (ushort)(Bytes[i] | Bytes[i + 1] << 8);
        }

        public uint UInt32(int at, string field)
        {
            int i = Start(at, 4, field);
            return (uint)(Bytes[i] | Bytes[i + 1] << 8 | Bytes[i + 2] << 16 | Bytes[i + 3] << 24);
        }

        public int Int32(int at, string field) => (int)UInt32(at, field);

        public ulong UInt64(int at, string field)
        {
            Start(at, 8, field);
            return UInt32(at, field) | (ulong)UInt32(at + 4, field) << 32;
        }

        public double Float64(int at, string field) => BitConverter.Int64BitsToDouble((long)UInt64(at, field));

        // Up to the first zero byte, without blanks at the end. Other than printable ASCII becomes '?': people see it as one
        // line.
        public string Text(int at, int count, string field)
        {
            int start = Start(at, count, field);
            var text = new StringBuilder(count);
            for (int i = start; i < start + count && Bytes[i] != 0; i++)
                text.Append(Bytes[i] >= 32 && Bytes[i] < 127 ? (char)Bytes[i] : '?');
            return text.ToString().TrimEnd(' ');
        }

        int Start(int at, int count, string field)
        {
            if (!Has(at, count))
                throw PointCloudException.Wanted(FailureCode.Truncated, Path, FileOffset + at, field, count + " bytes",
                    Math.Max(0, Bytes.Length - (long)at));
            return at;
        }
    }
}
