using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FastPoints.Files
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

        /// <summary>An encoder changes sequence at most once a point; noise must not keep a decoder busy.</summary>
        const int MaxSequenceChanges = 4;

        const int IntegerContexts = 9;

        const int MultiplierAt = 128;
        const int ZeroAt = MultiplierAt + SymbolModel.Bytes516;
        const int IntegerAt = ZeroAt + SymbolModel.Bytes6;
        public const int StateBytes = IntegerAt + 64 + IntegerContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;

        int m_sequence;
        int m_newest;
        int m_isLayer;
        fixed long m_last[4];
        fixed int m_difference[4];
        fixed int m_extremes[4];

        /// <summary>Begins a chunk (or a scanner channel's context) at a time, given as its bits.</summary>
        public static void Start(GpsTimeItem* state, long first, bool isLayer)
        {
            *state = default;
            state->m_isLayer = isLayer ? 1 : 0;
            state->m_last[0] = first;
            byte* place = (byte*)state;
            int fewer = state->m_isLayer;
            SymbolModel.Initialize((SymbolModel*)(place + MultiplierAt), MultiplierSymbols - fewer, MultiplierSymbols);
            SymbolModel.Initialize((SymbolModel*)(place + ZeroAt), ZeroSymbols - fewer, ZeroSymbols);
            IntegerModel.Initialize(place + IntegerAt, 32, IntegerContexts);
        }

        /// <summary>The next time, as its bits.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        public static long Decode(GpsTimeItem* state, RangeStream* stream)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* integers = (byte*)state + IntegerAt;
            int sequence = state->m_sequence;

            for (int change = 0; change < MaxSequenceChanges; change++)
            {
                int last = state->m_difference[sequence];
                int symbol, context, prediction;
                if (last == 0)
                {
                    symbol = (int)SymbolModel.Decode((byte*)state + ZeroAt, ZeroSymbols, ref value, ref length, ref next);
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
                    symbol = (int)SymbolModel.Decode((byte*)state + MultiplierAt, MultiplierSymbols,
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
                    uint low = RangeCode.UInt32(ref value, ref length, ref next);
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
            stream->Value = value;
            stream->Length = length;
            stream->Next = next;
            return state->m_last[sequence];
        }
    }
}
