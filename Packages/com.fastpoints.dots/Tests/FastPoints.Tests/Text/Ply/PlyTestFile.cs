using System;
using System.IO;
using System.Text;

namespace FastPoints.Tests.Text
{
    sealed class PlyTestFile : TemporaryFile
    {
        readonly MemoryStream m_bytes = new MemoryStream();

        public PlyTestFile(string text = "") : base(".ply") => Text(text);

        public long Length => m_bytes.Length;

        public static PlyTestFile WithHeader(string format, params string[] lines) =>
            new PlyTestFile("ply\nformat " + format + " 1.0\n" + string.Join("\n", lines) + "\nend_header\n");

        public PlyTestFile Text(string text) => Raw(Encoding.ASCII.GetBytes(text));

        public PlyTestFile Raw(byte[] bytes)
        {
            m_bytes.Write(bytes, 0, bytes.Length);
            return this;
        }

        public PlyTestFile Values(bool isBigEndian, params object[] values)
        {
            foreach (object value in values)
            {
                byte[] bytes = BytesOf(value);
                if (isBigEndian)
                    Array.Reverse(bytes);
                Raw(bytes);
            }
            return this;
        }

        public byte[] ToArray() => m_bytes.ToArray();

        public PlyTestFile Save()
        {
            File.WriteAllBytes(Path, m_bytes.ToArray());
            return this;
        }

        public static byte[] BytesOf(object value) => value switch
        {
            byte v => new[] { v },
            sbyte v => new[] { (byte)v },
            ushort v => BitConverter.GetBytes(v),
            short v => BitConverter.GetBytes(v),
            uint v => BitConverter.GetBytes(v),
            int v => BitConverter.GetBytes(v),
            ulong v => BitConverter.GetBytes(v),
            long v => BitConverter.GetBytes(v),
            float v => BitConverter.GetBytes(v),
            _ => BitConverter.GetBytes((double)value),
        };
    }
}
