using System;

namespace FastPoints.Tests
{
    /// <summary>GPS times, as their bits: GPSTIME11 version 2, and the layer of POINT14, which codes changed times
    /// only.</summary>
    sealed class GpsTimeEncoder : IItemEncoder
    {
        const int Multiplier = 500, LowestMultiplier = -10, Unchanged = 511, Full = 512;

        readonly int m_recordOffset, m_isLayer;
        readonly SymbolEncoder m_multiplier, m_zero;
        readonly IntegerEncoder m_integer = new IntegerEncoder(32, 9);
        readonly long[] m_last = new long[4];
        readonly int[] m_difference = new int[4];
        readonly int[] m_extremes = new int[4];
        int m_sequence, m_newest;

        public GpsTimeEncoder(long first, int recordOffset, bool isLayer)
        {
            m_recordOffset = recordOffset;
            m_isLayer = isLayer ? 1 : 0;
            m_multiplier = new SymbolEncoder(516 - m_isLayer);
            m_zero = new SymbolEncoder(6 - m_isLayer);
            m_last[0] = first;
        }

        public void Encode(RangeEncoder encoder, byte[] record) => Encode(encoder, RecordFields.Int64(record, m_recordOffset));

        public void Encode(RangeEncoder encoder, long time)
        {
            int last = m_difference[m_sequence];
            long difference = unchecked(time - m_last[m_sequence]);
            if (difference == 0 && m_isLayer == 0)
            {
                Symbol(encoder, last, 0, Unchanged);
                return;
            }
            if (difference != (int)difference)
            {
                EncodeElsewhere(encoder, time, last);
                return;
            }
            if (last == 0)
            {
                Symbol(encoder, last, 1, 0);
                m_integer.Encode(encoder, 0, (int)difference, 0);
                m_difference[m_sequence] = (int)difference;
                m_extremes[m_sequence] = 0;
            }
            else
            {
                EncodeMultiple(encoder, (int)difference, last);
            }
            m_last[m_sequence] = time;
        }

        void EncodeMultiple(RangeEncoder encoder, int difference, int last)
        {
            double ratio = (float)difference / (float)last;
            double rounded = ratio >= 0 ? Math.Floor(ratio + 0.5) : Math.Ceiling(ratio - 0.5);
            int multiple = (int)Math.Max(LowestMultiplier, Math.Min(Multiplier, rounded));
            m_multiplier.Encode(encoder, multiple >= 0 ? multiple : Multiplier - multiple);
            int context = multiple == 1 ? 1
                : multiple == 0 ? 7
                : multiple == Multiplier ? 4 : multiple == LowestMultiplier ? 6 : multiple < 0 ? 5 : multiple < 10 ? 2 : 3;
            m_integer.Encode(encoder, unchecked(multiple * last), difference, context);
            if (multiple == 1)
                m_extremes[m_sequence] = 0;
            else if ((context == 4 || context >= 6) && ++m_extremes[m_sequence] > 3)
            {
                m_difference[m_sequence] = difference;
                m_extremes[m_sequence] = 0;
            }
        }

        void EncodeElsewhere(RangeEncoder encoder, long time, int last)
        {
            for (int i = 1; i < 4; i++)
            {
                long other = unchecked(time - m_last[(m_sequence + i) & 3]);
                if (other != (int)other)
                    continue;
                Symbol(encoder, last, 2 + i, Full + i);
                m_sequence = (m_sequence + i) & 3;
                Encode(encoder, time);
                return;
            }
            Symbol(encoder, last, 2, Full);
            m_integer.Encode(encoder, (int)(m_last[m_sequence] >> 32), (int)(time >> 32), 8);
            encoder.UInt32((uint)time);
            m_sequence = m_newest = (m_newest + 1) & 3;
            m_last[m_sequence] = time;
            m_difference[m_sequence] = 0;
            m_extremes[m_sequence] = 0;
        }

        /// <summary>One of two symbols, by whether there is a difference to multiply.</summary>
        void Symbol(RangeEncoder encoder, int last, int ofZero, int ofMultiple)
        {
            if (last == 0)
                m_zero.Encode(encoder, ofZero - m_isLayer);
            else
                m_multiplier.Encode(encoder, ofMultiple - m_isLayer);
        }
    }

    /// <summary>Item GPSTIME11, version 1.</summary>
    sealed class GpsTimeEncoderV1 : IItemEncoder
    {
        const int MaxMultiplier = 512;

        readonly int m_recordOffset;
        readonly SymbolEncoder m_multiplier = new SymbolEncoder(MaxMultiplier);
        readonly SymbolEncoder m_zero = new SymbolEncoder(3);
        readonly IntegerEncoder m_integer = new IntegerEncoder(32, 6);
        long m_last;
        int m_difference, m_extremes;

        public GpsTimeEncoderV1(long first, int recordOffset)
        {
            m_recordOffset = recordOffset;
            m_last = first;
        }

        public void Encode(RangeEncoder encoder, byte[] record)
        {
            long time = RecordFields.Int64(record, m_recordOffset);
            long difference = unchecked(time - m_last);
            if (m_difference == 0)
            {
                if (difference == 0)
                    m_zero.Encode(encoder, 0);
                else if (difference == (int)difference)
                {
                    m_zero.Encode(encoder, 1);
                    m_integer.Encode(encoder, 0, (int)difference, 0);
                    m_difference = (int)difference;
                }
                else
                {
                    m_zero.Encode(encoder, 2);
                    Full(encoder, time);
                }
            }
            else if (difference == 0)
                m_multiplier.Encode(encoder, MaxMultiplier - 1);
            else if (difference != (int)difference)
            {
                m_multiplier.Encode(encoder, MaxMultiplier - 2);
                Full(encoder, time);
            }
            else
            {
                EncodeMultiple(encoder, (int)difference);
            }
            m_last = time;
        }

        void EncodeMultiple(RangeEncoder encoder, int difference)
        {
            double rounded = Math.Round((float)difference / (float)m_difference);
            int multiple = (int)Math.Max(0, Math.Min(MaxMultiplier - 3, rounded));
            m_multiplier.Encode(encoder, multiple);
            int context = multiple == 1 ? 1 : multiple == 0 ? 2 : multiple < 10 ? 3 : multiple < 50 ? 4 : 5;
            int prediction = multiple == 0 ? m_difference / 4 : unchecked(multiple * m_difference);
            m_integer.Encode(encoder, prediction, difference, context);
            if (multiple == 1)
            {
                m_difference = difference;
                m_extremes = 0;
            }
            else if ((multiple == 0 || multiple == MaxMultiplier - 3) && ++m_extremes > 3)
            {
                m_difference = difference;
                m_extremes = 0;
            }
        }

        static void Full(RangeEncoder encoder, long time)
        {
            encoder.UInt32((uint)time);
            encoder.UInt32((uint)(time >> 32));
        }
    }
}
