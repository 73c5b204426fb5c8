using static FastPoints.Tests.RecordFields;

namespace FastPoints.Tests
{
    interface IItemEncoder
    {
        void Encode(RangeEncoder encoder, byte[] record);
    }

    /// <summary>Item POINT10, version 2.</summary>
    sealed class Point10Encoder : IItemEncoder
    {
        static readonly int[] s_map =
        {
            15, 14, 13, 12, 11, 10, 9, 8, 14, 0, 1, 3, 6, 10, 10, 9, 13, 1, 2, 4, 7, 11, 11, 10, 12, 3, 4, 5, 8, 12, 12, 11,
            11, 6, 7, 8, 9, 13, 13, 12, 10, 10, 11, 12, 13, 14, 14, 13, 9, 10, 11, 12, 13, 14, 15, 14,
            8, 9, 10, 11, 12, 13, 14, 15,
        };

        readonly SymbolEncoder m_changed = new SymbolEncoder(64);
        readonly SymbolEncoder[] m_angle = { new SymbolEncoder(256), new SymbolEncoder(256) };
        readonly SymbolEncoder[] m_flags = new SymbolEncoder[256];
        readonly SymbolEncoder[] m_class = new SymbolEncoder[256];
        readonly SymbolEncoder[] m_userData = new SymbolEncoder[256];
        readonly IntegerEncoder m_x = new IntegerEncoder(32, 2);
        readonly IntegerEncoder m_y = new IntegerEncoder(32, 22);
        readonly IntegerEncoder m_z = new IntegerEncoder(32, 20);
        readonly IntegerEncoder m_intensity = new IntegerEncoder(16, 4);
        readonly IntegerEncoder m_source = new IntegerEncoder(16, 1);
        readonly MedianOfFive[] m_medianX = new MedianOfFive[16];
        readonly MedianOfFive[] m_medianY = new MedianOfFive[16];
        readonly int[] m_lastIntensity = new int[16];
        readonly int[] m_lastHeight = new int[8];
        byte[] m_last;

        public Point10Encoder(byte[] first)
        {
            m_last = Slice(first, 0, 20);
            for (int i = 0; i < 16; i++)
            {
                m_medianX[i] = new MedianOfFive();
                m_medianY[i] = new MedianOfFive();
            }
        }

        public void Encode(RangeEncoder encoder, byte[] record)
        {
            int returns = record[14] & 63, n = returns >> 3, r = returns & 7;
            int map = s_map[returns], level = System.Math.Abs(n - r), isSingle = n == 1 ? 1 : 0;
            int intensity = UInt16(record, 12);
            int changed = (record[14] != m_last[14] ? 32 : 0) | (intensity != m_lastIntensity[map] ? 16 : 0)
                | (record[15] != m_last[15] ? 8 : 0)
                | (record[16] != m_last[16] ? 4 : 0)
                | (record[17] != m_last[17] ? 2 : 0)
                | (UInt16(record, 18) != UInt16(m_last, 18) ? 1 : 0);
            m_changed.Encode(encoder, changed);
            if ((changed & 32) != 0)
                Byte(encoder, m_flags, m_last[14], record[14]);
            if ((changed & 16) != 0)
            {
                m_intensity.Encode(encoder, m_lastIntensity[map], intensity, System.Math.Min(map, 3));
                m_lastIntensity[map] = intensity;
            }
            if ((changed & 8) != 0)
                Byte(encoder, m_class, m_last[15], record[15]);
            if ((changed & 4) != 0)
                m_angle[record[14] >> 6 & 1].Encode(encoder, record[16] - m_last[16] & 255);
            if ((changed & 2) != 0)
                Byte(encoder, m_userData, m_last[17], record[17]);
            if ((changed & 1) != 0)
                m_source.Encode(encoder, UInt16(m_last, 18), UInt16(record, 18), 0);

            int dx = unchecked(Int32(record, 0) - Int32(m_last, 0));
            m_x.Encode(encoder, m_medianX[map].Value, dx, isSingle);
            m_medianX[map].Add(dx);
            int dy = unchecked(Int32(record, 4) - Int32(m_last, 4));
            m_y.Encode(encoder, m_medianY[map].Value, dy, isSingle + (m_x.K < 20 ? m_x.K & ~1 : 20));
            m_medianY[map].Add(dy);
            int k = (m_x.K + m_y.K) / 2;
            m_z.Encode(encoder, m_lastHeight[level], Int32(record, 8), isSingle + (k < 18 ? k & ~1 : 18));
            m_lastHeight[level] = Int32(record, 8);
            m_last = Slice(record, 0, 20);
        }

        internal static void Byte(RangeEncoder encoder, SymbolEncoder[] models, int last, int value)
        {
            models[last] ??= new SymbolEncoder(256);
            models[last].Encode(encoder, value);
        }
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
                Point10Encoder.Byte(encoder, m_flags, m_last[14], record[14]);
            if ((changed & 8) != 0)
                Point10Encoder.Byte(encoder, m_class, m_last[15], record[15]);
            if ((changed & 4) != 0)
                m_angle.Encode(encoder, m_last[16], record[16], k < 3 ? 1 : 0);
            if ((changed & 2) != 0)
                Point10Encoder.Byte(encoder, m_userData, m_last[17], record[17]);
            if ((changed & 1) != 0)
                m_source.Encode(encoder, UInt16(m_last, 18), UInt16(record, 18), 0);
            m_last = Slice(record, 0, 20);
        }

        static int Median(int[] values)
        {
            var sorted = (int[])values.Clone();
            System.Array.Sort(sorted);
            return sorted[1];
        }
    }
}
