using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace FastPoints.Laz
{
    /// <summary>GPS times of 8 bytes: item GPSTIME11 in version 2, and the time layer of POINT14. Doubles are predicted as their
    /// bits, by multiples of the last difference, in up to four interleaved sequences. HPC#.</summary>
    /// <remarks>POINT14 says elsewhere whether the time changed at all, so its symbols lack "unchanged". Otherwise the two are
    /// one.</remarks>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct GpsTimeItem
    {
        const int Multiplier = 500;
        const int LowestMultiplier = -10;

        // Symbols of GPSTIME11; POINT14's are one less from "full" on.
        const int Unchanged = Multiplier - LowestMultiplier + 1;
        const int Full = Unchanged + 1;
        const int MultiplierSymbols = Full + 4;
        const int ZeroSymbols = 6;

        /// <summary>Times that a difference beyond the prediction comes before it becomes the one to multiply.</summary>
        const int ExtremesBeforeChange = 3;
        const int MaxSequenceChanges = 4; // An encoder changes sequence at most once a point; noise must not keep a decoder busy.

        const int IntegerContexts = 9;

        const int MultiplierOffset = 128;
        const int ZeroOffset = MultiplierOffset + SymbolModel.Bytes516;
        const int IntegerOffset = ZeroOffset + SymbolModel.Bytes6;
        public const int StateBytes = IntegerOffset + 64 + IntegerContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;

        int m_sequence;
        int m_newest;
        int m_isLayer;
        fixed long m_last[4];
        fixed int m_difference[4];
        fixed int m_extremes[4];

        // A chunk (or a scanner channel's context); the time as its bits.
        public static void Start(GpsTimeItem* state, long first, bool isLayer)
        {
            *state = default;
            state->m_isLayer = isLayer ? 1 : 0;
            state->m_last[0] = first;
            byte* memory = (byte*)state;
            int fewer = state->m_isLayer;
            SymbolModel.Initialize((SymbolModel*)(memory + MultiplierOffset), MultiplierSymbols - fewer, MultiplierSymbols);
            SymbolModel.Initialize((SymbolModel*)(memory + ZeroOffset), ZeroSymbols - fewer, ZeroSymbols);
            IntegerModel.Initialize(memory + IntegerOffset, 32, IntegerContexts);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static long Decode(GpsTimeItem* state, RangeStream* stream)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* integers = (byte*)state + IntegerOffset;
            int sequence = state->m_sequence;

            for (int change = 0; change < MaxSequenceChanges; change++)
            {
                int last = state->m_difference[sequence];
                int symbol, context, prediction;
                if (last == 0)
                {
                    symbol = (int)SymbolModel.Decode((byte*)state + ZeroOffset, ZeroSymbols, ref value, ref length, ref next);
                    symbol += state->m_isLayer;
                    if (symbol == 0)
                        break;
                    if (symbol > 2)
                    {
                        sequence = (sequence + symbol - 2) & 3;
                        continue;
                    }
                    context = symbol == 1 ? 0 : 8;
                    prediction = 0;
                }
                else
                {
                    symbol = (int)SymbolModel.Decode((byte*)state + MultiplierOffset, MultiplierSymbols,
                        ref value, ref length, ref next);
                    if (symbol >= Unchanged)
                        symbol += state->m_isLayer;
                    if (symbol == Unchanged)
                        break;
                    if (symbol > Full)
                    {
                        sequence = (sequence + symbol - Full) & 3;
                        continue;
                    }
                    int multiplier = symbol <= Multiplier ? symbol : Multiplier - symbol;
                    prediction = multiplier * last;
                    context = symbol == Full ? 8
                        : symbol == 1 ? 1
                        : symbol == 0 ? 7
                        : symbol < 10 ? 2
                        : symbol < Multiplier ? 3 : symbol == Multiplier ? 4 : multiplier > LowestMultiplier ? 5 : 6;
                }
                if (context == 8)
                    prediction = (int)(state->m_last[sequence] >> 32);

                int difference = prediction
                    + IntegerModel.Decode(integers, 32, IntegerContexts, context, ref value, ref length, ref next);

                if (context == 8)
                {
                    // Too far for any sequence: a new one takes the oldest's place, its lower half unpredicted.
                    uint low = RangeCoder.UInt32(ref value, ref length, ref next);
                    sequence = state->m_newest = (state->m_newest + 1) & 3;
                    state->m_last[sequence] = (long)difference << 32 | low;
                    state->m_difference[sequence] = 0;
                    state->m_extremes[sequence] = 0;
                    break;
                }

                state->m_last[sequence] += difference;
                if (context == 0)
                {
                    state->m_difference[sequence] = difference;
                    state->m_extremes[sequence] = 0;
                }
                else if (context == 1)
                {
                    state->m_extremes[sequence] = 0;
                }
                else if (context == 4 || context >= 6)
                {
                    if (++state->m_extremes[sequence] > ExtremesBeforeChange)
                    {
                        state->m_difference[sequence] = difference;
                        state->m_extremes[sequence] = 0;
                    }
                }
                break;
            }

            state->m_sequence = sequence;
            stream->Save(value, length, next);
            return state->m_last[sequence];
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Encode(GpsTimeItem* state, RangeStream* stream, long time)
        {
            uint low = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* integers = (byte*)state + IntegerOffset;
            int sequence = state->m_sequence, last = state->m_difference[sequence];
            long difference = time - state->m_last[sequence];
            if (difference != (int)difference)
            {
                // Another sequence that the time is near to, or a new one in place of the oldest.
                int other = 1;
                while (other < 4 && time - state->m_last[sequence + other & 3] is long from && from != (int)from)
                    other++;
                other &= 3;
                EncodeSymbol(state, last, other == 0 ? 2 : 2 + other, Full + other, ref low, ref length, ref next);
                if (other == 0)
                {
                    IntegerModel.Encode(integers, 32, IntegerContexts, 8,
                        (int)(time >> 32) - (int)(state->m_last[sequence] >> 32), out _, ref low, ref length, ref next);
                    RangeCoder.PutUInt32((uint)time, ref low, ref length, ref next);
                    sequence = state->m_newest = (state->m_newest + 1) & 3;
                    state->m_last[sequence] = time;
                    state->m_difference[sequence] = 0;
                    state->m_extremes[sequence] = 0;
                    state->m_sequence = sequence;
                    stream->Save(low, length, next);
                    return;
                }
                state->m_sequence = sequence = sequence + other & 3;
                last = state->m_difference[sequence];
                difference = time - state->m_last[sequence];
            }
            if (difference == 0 && state->m_isLayer == 0)
            {
                EncodeSymbol(state, last, 0, Unchanged, ref low, ref length, ref next);
            }
            else if (last == 0)
            {
                EncodeSymbol(state, last, 1, 0, ref low, ref length, ref next);
                IntegerModel.Encode(integers, 32, IntegerContexts, 0, (int)difference, out _, ref low, ref length, ref next);
                state->m_difference[sequence] = (int)difference;
                state->m_extremes[sequence] = 0;
            }
            else
            {
                EncodeMultiplier(state, sequence, (int)difference, last, ref low, ref length, ref next);
            }
            state->m_last[sequence] = time;
            stream->Save(low, length, next);
        }

        static void EncodeMultiplier(GpsTimeItem* state, int sequence, int difference, int last, ref uint low, ref uint length,
            ref byte* next)
        {
            double ratio = (float)difference / (float)last;
            int multiplier = (int)math.clamp(ratio >= 0 ? math.floor(ratio + 0.5) : math.ceil(ratio - 0.5), LowestMultiplier,
                Multiplier);
            SymbolModel.Encode((byte*)state + MultiplierOffset, MultiplierSymbols,
                (uint)(multiplier >= 0 ? multiplier : Multiplier - multiplier), ref low, ref length, ref next);
            int context = multiplier == 1 ? 1 : multiplier == 0 ? 7 : multiplier == Multiplier ? 4
                : multiplier == LowestMultiplier ? 6 : multiplier < 0 ? 5 : multiplier < 10 ? 2 : 3;
            IntegerModel.Encode((byte*)state + IntegerOffset, 32, IntegerContexts, context, difference - multiplier * last, out _,
                ref low, ref length, ref next);
            if (multiplier == 1)
                state->m_extremes[sequence] = 0;
            else if ((context == 4 || context >= 6) && ++state->m_extremes[sequence] > ExtremesBeforeChange)
            {
                state->m_difference[sequence] = difference;
                state->m_extremes[sequence] = 0;
            }
        }

        /// <summary>One of two symbols, by whether there is a difference to multiply.</summary>
        static void EncodeSymbol(GpsTimeItem* state, int last, int ofZero, int ofMultiplier, ref uint low, ref uint length,
            ref byte* next)
        {
            if (last == 0)
                SymbolModel.Encode((byte*)state + ZeroOffset, ZeroSymbols, (uint)(ofZero - state->m_isLayer), ref low, ref length,
                    ref next);
            else
                SymbolModel.Encode((byte*)state + MultiplierOffset, MultiplierSymbols, (uint)(ofMultiplier - state->m_isLayer),
                    ref low, ref length, ref next);
        }
    }
}
