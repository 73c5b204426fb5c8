using System.Runtime.CompilerServices;

namespace FastPoints.Laz
{
    /// <summary>An adaptive model of one bit. HPC#.</summary>
    internal unsafe struct BitModel
    {
        const int LengthBits = 13;
        const uint MaxCount = 1 << LengthBits;
        const uint MaxCycle = 64;

        uint m_untilUpdate;
        uint m_cycle;
        uint m_probabilityOfZero;
        uint m_zeros;
        uint m_count;

        public void Initialize()
        {
            m_zeros = 1;
            m_count = 2;
            m_probabilityOfZero = 1u << (LengthBits - 1);
            m_cycle = m_untilUpdate = 4;
        }

        /// <summary>The next bit, without a branch on its value: about half of them would be guessed wrong.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint Decode(BitModel* model, ref uint value, ref uint length, ref byte* next)
        {
            uint split = model->m_probabilityOfZero * (length >> LengthBits);
            uint isZero = (uint)(((long)value - split) >> 63);
            value -= split & ~isZero;
            length = isZero & split | ~isZero & (length - split);
            model->m_zeros += isZero & 1;
            RangeCoder.Renormalize(ref value, ref length, ref next);
            if (--model->m_untilUpdate == 0)
                model->Update();
            return isZero + 1;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Encode(BitModel* model, uint bit, ref uint low, ref uint length, ref byte* next)
        {
            uint split = model->m_probabilityOfZero * (length >> LengthBits);
            model->m_zeros += bit ^ 1;
            RangeCoder.Narrow(bit * split, bit == 0 ? split : length - split, ref low, ref length, ref next);
            if (--model->m_untilUpdate == 0)
                model->Update();
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        void Update()
        {
            m_count += m_cycle;
            if (m_count > MaxCount)
            {
                m_count = (m_count + 1) >> 1;
                m_zeros = (m_zeros + 1) >> 1;
                if (m_zeros == m_count)
                    m_count++;
            }
            uint scale = 0x80000000u / m_count;
            m_probabilityOfZero = (m_zeros * scale) >> (31 - LengthBits);
            m_cycle = (5 * m_cycle) >> 2;
            if (m_cycle > MaxCycle)
                m_cycle = MaxCycle;
            m_untilUpdate = m_cycle;
        }
    }
}
