namespace FastPoints.Reading
{
    /// <summary>An order of visiting strata whose every prefix is spread evenly over them: the base-2 van der Corput
    /// sequence, Owen scrambled. Blittable, for jobs.</summary>
    /// <remarks>The scrambling is the hash of S. Laine and T. Karras, "Stratified sampling for stochastic transparency", 2011,
    /// with the constants of B. Burley, "Practical hash-based Owen scrambling", 2020. Of the first 2^k entries of the order, one
    /// lies in each 2^-k of the strata (give or take the entries beyond the last stratum, which are skipped).</remarks>
    internal readonly struct SampleOrder
    {
        readonly int m_bits;
        readonly uint m_seed;

        public readonly int Strata;

        public SampleOrder(int strata, uint seed)
        {
            Strata = strata;
            m_seed = seed;
            m_bits = 0;
            while (1L << m_bits < strata)
                m_bits++;
        }

        public int Length => 1 << m_bits;

        // -1 if the entry is skipped.
        public int StratumAt(int index)
        {
            if (m_bits == 0)
                return 0;
            uint x = (uint)index;
            x ^= x * 0x3D20ADEAu;
            x += m_seed;
            x *= m_seed >> 16 | 1;
            x ^= x * 0x05526C56u;
            x ^= x * 0x53A22864u;
            // These are the low bits that count, reversed: each bit of the stratum depends on the bits above it alone.
            uint reversed = 0;
            for (int bit = 0; bit < m_bits; bit++)
                reversed = reversed << 1 | x >> bit & 1;
            return reversed < (uint)Strata ? (int)reversed : -1;
        }
    }
}
