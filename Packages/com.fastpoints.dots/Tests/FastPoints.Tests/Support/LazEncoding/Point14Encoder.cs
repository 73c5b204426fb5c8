using System;
using System.Collections.Generic;
using static FastPoints.Tests.RecordFields;

namespace FastPoints.Tests
{
    /// <summary>Item POINT14: nine layers. Gives each point's scanner channel and whether it changed, for the other
    /// items.</summary>
    sealed class Point14Encoder
    {
        const int Layers = 9;

        static readonly int[,] s_map =
        {
            { 0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5 },
            { 1, 0, 1, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3 },
            { 2, 1, 2, 4, 4, 4, 4, 4, 4, 4, 4, 3, 3, 3, 3, 3 },
            { 3, 3, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4 },
            { 4, 3, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4 },
            { 5, 3, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4 },
            { 3, 3, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4 },
            { 4, 3, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4 },
            { 4, 3, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4 },
            { 5, 3, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4 },
            { 5, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4 },
            { 5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 4, 4, 4 },
            { 5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4, 4 },
            { 5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4 },
            { 5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5 },
            { 5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5 },
        };

        sealed class Context
        {
            public readonly byte[] Last;
            public bool TimeChanged;
            public readonly MedianOfFive[] MedianX = new MedianOfFive[12];
            public readonly MedianOfFive[] MedianY = new MedianOfFive[12];
            public readonly int[] Heights = new int[8];
            public readonly int[] Intensities = new int[8];
            public readonly SymbolEncoder[] Changed = new SymbolEncoder[8];
            public readonly SymbolEncoder Channel = new SymbolEncoder(3);
            public readonly SymbolEncoder[] NumberOfReturns = new SymbolEncoder[16];
            public readonly SymbolEncoder[] ReturnNumber = new SymbolEncoder[16];
            public readonly SymbolEncoder ReturnStep = new SymbolEncoder(13);
            public readonly IntegerEncoder X = new IntegerEncoder(32, 2);
            public readonly IntegerEncoder Y = new IntegerEncoder(32, 22);
            public readonly IntegerEncoder Z = new IntegerEncoder(32, 20);
            public readonly SymbolEncoder[] Class = new SymbolEncoder[64];
            public readonly SymbolEncoder[] Flags = new SymbolEncoder[64];
            public readonly SymbolEncoder[] UserData = new SymbolEncoder[64];
            public readonly IntegerEncoder Intensity = new IntegerEncoder(16, 4);
            public readonly IntegerEncoder Angle = new IntegerEncoder(16, 2);
            public readonly IntegerEncoder Source = new IntegerEncoder(16, 1);
            public readonly GpsTimeEncoder Time;

            public Context(byte[] last)
            {
                Last = (byte[])last.Clone();
                for (int i = 0; i < 12; i++)
                {
                    MedianX[i] = new MedianOfFive();
                    MedianY[i] = new MedianOfFive();
                }
                for (int i = 0; i < 8; i++)
                {
                    Heights[i] = Int32(last, 8);
                    Intensities[i] = UInt16(last, 12);
                    Changed[i] = new SymbolEncoder(128);
                }
                Time = new GpsTimeEncoder(Int64(last, 22), 22, true);
            }
        }

        readonly Context[] m_contexts = new Context[4];
        readonly RangeEncoder[] m_layers = new RangeEncoder[Layers];
        readonly bool[] m_isUsed = new bool[Layers];

        public Point14Encoder(byte[] first)
        {
            for (int i = 0; i < Layers; i++)
                m_layers[i] = new RangeEncoder();
            m_isUsed[0] = m_isUsed[1] = true;
            Channel = first[15] >> 4 & 3;
            m_contexts[Channel] = new Context(Slice(first, 0, 30));
        }

        public int Channel { get; private set; }

        public bool ChannelChanged { get; private set; }

        public void Encode(byte[] record)
        {
            var before = m_contexts[Channel];
            int n = record[14] >> 4, r = record[14] & 15;
            int lastR = before.Last[14] & 15, lastN = before.Last[14] >> 4;
            int place = (lastR == 1 ? 1 : 0) + (lastR >= lastN ? 2 : 0) + (before.TimeChanged ? 4 : 0);
            int channel = record[15] >> 4 & 3;
            ChannelChanged = channel != Channel;
            var context = m_contexts[channel] ?? (m_contexts[channel] = new Context(before.Last));
            var last = context.Last;
            lastR = last[14] & 15;
            lastN = last[14] >> 4;

            bool sourceChanged = UInt16(record, 20) != UInt16(last, 20);
            bool timeChanged = Int64(record, 22) != Int64(last, 22);
            bool angleChanged = UInt16(record, 18) != UInt16(last, 18);
            int step = r == lastR ? 0 : r == (lastR + 1) % 16 ? 1 : r == (lastR + 15) % 16 ? 2 : 3;
            int changed = (ChannelChanged ? 64 : 0) | (sourceChanged ? 32 : 0) | (timeChanged ? 16 : 0) | (angleChanged ? 8 : 0)
                | (n != lastN ? 4 : 0) | step;
            var encoder = m_layers[0];
            before.Changed[place].Encode(encoder, changed);
            if (ChannelChanged)
                before.Channel.Encode(encoder, (channel - Channel + 4) % 4 - 1);
            Channel = channel;
            if (n != lastN)
                Symbol(encoder, context.NumberOfReturns, lastN, n, 16);
            if (step == 3 && timeChanged)
                Symbol(encoder, context.ReturnNumber, lastR, r, 16);
            else if (step == 3)
                context.ReturnStep.Encode(encoder, (r - lastR + 16) % 16 - 2);

            int time = timeChanged ? 1 : 0, median = s_map[n, r] * 2 + time, isSingle = n == 1 ? 1 : 0;
            int dx = unchecked(Int32(record, 0) - Int32(last, 0)), dy = unchecked(Int32(record, 4) - Int32(last, 4));
            context.X.Encode(encoder, context.MedianX[median].Value, dx, isSingle);
            context.MedianX[median].Add(dx);
            context.Y.Encode(encoder, context.MedianY[median].Value, dy, isSingle + (context.X.K < 20 ? context.X.K & ~1 : 20));
            context.MedianY[median].Add(dy);
            EncodeOthers(context, record, (r == 1 ? 2 : 0) + (r >= n ? 1 : 0), time, isSingle,
                Math.Min(7, Math.Abs(n - r)), changed);
            Array.Copy(record, last, 30);
            context.TimeChanged = timeChanged;
        }

        void EncodeOthers(Context context, byte[] record, int place, int time, int isSingle, int level, int changed)
        {
            var last = context.Last;
            int k = (context.X.K + context.Y.K) / 2;
            context.Z.Encode(m_layers[1], context.Heights[level], Int32(record, 8), isSingle + (k < 18 ? k & ~1 : 18));
            context.Heights[level] = Int32(record, 8);

            m_isUsed[2] |= record[16] != last[16];
            Symbol(m_layers[2], context.Class, (last[16] & 31) * 2 + (place == 3 ? 1 : 0), record[16], 256);
            m_isUsed[3] |= Flags(record) != Flags(last);
            Symbol(m_layers[3], context.Flags, Flags(last), Flags(record), 64);
            m_isUsed[4] |= UInt16(record, 12) != UInt16(last, 12);
            context.Intensity.Encode(m_layers[4], context.Intensities[place * 2 + time], UInt16(record, 12), place);
            context.Intensities[place * 2 + time] = UInt16(record, 12);
            if ((changed & 8) != 0)
            {
                m_isUsed[5] = true;
                context.Angle.Encode(m_layers[5], (short)UInt16(last, 18), (short)UInt16(record, 18), time);
            }
            m_isUsed[6] |= record[17] != last[17];
            Symbol(m_layers[6], context.UserData, last[17] / 4, record[17], 256);
            if ((changed & 32) != 0)
            {
                m_isUsed[7] = true;
                context.Source.Encode(m_layers[7], UInt16(last, 20), UInt16(record, 20), 0);
            }
            if (time != 0)
            {
                m_isUsed[8] = true;
                context.Time.Encode(m_layers[8], record);
            }
        }

        public void Finish(List<byte[]> layers)
        {
            for (int i = 0; i < Layers; i++)
                layers.Add(m_isUsed[i] ? m_layers[i].Finish() : Array.Empty<byte>());
        }

        static int Flags(byte[] record) => record[15] & 15 | record[15] >> 6 << 4;

        static void Symbol(RangeEncoder encoder, SymbolEncoder[] models, int last, int value, int symbols)
        {
            models[last] ??= new SymbolEncoder(symbols);
            models[last].Encode(encoder, value);
        }
    }
}
