using System;
using System.IO;
using FastPoints.Reading;

namespace FastPoints.Tests
{
    /// <summary>Zstandard frames of raw blocks only (RFC 8878, 3.1.1): enough to test all around a decompressor without
    /// one.</summary>
    sealed class StoredZstandard : StreamDecompressor
    {
        const int FrameHeaderBytes = 9, MaxBlockBytes = 128 << 10;

        bool m_isStarted, m_isLast;
        int m_left;

        public static byte[] Frame(byte[] content)
        {
            var frame = new BinaryWriter(new MemoryStream());
            frame.Write(0xFD2FB528u);
            // One segment, content size in four bytes.
            frame.Write((byte)0xA0);
            frame.Write(content.Length);
            int at = 0;
            do
            {
                int bytes = Math.Min(MaxBlockBytes, content.Length - at);
                int header = bytes << 3 | (at + bytes == content.Length ? 1 : 0);
                frame.Write((ushort)header);
                frame.Write((byte)(header >> 16));
                frame.Write(content, at, bytes);
                at += bytes;
            }
            while (at < content.Length);
            return ((MemoryStream)frame.BaseStream).ToArray();
        }

        public override void Start()
        {
            m_isStarted = m_isLast = false;
            m_left = 0;
        }

        public override bool Decode(ReadOnlySpan<byte> input, Span<byte> output, out int consumed, out int written)
        {
            consumed = written = 0;
            if (!m_isStarted)
            {
                if (input.Length < FrameHeaderBytes || input[0] != 0x28 || input[1] != 0xB5 ||
                    input[2] != 0x2F || input[3] != 0xFD
                    || input[4] != 0xA0)
                    return false;
                consumed = FrameHeaderBytes;
                m_isStarted = true;
            }
            while (written < output.Length)
            {
                if (m_left == 0)
                {
                    if (m_isLast || input.Length - consumed < 3)
                        return m_isLast;
                    int header = input[consumed] | input[consumed + 1] << 8 | input[consumed + 2] << 16;
                    consumed += 3;
                    m_isLast = (header & 1) != 0;
                    m_left = header >> 3;
                    if ((header >> 1 & 3) != 0 || m_left > MaxBlockBytes)
                        return false;
                    continue;
                }
                int bytes = Math.Min(m_left, Math.Min(input.Length - consumed, output.Length - written));
                if (bytes == 0)
                    return false;
                input.Slice(consumed, bytes).CopyTo(output.Slice(written));
                consumed += bytes;
                written += bytes;
                m_left -= bytes;
            }
            return true;
        }

        public override void Dispose() { }
    }
}
