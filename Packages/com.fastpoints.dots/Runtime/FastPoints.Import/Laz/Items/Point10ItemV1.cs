using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>Item POINT10 as LASzip 1.x wrote it: predictions from the last three differences, few contexts. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Point10ItemV1
    {
        const int YContexts = 20;
        const int ZContexts = 20;
        const int AngleContexts = 2;

        const int IntensityChangedBit = 32;
        const int FlagsChangedBit = 16;
        const int ClassChangedBit = 8;
        const int AngleChangedBit = 4;
        const int UserDataChangedBit = 2;
        const int SourceChangedBit = 1;

        const int ChangedOffset = 192;
        const int XOffset = ChangedOffset + SymbolModel.Bytes64;
        const int YOffset = XOffset + 64 + SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;
        const int ZOffset = YOffset + 64 + YContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;
        const int IntensityOffset = ZOffset + 64 + ZContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;
        const int AngleOffset = IntensityOffset + 64 + SymbolModel.Bytes17 + 16 * SymbolModel.Bytes256;
        const int SourceOffset = AngleOffset + 64 + AngleContexts * SymbolModel.Bytes9 + 8 * SymbolModel.Bytes256;
        const int FlagsOffset = SourceOffset + 64 + SymbolModel.Bytes17 + 16 * SymbolModel.Bytes256;
        const int ClassOffset = FlagsOffset + 256 * SymbolModel.Bytes256;
        const int UserDataOffset = ClassOffset + 256 * SymbolModel.Bytes256;
        public const int StateBytes = UserDataOffset + 256 * SymbolModel.Bytes256;

        int m_x;
        int m_y;
        int m_z;
        ushort m_intensity;
        byte m_flags;
        byte m_class;
        byte m_angle;
        byte m_userData;
        ushort m_source;

        int m_oldest;
        fixed int m_xDifferences[3];
        fixed int m_yDifferences[3];
        fixed ulong m_flagsMade[4];
        fixed ulong m_classMade[4];
        fixed ulong m_userDataMade[4];

        public static void Start(Point10ItemV1* state, byte* record)
        {
            *state = default;
            state->m_x = *(int*)record;
            state->m_y = *(int*)(record + 4);
            state->m_z = *(int*)(record + 8);
            state->m_intensity = *(ushort*)(record + 12);
            state->m_flags = record[14];
            state->m_class = record[15];
            state->m_angle = record[16];
            state->m_userData = record[17];
            state->m_source = *(ushort*)(record + 18);

            byte* memory = (byte*)state;
            SymbolModel.Initialize(memory + ChangedOffset, 64);
            IntegerModel.Initialize(memory + XOffset, 32, 1);
            IntegerModel.Initialize(memory + YOffset, 32, YContexts);
            IntegerModel.Initialize(memory + ZOffset, 32, ZContexts);
            IntegerModel.Initialize(memory + IntensityOffset, 16, 1);
            IntegerModel.Initialize(memory + AngleOffset, 8, AngleContexts);
            IntegerModel.Initialize(memory + SourceOffset, 16, 1);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Decode(Point10ItemV1* state, RangeStream* stream, byte* record)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* memory = (byte*)state;

            int* dx = state->m_xDifferences;
            int* dy = state->m_yDifferences;
            int xDifference = Median(dx[0], dx[1], dx[2])
                + IntegerModel.Decode(memory + XOffset, 32, 1, 0, out int kx, ref value, ref length, ref next);
            int yDifference = Median(dy[0], dy[1], dy[2])
                + IntegerModel.Decode(memory + YOffset, 32, YContexts, kx < 19 ? kx : 19, out int ky, ref value, ref length,
                    ref next);
            int k = (kx + ky) >> 1;
            state->m_x += xDifference;
            state->m_y += yDifference;
            state->m_z += IntegerModel.Decode(memory + ZOffset, 32, ZContexts, k < 19 ? k : 19, ref value, ref length, ref next);
            dx[state->m_oldest] = xDifference;
            dy[state->m_oldest] = yDifference;
            state->m_oldest = state->m_oldest == 2 ? 0 : state->m_oldest + 1;

            uint changed = SymbolModel.Decode(memory + ChangedOffset, 64, ref value, ref length, ref next);
            stream->Save(value, length, next);
            if (changed != 0)
                DecodeChanges(state, stream, changed, k);

            *(long*)record = *(long*)state;
            *(long*)(record + 8) = *((long*)state + 1);
            *(int*)(record + 16) = *((int*)state + 4);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        static void DecodeChanges(Point10ItemV1* state, RangeStream* stream, uint changed, int k)
        {
            byte* memory = (byte*)state;
            if ((changed & IntensityChangedBit) != 0)
                state->m_intensity = (ushort)(state->m_intensity
                    + IntegerModel.Decode(memory + IntensityOffset, 16, 1, 0, stream));
            if ((changed & FlagsChangedBit) != 0)
                state->m_flags = DecodeByte(memory + FlagsOffset, state->m_flagsMade, state->m_flags, stream);
            if ((changed & ClassChangedBit) != 0)
                state->m_class = DecodeByte(memory + ClassOffset, state->m_classMade, state->m_class, stream);
            if ((changed & AngleChangedBit) != 0)
                state->m_angle = (byte)(state->m_angle
                    + IntegerModel.Decode(memory + AngleOffset, 8, AngleContexts, k < 3 ? 1 : 0, stream));
            if ((changed & UserDataChangedBit) != 0)
                state->m_userData = DecodeByte(memory + UserDataOffset, state->m_userDataMade, state->m_userData, stream);
            if ((changed & SourceChangedBit) != 0)
                state->m_source = (ushort)(state->m_source + IntegerModel.Decode(memory + SourceOffset, 16, 1, 0, stream));
        }

        static byte DecodeByte(byte* models, ulong* made, int last, RangeStream* stream)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* model = Point10Item.ModelOfByte(models, made, last);
            uint symbol = SymbolModel.Decode(model, 256, ref value, ref length, ref next);
            stream->Save(value, length, next);
            return (byte)symbol;
        }

        static int Median(int a, int b, int c)
        {
            if (a < b)
                return b < c ? b : a < c ? c : a;
            return a < c ? a : b < c ? c : b;
        }
    }
}
