using System;
using static FastPoints.Tests.RecordFields;

namespace FastPoints.Tests
{
    /// <summary>Colours: RGB12 version 2, and the layers of RGB14 and RGBNIR14 (whose last colour the caller may
    /// choose).</summary>
    sealed class RgbEncoder : IItemEncoder
    {
        readonly int m_recordOffset;
        readonly SymbolEncoder m_used = new SymbolEncoder(128);
        readonly SymbolEncoder[] m_bytes = new SymbolEncoder[6];

        public RgbEncoder(byte[] first, int recordOffset)
        {
            m_recordOffset = recordOffset;
            for (int i = 0; i < 6; i++)
                m_bytes[i] = new SymbolEncoder(256);
            Last = Slice(first, recordOffset, 6);
        }

        public byte[] Last { get; }

        public void Encode(RangeEncoder encoder, byte[] record) => Encode(encoder, record, Last);

        public void Encode(RangeEncoder encoder, byte[] record, byte[] last)
        {
            var color = Slice(record, m_recordOffset, 6);
            int used = 0;
            for (int i = 0; i < 6; i++)
                if (color[i] != last[i])
                    used |= 1 << i;
            bool isGrey = color[0] == color[2] && color[0] == color[4] && color[1] == color[3] && color[1] == color[5];
            if (!isGrey)
                used |= 64;
            m_used.Encode(encoder, used);
            if ((used & 1) != 0)
                m_bytes[0].Encode(encoder, color[0] - last[0] & 255);
            if ((used & 2) != 0)
                m_bytes[1].Encode(encoder, color[1] - last[1] & 255);
            if (!isGrey)
            {
                // Bytes: red low and high, green low and high, blue low and high.
                int low = color[0] - last[0], high = color[1] - last[1];
                if ((used & 4) != 0)
                    m_bytes[2].Encode(encoder, color[2] - Clamp(low + last[2]) & 255);
                if ((used & 16) != 0)
                    m_bytes[4].Encode(encoder, color[4] - Clamp((low + color[2] - last[2]) / 2 + last[4]) & 255);
                if ((used & 8) != 0)
                    m_bytes[3].Encode(encoder, color[3] - Clamp(high + last[3]) & 255);
                if ((used & 32) != 0)
                    m_bytes[5].Encode(encoder, color[5] - Clamp((high + color[3] - last[3]) / 2 + last[5]) & 255);
            }
            color.CopyTo(last, 0);
        }

        static int Clamp(int value) => Math.Max(0, Math.Min(255, value));
    }

    /// <summary>Item RGB12, version 1.</summary>
    sealed class RgbEncoderV1 : IItemEncoder
    {
        readonly int m_recordOffset;
        readonly SymbolEncoder m_used = new SymbolEncoder(64);
        readonly IntegerEncoder m_byte = new IntegerEncoder(8, 6);
        byte[] m_last;

        public RgbEncoderV1(byte[] first, int recordOffset)
        {
            m_recordOffset = recordOffset;
            m_last = Slice(first, recordOffset, 6);
        }

        public void Encode(RangeEncoder encoder, byte[] record)
        {
            var color = Slice(record, m_recordOffset, 6);
            int used = 0;
            for (int i = 0; i < 6; i++)
                if (color[i] != m_last[i])
                    used |= 1 << i;
            m_used.Encode(encoder, used);
            for (int i = 0; i < 6; i++)
                if ((used >> i & 1) != 0)
                    m_byte.Encode(encoder, m_last[i], color[i], i);
            m_last = color;
        }
    }
}
