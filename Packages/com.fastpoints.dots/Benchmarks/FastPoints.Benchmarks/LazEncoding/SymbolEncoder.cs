namespace FastPoints.LazEncoding
{
    /// <summary>The encoder's side of <see cref="FastPoints.Files.SymbolModel"/>.</summary>
    public sealed class SymbolEncoder
    {
        const int LengthBits = 15;

        readonly uint[] m_counts;
        readonly uint[] m_starts;
        uint m_total;
        int m_cycle;
        int m_untilUpdate;

        public SymbolEncoder(int symbols)
        {
            m_counts = new uint[symbols];
            m_starts = new uint[symbols];
            for (int i = 0; i < symbols; i++)
                m_counts[i] = 1;
            m_cycle = symbols;
            Update();
            m_cycle = m_untilUpdate = (symbols + 6) >> 1;
        }

        public void Encode(RangeEncoder encoder, int symbol)
        {
            uint unit = encoder.Length >> LengthBits;
            uint low = m_starts[symbol] * unit;
            uint high = symbol == m_counts.Length - 1 ? encoder.Length : m_starts[symbol + 1] * unit;
            encoder.Narrow(low, high - low);
            m_counts[symbol]++;
            if (--m_untilUpdate == 0)
                Update();
        }

        void Update()
        {
            m_total += (uint)m_cycle;
            if (m_total > 1 << LengthBits)
            {
                m_total = 0;
                for (int i = 0; i < m_counts.Length; i++)
                    m_total += m_counts[i] = (m_counts[i] + 1) >> 1;
            }
            uint sum = 0, scale = 0x80000000u / m_total;
            for (int i = 0; i < m_counts.Length; i++)
            {
                m_starts[i] = (scale * sum) >> (31 - LengthBits);
                sum += m_counts[i];
            }
            m_cycle = System.Math.Min(5 * m_cycle >> 2, (m_counts.Length + 6) << 3);
            m_untilUpdate = m_cycle;
        }
    }

    /// <summary>The encoder's side of <see cref="FastPoints.Files.BitModel"/>.</summary>
    public sealed class BitEncoder
    {
        const int LengthBits = 13;

        uint m_zeros = 1;
        uint m_count = 2;
        uint m_probability = 1u << (LengthBits - 1);
        uint m_cycle = 4;
        uint m_untilUpdate = 4;

        public void Encode(RangeEncoder encoder, int bit)
        {
            uint split = m_probability * (encoder.Length >> LengthBits);
            if (bit == 0)
            {
                encoder.Narrow(0, split);
                m_zeros++;
            }
            else
            {
                encoder.Narrow(split, encoder.Length - split);
            }
            if (--m_untilUpdate == 0)
                Update();
        }

        void Update()
        {
            m_count += m_cycle;
            if (m_count > 1 << LengthBits)
            {
                m_count = (m_count + 1) >> 1;
                m_zeros = (m_zeros + 1) >> 1;
                if (m_zeros == m_count)
                    m_count++;
            }
            m_probability = (m_zeros * (0x80000000u / m_count)) >> (31 - LengthBits);
            m_cycle = System.Math.Min(5 * m_cycle >> 2, 64);
            m_untilUpdate = m_cycle;
        }
    }
}
