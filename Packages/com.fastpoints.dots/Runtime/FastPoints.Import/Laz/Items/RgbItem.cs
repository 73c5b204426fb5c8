using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>Colours of three 16-bit values: item RGB12 in version 2, and the colour layer of RGB14 and RGBNIR14. A mask says
    /// which of the six bytes changed and whether the colour is not grey; green is predicted from red's change, blue from both.
    /// HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct RgbItem
    {
        const int IsColorBit = 64;

        const int UsedOffset = 64;
        const int ByteOffset = UsedOffset + SymbolModel.Bytes128;
        public const int StateBytes = ByteOffset + 6 * SymbolModel.Bytes256;

        public fixed ushort Last[4];

        public static void Start(RgbItem* state, byte* record)
        {
            state->Last[0] = *(ushort*)record;
            state->Last[1] = *(ushort*)(record + 2);
            state->Last[2] = *(ushort*)(record + 4);
            byte* memory = (byte*)state;
            SymbolModel.Initialize(memory + UsedOffset, 128);
            for (int i = 0; i < 6; i++)
                SymbolModel.Initialize(memory + ByteOffset + i * SymbolModel.Bytes256, 256);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Decode(RgbItem* state, RangeStream* stream, byte* record)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            Decode((byte*)state, state->Last, record, ref value, ref length, ref next);
            stream->Save(value, length, next);
        }

        // "last" becomes the colour (and is apart from the models, since RGB14 version 3 mixes up whose it is).
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Decode(byte* memory, ushort* last, byte* record, ref uint value, ref uint length, ref byte* next)
        {
            byte* models = memory + ByteOffset;
            int used = (int)SymbolModel.Decode(memory + UsedOffset, 128, ref value, ref length, ref next);
            int redLow = last[0] & 255, redHigh = last[0] >> 8;
            int lowChange = -redLow, highChange = -redHigh;
            if ((used & 1) != 0)
                redLow = redLow + (int)SymbolModel.Decode(models, 256, ref value, ref length, ref next) & 255;
            if ((used & 2) != 0)
                redHigh = redHigh
                    + (int)SymbolModel.Decode(models + SymbolModel.Bytes256, 256, ref value, ref length, ref next) & 255;
            int red = redHigh << 8 | redLow;
            int green = red, blue = red;
            if ((used & IsColorBit) != 0)
            {
                lowChange += redLow;
                highChange += redHigh;
                int greenLow = last[1] & 255, greenHigh = last[1] >> 8;
                int blueLow = last[2] & 255, blueHigh = last[2] >> 8;
                int lastGreenLow = greenLow, lastGreenHigh = greenHigh;
                if ((used & 4) != 0)
                    greenLow = Clamp(lowChange + greenLow)
                        + (int)SymbolModel.Decode(models + 2 * SymbolModel.Bytes256, 256, ref value, ref length, ref next) & 255;
                if ((used & 16) != 0)
                    blueLow = Clamp((lowChange + greenLow - lastGreenLow) / 2 + blueLow)
                        + (int)SymbolModel.Decode(models + 4 * SymbolModel.Bytes256, 256, ref value, ref length, ref next) & 255;
                if ((used & 8) != 0)
                    greenHigh = Clamp(highChange + greenHigh)
                        + (int)SymbolModel.Decode(models + 3 * SymbolModel.Bytes256, 256, ref value, ref length, ref next) & 255;
                if ((used & 32) != 0)
                    blueHigh = Clamp((highChange + greenHigh - lastGreenHigh) / 2 + blueHigh)
                        + (int)SymbolModel.Decode(models + 5 * SymbolModel.Bytes256, 256, ref value, ref length, ref next) & 255;
                green = greenHigh << 8 | greenLow;
                blue = blueHigh << 8 | blueLow;
            }
            last[0] = (ushort)red;
            last[1] = (ushort)green;
            last[2] = (ushort)blue;
            *(ushort*)record = (ushort)red;
            *(ushort*)(record + 2) = (ushort)green;
            *(ushort*)(record + 4) = (ushort)blue;
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Encode(RgbItem* state, RangeStream* stream, byte* record)
        {
            uint low = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            Encode((byte*)state, state->Last, record, ref low, ref length, ref next);
            stream->Save(low, length, next);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Encode(byte* memory, ushort* last, byte* record, ref uint low, ref uint length, ref byte* next)
        {
            // Bytes: red low and high, green low and high, blue low and high.
            byte* models = memory + ByteOffset;
            byte* was = (byte*)last;
            uint used = 0;
            for (int i = 0; i < 6; i++)
                used |= record[i] != was[i] ? 1u << i : 0;
            bool isGrey = record[0] == record[2] && record[0] == record[4] && record[1] == record[3] && record[1] == record[5];
            used |= isGrey ? 0 : (uint)IsColorBit;
            SymbolModel.Encode(memory + UsedOffset, 128, used, ref low, ref length, ref next);
            if ((used & 1) != 0)
                Put(models, 0, record[0] - was[0], ref low, ref length, ref next);
            if ((used & 2) != 0)
                Put(models, 1, record[1] - was[1], ref low, ref length, ref next);
            if (!isGrey)
            {
                int lowChange = record[0] - was[0], highChange = record[1] - was[1];
                if ((used & 4) != 0)
                    Put(models, 2, record[2] - Clamp(lowChange + was[2]), ref low, ref length, ref next);
                if ((used & 16) != 0)
                    Put(models, 4, record[4] - Clamp((lowChange + record[2] - was[2]) / 2 + was[4]), ref low, ref length,
                        ref next);
                if ((used & 8) != 0)
                    Put(models, 3, record[3] - Clamp(highChange + was[3]), ref low, ref length, ref next);
                if ((used & 32) != 0)
                    Put(models, 5, record[5] - Clamp((highChange + record[3] - was[3]) / 2 + was[5]), ref low, ref length,
                        ref next);
            }
            for (int i = 0; i < 6; i++)
                was[i] = record[i];
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static void Put(byte* models, int model, int difference, ref uint low, ref uint length, ref byte* next) =>
            SymbolModel.Encode(models + model * SymbolModel.Bytes256, 256, (uint)(difference & 255), ref low, ref length,
                ref next);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static int Clamp(int value) => value <= 0 ? 0 : value >= 255 ? 255 : value;
    }

    /// <summary>Item RGB12 as LASzip 1.x wrote it: each of the six bytes on its own. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct RgbItemV1
    {
        const int UsedOffset = 64;
        const int IntegerOffset = UsedOffset + SymbolModel.Bytes64;
        public const int StateBytes = IntegerOffset + 64 + 6 * SymbolModel.Bytes9 + 8 * SymbolModel.Bytes256;

        fixed byte m_last[8];

        public static void Start(RgbItemV1* state, byte* record)
        {
            for (int i = 0; i < 6; i++)
                state->m_last[i] = record[i];
            SymbolModel.Initialize((byte*)state + UsedOffset, 64);
            IntegerModel.Initialize((byte*)state + IntegerOffset, 8, 6);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Decode(RgbItemV1* state, RangeStream* stream, byte* record)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* memory = (byte*)state;
            uint used = SymbolModel.Decode(memory + UsedOffset, 64, ref value, ref length, ref next);
            for (int i = 0; i < 6; i++)
            {
                if ((used >> i & 1) != 0)
                    state->m_last[i] = (byte)(state->m_last[i]
                        + IntegerModel.Decode(memory + IntegerOffset, 8, 6, i, ref value, ref length, ref next));
                record[i] = state->m_last[i];
            }
            stream->Save(value, length, next);
        }
    }
}
