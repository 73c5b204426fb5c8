using static FastPoints.Tests.RecordFields;

namespace FastPoints.Tests
{
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
