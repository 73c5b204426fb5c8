using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>The 20 bytes that all of point formats 0 to 5 begin with, item POINT10 in version 2. HPC#; the state is this
    /// struct and, behind it, the models.</summary>
    /// <remarks>The return counts choose the contexts: 16 for differences in x and y and for intensities, 8 (how far the return
    /// lies from its pulse's last) for heights. Intensity, class and so on are coded only where a mask of six bits says that they
    /// changed.</remarks>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Point10Item
    {
        const int XContexts = 2;
        const int YContexts = 22;
        const int ZContexts = 20;
        const int IntensityContexts = 4;
        const int MedianCount = 16;

        const int FlagsChangedBit = 32;
        const int IntensityChangedBit = 16;
        const int ClassChangedBit = 8;
        const int AngleChangedBit = 4;
        const int UserDataChangedBit = 2;
        const int SourceChangedBit = 1;

        // Places of the models, from the state's start.
        const int ChangedOffset = 1024;
        const int AngleOffset = ChangedOffset + SymbolModel.Bytes64;
        const int XOffset = AngleOffset + 2 * SymbolModel.Bytes256;
        const int YOffset = XOffset + 64 + XContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;
        const int ZOffset = YOffset + 64 + YContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;
        const int IntensityOffset = ZOffset + 64 + ZContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;
        const int SourceOffset = IntensityOffset + 64 + IntensityContexts * SymbolModel.Bytes17 + 16 * SymbolModel.Bytes256;
        const int FlagsOffset = SourceOffset + 64 + SymbolModel.Bytes17 + 16 * SymbolModel.Bytes256;
        const int ClassOffset = FlagsOffset + 256 * SymbolModel.Bytes256;
        const int UserDataOffset = ClassOffset + 256 * SymbolModel.Bytes256;
        public const int StateBytes = UserDataOffset + 256 * SymbolModel.Bytes256;

        // The last point, laid out as its record.
        int m_x;
        int m_y;
        int m_z;
        ushort m_intensity;
        byte m_flags;
        byte m_class;
        byte m_angle;
        byte m_userData;
        ushort m_source;

        fixed byte m_contextsOfReturns[64];
        fixed ushort m_lastIntensity[MedianCount];
        fixed int m_lastHeight[8];
        fixed int m_medianX[MedianCount * Median5.Ints];
        fixed int m_medianY[MedianCount * Median5.Ints];

        // Models of 1.6 KB for each last value, made when it first comes: 256 bits each.
        fixed ulong m_flagsMade[4];
        fixed ulong m_classMade[4];
        fixed ulong m_userDataMade[4];

        public static void Start(Point10Item* state, byte* record)
        {
            *state = default;
            state->SetLast(record);
            state->m_intensity = 0;
            ReturnContexts.WriteLegacy(state->m_contextsOfReturns);
            for (int i = 0; i < MedianCount; i++)
            {
                Median5.Initialize(state->m_medianX + i * Median5.Ints);
                Median5.Initialize(state->m_medianY + i * Median5.Ints);
            }
            byte* memory = (byte*)state;
            SymbolModel.Initialize(memory + ChangedOffset, 64);
            SymbolModel.Initialize(memory + AngleOffset, 256);
            SymbolModel.Initialize(memory + AngleOffset + SymbolModel.Bytes256, 256);
            IntegerModel.Initialize(memory + XOffset, 32, XContexts);
            IntegerModel.Initialize(memory + YOffset, 32, YContexts);
            IntegerModel.Initialize(memory + ZOffset, 32, ZContexts);
            IntegerModel.Initialize(memory + IntensityOffset, 16, IntensityContexts);
            IntegerModel.Initialize(memory + SourceOffset, 16, 1);
        }

        void SetLast(byte* record)
        {
            m_x = *(int*)record;
            m_y = *(int*)(record + 4);
            m_z = *(int*)(record + 8);
            m_intensity = *(ushort*)(record + 12);
            m_flags = record[14];
            m_class = record[15];
            m_angle = record[16];
            m_userData = record[17];
            m_source = *(ushort*)(record + 18);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Decode(Point10Item* state, RangeStream* stream, byte* record)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* memory = (byte*)state;

            uint changed = SymbolModel.Decode(memory + ChangedOffset, 64, ref value, ref length, ref next);
            int contexts = state->m_contextsOfReturns[state->m_flags & 63];
            if (changed != 0)
            {
                if ((changed & FlagsChangedBit) != 0)
                {
                    byte* model = ModelOfByte(memory + FlagsOffset, state->m_flagsMade, state->m_flags);
                    state->m_flags = (byte)SymbolModel.Decode(model, 256, ref value, ref length, ref next);
                    contexts = state->m_contextsOfReturns[state->m_flags & 63];
                }
                int ofReturn = contexts & ReturnContexts.MapMask;
                if ((changed & IntensityChangedBit) != 0)
                {
                    int difference = IntegerModel.Decode(memory + IntensityOffset, 16, IntensityContexts,
                        ofReturn < 3 ? ofReturn : 3, ref value, ref length, ref next);
                    state->m_lastIntensity[ofReturn] = (ushort)(state->m_lastIntensity[ofReturn] + difference);
                }
                state->m_intensity = state->m_lastIntensity[ofReturn];
                if ((changed & ClassChangedBit) != 0)
                {
                    byte* model = ModelOfByte(memory + ClassOffset, state->m_classMade, state->m_class);
                    state->m_class = (byte)SymbolModel.Decode(model, 256, ref value, ref length, ref next);
                }
                if ((changed & AngleChangedBit) != 0)
                {
                    int scanDirection = state->m_flags >> 6 & 1;
                    state->m_angle += (byte)SymbolModel.Decode(memory + AngleOffset + scanDirection * SymbolModel.Bytes256, 256,
                        ref value, ref length, ref next);
                }
                if ((changed & UserDataChangedBit) != 0)
                {
                    byte* model = ModelOfByte(memory + UserDataOffset, state->m_userDataMade, state->m_userData);
                    state->m_userData = (byte)SymbolModel.Decode(model, 256, ref value, ref length, ref next);
                }
                if ((changed & SourceChangedBit) != 0)
                {
                    // Its own locals: a call that took references to these would keep them in memory for the whole method.
                    stream->Value = value;
                    stream->Length = length;
                    stream->Next = next;
                    state->m_source = (ushort)(state->m_source + IntegerModel.Decode(memory + SourceOffset, 16, 1, 0, stream));
                    value = stream->Value;
                    length = stream->Length;
                    next = stream->Next;
                }
            }

            int map = contexts & ReturnContexts.MapMask;
            int isSingle = contexts >> ReturnContexts.SingleShift;
            int* medianX = state->m_medianX + map * Median5.Ints;
            int* medianY = state->m_medianY + map * Median5.Ints;

            int xDifference = Median5.Get(medianX)
                + IntegerModel.Decode(memory + XOffset, 32, XContexts, isSingle, out int kx, ref value, ref length, ref next);
            state->m_x += xDifference;
            Median5.Add(medianX, xDifference);

            int yContext = isSingle + (kx < 20 ? kx & ~1 : 20);
            int yDifference = Median5.Get(medianY)
                + IntegerModel.Decode(memory + YOffset, 32, YContexts, yContext, out int ky, ref value, ref length, ref next);
            state->m_y += yDifference;
            Median5.Add(medianY, yDifference);

            int k = (kx + ky) >> 1;
            int zContext = isSingle + (k < 18 ? k & ~1 : 18);
            int* lastHeight = state->m_lastHeight + (contexts >> ReturnContexts.LevelShift & ReturnContexts.LevelMask);
            int z = *lastHeight + IntegerModel.Decode(memory + ZOffset, 32, ZContexts, zContext, ref value, ref length, ref next);
            *lastHeight = z;
            state->m_z = z;

            stream->Save(value, length, next);
            *(long*)record = *(long*)state;
            *(long*)(record + 8) = *((long*)state + 1);
            *(int*)(record + 16) = *((int*)state + 4);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Encode(Point10Item* state, RangeStream* stream, byte* record)
        {
            byte* memory = (byte*)state;
            int contexts = state->m_contextsOfReturns[record[14] & 63];
            int map = contexts & ReturnContexts.MapMask, isSingle = contexts >> ReturnContexts.SingleShift;
            EncodeAttributes(state, stream, record, map);

            uint low = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            int* medianX = state->m_medianX + map * Median5.Ints;
            int* medianY = state->m_medianY + map * Median5.Ints;
            int dx = *(int*)record - state->m_x, dy = *(int*)(record + 4) - state->m_y;
            IntegerModel.Encode(memory + XOffset, 32, XContexts, isSingle, dx - Median5.Get(medianX), out int kx, ref low,
                ref length, ref next);
            Median5.Add(medianX, dx);
            IntegerModel.Encode(memory + YOffset, 32, YContexts, isSingle + (kx < 20 ? kx & ~1 : 20), dy - Median5.Get(medianY),
                out int ky, ref low, ref length, ref next);
            Median5.Add(medianY, dy);
            int k = (kx + ky) >> 1;
            int* lastHeight = state->m_lastHeight + (contexts >> ReturnContexts.LevelShift & ReturnContexts.LevelMask);
            int z = *(int*)(record + 8);
            IntegerModel.Encode(memory + ZOffset, 32, ZContexts, isSingle + (k < 18 ? k & ~1 : 18), z - *lastHeight, out _,
                ref low, ref length, ref next);
            *lastHeight = z;
            stream->Save(low, length, next);
            state->SetLast(record);
        }

        static void EncodeAttributes(Point10Item* state, RangeStream* stream, byte* record, int map)
        {
            byte* memory = (byte*)state;
            uint low = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            int intensity = *(ushort*)(record + 12);
            uint changed = 0;
            changed |= record[14] != state->m_flags ? (uint)FlagsChangedBit : 0;
            changed |= intensity != state->m_lastIntensity[map] ? (uint)IntensityChangedBit : 0;
            changed |= record[15] != state->m_class ? (uint)ClassChangedBit : 0;
            changed |= record[16] != state->m_angle ? (uint)AngleChangedBit : 0;
            changed |= record[17] != state->m_userData ? (uint)UserDataChangedBit : 0;
            changed |= *(ushort*)(record + 18) != state->m_source ? (uint)SourceChangedBit : 0;
            SymbolModel.Encode(memory + ChangedOffset, 64, changed, ref low, ref length, ref next);
            if ((changed & FlagsChangedBit) != 0)
                SymbolModel.Encode(ModelOfByte(memory + FlagsOffset, state->m_flagsMade, state->m_flags), 256, record[14],
                    ref low, ref length, ref next);
            if ((changed & IntensityChangedBit) != 0)
            {
                IntegerModel.Encode(memory + IntensityOffset, 16, IntensityContexts, map < 3 ? map : 3,
                    intensity - state->m_lastIntensity[map], out _, ref low, ref length, ref next);
                state->m_lastIntensity[map] = (ushort)intensity;
            }
            if ((changed & ClassChangedBit) != 0)
                SymbolModel.Encode(ModelOfByte(memory + ClassOffset, state->m_classMade, state->m_class), 256, record[15],
                    ref low, ref length, ref next);
            if ((changed & AngleChangedBit) != 0)
                SymbolModel.Encode(memory + AngleOffset + (record[14] >> 6 & 1) * SymbolModel.Bytes256, 256,
                    (uint)(record[16] - state->m_angle & 255), ref low, ref length, ref next);
            if ((changed & UserDataChangedBit) != 0)
                SymbolModel.Encode(ModelOfByte(memory + UserDataOffset, state->m_userDataMade, state->m_userData), 256,
                    record[17], ref low, ref length, ref next);
            stream->Save(low, length, next);
            if ((changed & SourceChangedBit) != 0)
                IntegerModel.Encode(memory + SourceOffset, 16, 1, 0, *(ushort*)(record + 18) - state->m_source, stream);
        }

        // After the value "last", made on first use.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal static byte* ModelOfByte(byte* models, ulong* made, int last)
        {
            byte* model = models + last * SymbolModel.Bytes256;
            if ((made[last >> 6] >> last & 1) == 0)
                MakeModelOfByte(model, made, last);
            return model;
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        static void MakeModelOfByte(byte* model, ulong* made, int last)
        {
            made[last >> 6] |= 1ul << (last & 63);
            SymbolModel.Initialize(model, 256);
        }
    }
}
