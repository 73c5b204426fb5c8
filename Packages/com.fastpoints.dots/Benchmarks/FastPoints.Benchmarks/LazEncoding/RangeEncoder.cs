using System.Collections.Generic;

namespace FastPoints.LazEncoding
{
    /// <summary>The range coder that <see cref="FastPoints.Files.RangeCode"/> decodes: 32-bit base and length, carries taken back
    /// into the bytes already written.</summary>
    public sealed class RangeEncoder
    {
        const uint MinLength = 1u << 24;

        readonly List<byte> m_bytes = new List<byte>();
        uint m_base;
        uint m_length = uint.MaxValue;

        /// <summary>Takes part <paramref name="index"/> of the interval, in which it goes from <paramref name="low"/> for
        /// <paramref name="size"/>.</summary>
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

        /// <summary>Ends the stream: as many bytes as a decoder takes, its first four among them.</summary>
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
}
