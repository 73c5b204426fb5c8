using System;
using System.Collections.Generic;
using static FastPoints.Tests.RecordFields;

namespace FastPoints.Tests
{
    /// <summary>An item of layered chunks beside POINT14.</summary>
    interface ILayeredItemEncoder
    {
        /// <param name="channelChanged">Whether it differs from the last point's.</param>
        void Encode(byte[] record, int channel, bool channelChanged);

        void Finish(List<byte[]> layers);
    }

    /// <summary>The contexts of one layer, by scanner channel, each with its encoder and its last bytes. Version 3 takes context
    /// 0 but for points where the channel changes; and where these go back to a context, the last bytes are those of the one
    /// left.</summary>
    sealed class LayerContexts<T> where T : class
    {
        readonly Func<byte[], T> m_make;
        readonly Func<T, byte[]> m_lastOf;
        readonly bool m_isV4;
        readonly T[] m_contexts = new T[4];
        int m_current;

        public LayerContexts(byte[] first, int channel, bool isV4, Func<byte[], T> make, Func<T, byte[]> lastOf)
        {
            m_make = make;
            m_lastOf = lastOf;
            m_isV4 = isV4;
            m_current = channel;
            m_contexts[channel] = make(first);
        }

        public T Choose(int channel, bool channelChanged, out byte[] last)
        {
            int wanted = m_isV4 || channelChanged ? channel : 0;
            last = m_lastOf(m_contexts[m_current]);
            if (wanted != m_current)
            {
                m_current = wanted;
                bool isNew = m_contexts[wanted] == null;
                if (isNew)
                    m_contexts[wanted] = m_make(last);
                if (isNew || m_isV4)
                    last = m_lastOf(m_contexts[wanted]);
            }
            return m_contexts[m_current];
        }
    }

    /// <summary>RGB14, and the first layer of RGBNIR14.</summary>
    sealed class RgbLayerEncoder : ILayeredItemEncoder
    {
        readonly RangeEncoder m_encoder = new RangeEncoder();
        readonly LayerContexts<RgbEncoder> m_contexts;
        readonly int m_recordOffset;
        bool m_isUsed;

        public RgbLayerEncoder(byte[] first, int recordOffset, int channel, bool isV4)
        {
            m_recordOffset = recordOffset;
            m_contexts = new LayerContexts<RgbEncoder>(Slice(first, recordOffset, 6), channel, isV4,
                last => new RgbEncoder(At(last, recordOffset), recordOffset), context => context.Last);
        }

        public void Encode(byte[] record, int channel, bool channelChanged)
        {
            var context = m_contexts.Choose(channel, channelChanged, out var last);
            for (int i = 0; i < 6; i++)
                m_isUsed |= record[m_recordOffset + i] != last[i];
            context.Encode(m_encoder, record, last);
        }

        public void Finish(List<byte[]> layers) => layers.Add(m_isUsed ? m_encoder.Finish() : Array.Empty<byte>());

        internal static byte[] At(byte[] bytes, int offset)
        {
            var record = new byte[offset + bytes.Length];
            bytes.CopyTo(record, offset);
            return record;
        }
    }

    /// <summary>The second layer of RGBNIR14.</summary>
    sealed class InfraredLayerEncoder : ILayeredItemEncoder
    {
        sealed class Context
        {
            public readonly SymbolEncoder Used = new SymbolEncoder(4);
            public readonly SymbolEncoder[] Bytes = { new SymbolEncoder(256), new SymbolEncoder(256) };
            public byte[] Last;
        }

        readonly RangeEncoder m_encoder = new RangeEncoder();
        readonly LayerContexts<Context> m_contexts;
        readonly int m_recordOffset;
        bool m_isUsed;

        public InfraredLayerEncoder(byte[] first, int recordOffset, int channel, bool isV4)
        {
            m_recordOffset = recordOffset;
            m_contexts = new LayerContexts<Context>(Slice(first, recordOffset, 2), channel, isV4,
                last => new Context { Last = (byte[])last.Clone() }, context => context.Last);
        }

        public void Encode(byte[] record, int channel, bool channelChanged)
        {
            var context = m_contexts.Choose(channel, channelChanged, out var last);
            int used = (record[m_recordOffset] != last[0] ? 1 : 0) | (record[m_recordOffset + 1] != last[1] ? 2 : 0);
            m_isUsed |= used != 0;
            context.Used.Encode(m_encoder, used);
            for (int i = 0; i < 2; i++)
            {
                if ((used >> i & 1) != 0)
                    context.Bytes[i].Encode(m_encoder, record[m_recordOffset + i] - last[i] & 255);
                last[i] = record[m_recordOffset + i];
            }
        }

        public void Finish(List<byte[]> layers) => layers.Add(m_isUsed ? m_encoder.Finish() : Array.Empty<byte>());
    }

    /// <summary>WAVEPACKET14.</summary>
    sealed class WaveLayerEncoder : ILayeredItemEncoder
    {
        readonly RangeEncoder m_encoder = new RangeEncoder();
        readonly LayerContexts<WavePacketEncoder> m_contexts;
        readonly int m_recordOffset;
        bool m_isUsed;

        public WaveLayerEncoder(byte[] first, int recordOffset, int channel, bool isV4)
        {
            m_recordOffset = recordOffset;
            m_contexts = new LayerContexts<WavePacketEncoder>(Slice(first, recordOffset, 29), channel, isV4,
                last => new WavePacketEncoder(RgbLayerEncoder.At(last, recordOffset), recordOffset), context => context.Last);
        }

        public void Encode(byte[] record, int channel, bool channelChanged)
        {
            var context = m_contexts.Choose(channel, channelChanged, out var last);
            for (int i = 0; i < 29; i++)
                m_isUsed |= record[m_recordOffset + i] != last[i];
            context.Encode(m_encoder, record, last);
        }

        public void Finish(List<byte[]> layers) => layers.Add(m_isUsed ? m_encoder.Finish() : Array.Empty<byte>());
    }

    /// <summary>One byte of BYTE14.</summary>
    sealed class ByteLayerEncoder : ILayeredItemEncoder
    {
        sealed class Context
        {
            public readonly SymbolEncoder Model = new SymbolEncoder(256);
            public byte[] Last;
        }

        readonly RangeEncoder m_encoder = new RangeEncoder();
        readonly LayerContexts<Context> m_contexts;
        readonly int m_recordOffset;
        bool m_isUsed;

        public ByteLayerEncoder(byte[] first, int recordOffset, int channel, bool isV4)
        {
            m_recordOffset = recordOffset;
            m_contexts = new LayerContexts<Context>(Slice(first, recordOffset, 1), channel, isV4,
                last => new Context { Last = (byte[])last.Clone() }, context => context.Last);
        }

        public void Encode(byte[] record, int channel, bool channelChanged)
        {
            var context = m_contexts.Choose(channel, channelChanged, out var last);
            byte value = record[m_recordOffset];
            m_isUsed |= value != last[0];
            context.Model.Encode(m_encoder, value - last[0] & 255);
            last[0] = value;
        }

        public void Finish(List<byte[]> layers) => layers.Add(m_isUsed ? m_encoder.Finish() : Array.Empty<byte>());
    }
}
