using System;
using FastPoints.Laz;

namespace FastPoints.Tests
{
    /// <summary>The package's own coder, with memory that grows. What it makes of each format is held by hashes that an independent
    /// one made.</summary>
    public sealed unsafe class RangeEncoder
    {
        const int MaxStepBytes = 64;

        byte[] m_bytes = new byte[1024];
        int m_count;
        uint m_low, m_length = uint.MaxValue;

        internal delegate void Step(ref uint low, ref uint length, ref byte* next);

        internal void Put(Step step)
        {
            if (m_count + MaxStepBytes > m_bytes.Length)
                Array.Resize(ref m_bytes, 2 * m_bytes.Length);
            fixed (byte* first = m_bytes)
            {
                byte* next = first + m_count;
                step(ref m_low, ref m_length, ref next);
                m_count = (int)(next - first);
            }
        }

        /// <summary>Bits without a model.</summary>
        public void Bits(int bits, uint value) =>
            Put((ref uint low, ref uint length, ref byte* next) => RangeCode.PutBits(bits, value, ref low, ref length, ref next));

        public void UInt32(uint value) =>
            Put((ref uint low, ref uint length, ref byte* next) => RangeCode.PutUInt32(value, ref low, ref length, ref next));

        public byte[] Finish()
        {
            Put((ref uint low, ref uint length, ref byte* next) => RangeCode.End(low, length, ref next));
            return m_bytes.AsSpan(0, m_count).ToArray();
        }
    }

    public sealed unsafe class SymbolEncoder
    {
        readonly int m_symbols;
        readonly byte[] m_model;

        public SymbolEncoder(int symbols)
        {
            m_symbols = symbols;
            m_model = new byte[SymbolModel.BytesOf(symbols)];
            fixed (byte* model = m_model)
                SymbolModel.Initialize(model, symbols);
        }

        public void Encode(RangeEncoder encoder, int symbol) => encoder.Put((ref uint low, ref uint length, ref byte* next) =>
        {
            fixed (byte* model = m_model)
                SymbolModel.Encode(model, m_symbols, (uint)symbol, ref low, ref length, ref next);
        });
    }

    public sealed unsafe class IntegerEncoder
    {
        readonly int m_bits, m_contexts;
        readonly byte[] m_model;

        public IntegerEncoder(int bits, int contexts)
        {
            (m_bits, m_contexts) = (bits, contexts);
            m_model = new byte[IntegerModel.BytesOf(bits, contexts)];
            fixed (byte* model = m_model)
                IntegerModel.Initialize(model, bits, contexts);
        }

        /// <summary>Bits of the last difference.</summary>
        public int K { get; private set; }

        public void Encode(RangeEncoder encoder, int prediction, int value, int context) =>
            encoder.Put((ref uint low, ref uint length, ref byte* next) =>
            {
                int k;
                fixed (byte* model = m_model)
                    IntegerModel.Encode(model, m_bits, m_contexts, context, unchecked(value - prediction), out k, ref low,
                        ref length, ref next);
                K = k;
            });
    }
}
