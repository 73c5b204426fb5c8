using System;

namespace FastPoints.Tests
{
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
