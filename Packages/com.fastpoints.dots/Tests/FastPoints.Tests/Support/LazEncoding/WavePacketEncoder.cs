using System;
using static FastPoints.Tests.RecordFields;

namespace FastPoints.Tests
{
    /// <summary>Item WAVEPACKET13.</summary>
    sealed class WavePacketEncoder : IItemEncoder
    {
        readonly int m_recordOffset;
        readonly SymbolEncoder m_index = new SymbolEncoder(256);
        readonly SymbolEncoder[] m_offsetKind = new SymbolEncoder[4];
        readonly IntegerEncoder m_step = new IntegerEncoder(32, 1);
        readonly IntegerEncoder m_size = new IntegerEncoder(32, 1);
        readonly IntegerEncoder m_location = new IntegerEncoder(32, 1);
        readonly IntegerEncoder m_direction = new IntegerEncoder(32, 3);
        byte[] m_last;
        int m_lastStep, m_lastKind;

        public WavePacketEncoder(byte[] first, int recordOffset)
        {
            m_recordOffset = recordOffset;
            for (int i = 0; i < 4; i++)
                m_offsetKind[i] = new SymbolEncoder(4);
            m_last = Slice(first, recordOffset, 29);
        }

        public void Encode(RangeEncoder encoder, byte[] record)
        {
            var packet = Slice(record, m_recordOffset, 29);
            m_index.Encode(encoder, packet[0]);
            long difference = unchecked(Int64(packet, 1) - Int64(m_last, 1));
            int kind = difference == 0 ? 0
                : difference == BitConverter.ToUInt32(m_last, 9) ? 1 : difference == (int)difference ? 2 : 3;
            m_offsetKind[m_lastKind].Encode(encoder, kind);
            m_lastKind = kind;
            if (kind == 2)
            {
                m_step.Encode(encoder, m_lastStep, (int)difference, 0);
                m_lastStep = (int)difference;
            }
            else if (kind == 3)
            {
                encoder.UInt32((uint)Int64(packet, 1));
                encoder.UInt32((uint)(Int64(packet, 1) >> 32));
            }
            m_size.Encode(encoder, Int32(m_last, 9), Int32(packet, 9), 0);
            m_location.Encode(encoder, Int32(m_last, 13), Int32(packet, 13), 0);
            for (int i = 0; i < 3; i++)
                m_direction.Encode(encoder, Int32(m_last, 17 + 4 * i), Int32(packet, 17 + 4 * i), i);
            m_last = packet;
        }
    }

    /// <summary>Item BYTE, version 1.</summary>
    sealed class BytesEncoderV1 : IItemEncoder
    {
        readonly int m_recordOffset;
        readonly IntegerEncoder m_integer;
        byte[] m_last;

        public BytesEncoderV1(byte[] first, int recordOffset, int bytes)
        {
            m_recordOffset = recordOffset;
            m_last = Slice(first, recordOffset, bytes);
            m_integer = new IntegerEncoder(8, bytes);
        }

        public void Encode(RangeEncoder encoder, byte[] record)
        {
            var bytes = Slice(record, m_recordOffset, m_last.Length);
            for (int i = 0; i < bytes.Length; i++)
                m_integer.Encode(encoder, m_last[i], bytes[i], i);
            m_last = bytes;
        }
    }
}
