namespace FastPoints.LazEncoding
{
    /// <summary>The encoder's side of <see cref="FastPoints.Files.IntegerModel"/>.</summary>
    public sealed class IntegerEncoder
    {
        const int ModelledBits = 8;

        readonly int m_bits;
        readonly SymbolEncoder[] m_k;
        readonly SymbolEncoder[] m_correctors;
        readonly BitEncoder m_bit = new BitEncoder();

        public IntegerEncoder(int bits, int contexts)
        {
            m_bits = bits;
            m_k = new SymbolEncoder[contexts];
            for (int i = 0; i < contexts; i++)
                m_k[i] = new SymbolEncoder(bits + 1);
            m_correctors = new SymbolEncoder[bits + 1];
        }

        /// <summary>Bits of the last difference.</summary>
        public int K { get; private set; }

        public void Encode(RangeEncoder encoder, int prediction, int value, int context)
        {
            int difference = unchecked(value - prediction);
            if (m_bits < 32)
            {
                // Folded into the range of so many bits.
                int range = 1 << m_bits;
                if (difference < -(range / 2))
                    difference += range;
                else if (difference > range / 2 - 1)
                    difference -= range;
            }

            uint magnitude = unchecked((uint)(difference <= 0 ? -difference : difference - 1));
            K = 0;
            for (; magnitude != 0; magnitude >>= 1)
                K++;
            m_k[context].Encode(encoder, K);
            if (K == 0)
            {
                m_bit.Encode(encoder, difference);
                return;
            }
            if (K == 32)
                return;
            uint place = unchecked((uint)(difference < 0 ? difference + (int)((1u << K) - 1) : difference - 1));
            m_correctors[K] ??= new SymbolEncoder(1 << System.Math.Min(K, ModelledBits));
            if (K <= ModelledBits)
            {
                m_correctors[K].Encode(encoder, (int)place);
                return;
            }
            int raw = K - ModelledBits;
            m_correctors[K].Encode(encoder, (int)(place >> raw));
            encoder.Bits(raw, place & ((1u << raw) - 1));
        }
    }
}
