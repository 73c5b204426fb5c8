using System.Collections.Generic;

namespace FastPoints.Tests
{
    /// <summary>The range coder that <see cref="FastPoints.Laz.RangeCode"/> decodes: 32-bit base and length, carries taken back
    /// into the bytes already written.</summary>
    public sealed class RangeEncoder
    {
        const uint MinLength = 1u << 24;

        readonly List<byte> m_bytes = new List<byte>();
        uint m_base, m_length = uint.MaxValue;

        public void Narrow(uint low, uint size)
        {
            uint before = m_base;
            m_base += low;
            m_length = size;
            if (m_base < before)
                Carry();
            Renew();
        }

        public uint Length => m_length;

        /// <summary>Bits without a model, the lower 16 first where there are more than 19.</summary>
        public void Bits(int bits, uint value)
        {
            if (bits > 19)
            {
                Bits(16, value & 0xFFFF);
                value >>= 16;
                bits -= 16;
            }
            uint unit = m_length >> bits;
            Narrow(value * unit, unit);
        }

        public void UInt32(uint value)
        {
            Bits(16, value & 0xFFFF);
            Bits(16, value >> 16);
        }

        public byte[] Finish()
        {
            uint before = m_base;
            bool isLong = m_length > 2 * MinLength;
            m_base += isLong ? MinLength : MinLength >> 1;
            m_length = isLong ? MinLength >> 1 : MinLength >> 9;
            if (m_base < before)
                Carry();
            Renew();
            for (int i = 0; i < (isLong ? 3 : 2); i++)
                m_bytes.Add(0);
            return m_bytes.ToArray();
        }

        void Renew()
        {
            while (m_length < MinLength)
            {
                m_bytes.Add((byte)(m_base >> 24));
                m_base <<= 8;
                m_length <<= 8;
            }
        }

        void Carry()
        {
            int i = m_bytes.Count - 1;
            while (m_bytes[i] == 255)
                m_bytes[i--] = 0;
            m_bytes[i]++;
        }
    }

    public sealed class SymbolEncoder
    {
        const int LengthBits = 15;

        readonly uint[] m_counts, m_starts;
        uint m_total;
        int m_cycle, m_untilUpdate;

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

    public sealed class BitEncoder
    {
        const int LengthBits = 13;

        uint m_zeros = 1, m_count = 2;
        uint m_probability = 1u << (LengthBits - 1);
        uint m_cycle = 4, m_untilUpdate = 4;

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

    public sealed class IntegerEncoder
    {
        const int ModelledBits = 8;

        readonly int m_bits;
        readonly SymbolEncoder[] m_k, m_correctors;
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
