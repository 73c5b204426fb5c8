using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FastPoints.Files
{
    /// <summary>Item RGB12 as LASzip 1.x wrote it: each of the six bytes on its own. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct RgbItemV1
    {
        const int UsedAt = 64;
        const int IntegerAt = UsedAt + SymbolModel.Bytes64;
        public const int StateBytes = IntegerAt + 64 + 6 * SymbolModel.Bytes9 + 8 * SymbolModel.Bytes256;

        fixed byte m_last[8];

        public static void Start(RgbItemV1* state, byte* record)
        {
            for (int i = 0; i < 6; i++)
                state->m_last[i] = record[i];
            SymbolModel.Initialize((byte*)state + UsedAt, 64);
            IntegerModel.Initialize((byte*)state + IntegerAt, 8, 6);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Decode(RgbItemV1* state, RangeStream* stream, byte* record)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* place = (byte*)state;
            uint used = SymbolModel.Decode(place + UsedAt, 64, ref value, ref length, ref next);
            for (int i = 0; i < 6; i++)
            {
                if ((used >> i & 1) != 0)
                    state->m_last[i] = (byte)(state->m_last[i]
                        + IntegerModel.Decode(place + IntegerAt, 8, 6, i, ref value, ref length, ref next));
                record[i] = state->m_last[i];
            }
            stream->Value = value;
            stream->Length = length;
            stream->Next = next;
        }
    }
}
