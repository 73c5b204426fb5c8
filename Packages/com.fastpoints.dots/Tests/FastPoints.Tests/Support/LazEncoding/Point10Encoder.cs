using static FastPoints.Tests.RecordFields;

namespace FastPoints.Tests
{
    interface IItemEncoder
    {
        void Encode(RangeEncoder encoder, byte[] record);
    }

    /// <summary>Item POINT10, version 1.</summary>
    sealed class Point10EncoderV1 : IItemEncoder
    {
        readonly SymbolEncoder m_changed = new SymbolEncoder(64);
        readonly SymbolEncoder[] m_flags = new SymbolEncoder[256];
        readonly SymbolEncoder[] m_class = new SymbolEncoder[256];
        readonly SymbolEncoder[] m_userData = new SymbolEncoder[256];
        readonly IntegerEncoder m_x = new IntegerEncoder(32, 1);
        readonly IntegerEncoder m_y = new IntegerEncoder(32, 20);
        readonly IntegerEncoder m_z = new IntegerEncoder(32, 20);
        readonly IntegerEncoder m_intensity = new IntegerEncoder(16, 1);
        readonly IntegerEncoder m_angle = new IntegerEncoder(8, 2);
        readonly IntegerEncoder m_source = new IntegerEncoder(16, 1);
        readonly int[] m_dx = new int[3];
        readonly int[] m_dy = new int[3];
        int m_oldest;
        byte[] m_last;

        public Point10EncoderV1(byte[] first) => m_last = Slice(first, 0, 20);

        public void Encode(RangeEncoder encoder, byte[] record)
        {
            int dx = unchecked(Int32(record, 0) - Int32(m_last, 0)), dy = unchecked(Int32(record, 4) - Int32(m_last, 4));
            m_x.Encode(encoder, Median(m_dx), dx, 0);
            m_y.Encode(encoder, Median(m_dy), dy, System.Math.Min(m_x.K, 19));
            int k = (m_x.K + m_y.K) / 2;
            m_z.Encode(encoder, Int32(m_last, 8), Int32(record, 8), System.Math.Min(k, 19));
            m_dx[m_oldest] = dx;
            m_dy[m_oldest] = dy;
            m_oldest = (m_oldest + 1) % 3;

            int changed = (UInt16(record, 12) != UInt16(m_last, 12) ? 32 : 0) | (record[14] != m_last[14] ? 16 : 0)
                | (record[15] != m_last[15] ? 8 : 0)
                | (record[16] != m_last[16] ? 4 : 0)
                | (record[17] != m_last[17] ? 2 : 0)
                | (UInt16(record, 18) != UInt16(m_last, 18) ? 1 : 0);
            m_changed.Encode(encoder, changed);
            if ((changed & 32) != 0)
                m_intensity.Encode(encoder, UInt16(m_last, 12), UInt16(record, 12), 0);
            if ((changed & 16) != 0)
                Byte(encoder, m_flags, m_last[14], record[14]);
            if ((changed & 8) != 0)
                Byte(encoder, m_class, m_last[15], record[15]);
            if ((changed & 4) != 0)
                m_angle.Encode(encoder, m_last[16], record[16], k < 3 ? 1 : 0);
            if ((changed & 2) != 0)
                Byte(encoder, m_userData, m_last[17], record[17]);
            if ((changed & 1) != 0)
                m_source.Encode(encoder, UInt16(m_last, 18), UInt16(record, 18), 0);
            m_last = Slice(record, 0, 20);
        }

        static void Byte(RangeEncoder encoder, SymbolEncoder[] models, int last, int value)
        {
            models[last] ??= new SymbolEncoder(256);
            models[last].Encode(encoder, value);
        }

        static int Median(int[] values)
        {
            var sorted = (int[])values.Clone();
            System.Array.Sort(sorted);
            return sorted[1];
        }
    }
}
