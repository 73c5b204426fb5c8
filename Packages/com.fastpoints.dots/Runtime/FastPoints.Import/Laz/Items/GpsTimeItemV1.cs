using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>Item GPSTIME11 as LASzip 1.x wrote it: one sequence of times. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct GpsTimeItemV1
    {
        const int MaxMultiplier = 512;
        const int HighestMultiplier = MaxMultiplier - 3;
        const int Full = MaxMultiplier - 2;
        const int ZeroSymbols = 3;
        const int ExtremesBeforeChange = 3;
        const int IntegerContexts = 6;

        const int MultiplierOffset = 64;
        const int ZeroOffset = MultiplierOffset + SymbolModel.Bytes512;
        const int IntegerOffset = ZeroOffset + SymbolModel.Bytes4;
        public const int StateBytes = IntegerOffset + 64 + IntegerContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;

        long m_last;
        int m_difference;
        int m_extremes;

        public static void Start(GpsTimeItemV1* state, long first)
        {
            *state = default;
            state->m_last = first;
            byte* memory = (byte*)state;
            SymbolModel.Initialize(memory + MultiplierOffset, MaxMultiplier);
            SymbolModel.Initialize((SymbolModel*)(memory + ZeroOffset), ZeroSymbols, 4);
            IntegerModel.Initialize(memory + IntegerOffset, 32, IntegerContexts);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static long Decode(GpsTimeItemV1* state, RangeStream* stream)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* memory = (byte*)state;
            int last = state->m_difference;
            bool isFull, isUnchanged;
            int symbol;
            if (last == 0)
            {
                symbol = (int)SymbolModel.Decode(memory + ZeroOffset, 4, ref value, ref length, ref next);
                isUnchanged = symbol == 0;
                isFull = symbol == 2;
            }
            else
            {
                symbol = (int)SymbolModel.Decode(memory + MultiplierOffset, MaxMultiplier, ref value, ref length, ref next);
                isUnchanged = symbol > Full;
                isFull = symbol == Full;
            }

            if (isFull)
            {
                uint low = RangeCoder.UInt32(ref value, ref length, ref next);
                state->m_last = (long)RangeCoder.UInt32(ref value, ref length, ref next) << 32 | low;
            }
            else if (!isUnchanged)
            {
                int context = last == 0 ? 0 : symbol == 1 ? 1 : symbol == 0 ? 2 : symbol < 10 ? 3 : symbol < 50 ? 4 : 5;
                int prediction = symbol == 0 ? last / 4 : symbol * last;
                int difference = prediction
                    + IntegerModel.Decode(memory + IntegerOffset, 32, IntegerContexts, context, ref value, ref length, ref next);
                state->m_last += difference;
                bool becomesLast = context < 2;
                if (context == 1)
                    state->m_extremes = 0;
                if (context == 2 || symbol == HighestMultiplier)
                {
                    becomesLast = ++state->m_extremes > ExtremesBeforeChange;
                    if (becomesLast)
                        state->m_extremes = 0;
                }
                if (becomesLast)
                    state->m_difference = difference;
            }

            stream->Save(value, length, next);
            return state->m_last;
        }
    }
}
