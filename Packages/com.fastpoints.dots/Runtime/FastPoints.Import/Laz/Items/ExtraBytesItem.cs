using System.Runtime.CompilerServices;

namespace FastPoints.Laz
{
    /// <summary>Bytes behind a point format's own fields, item BYTE in versions 1 and 2: each byte as its difference from the
    /// last point's same byte. HPC#. The state is the last bytes and, behind them, the models.</summary>
    /// <remarks>Records may have thousands of them, so this decoder looks at the input's end after every byte.</remarks>
    internal static unsafe class ExtraBytesItem
    {
        static int ModelsOffset(int bytes) => (bytes + 63) / 64 * 64;

        public static int StateBytes(int bytes) => ModelsOffset(bytes) + bytes * SymbolModel.Bytes256;

        public static void Start(byte* state, int bytes, byte* record)
        {
            for (int i = 0; i < bytes; i++)
            {
                state[i] = record[i];
                SymbolModel.Initialize(state + ModelsOffset(bytes) + i * SymbolModel.Bytes256, 256);
            }
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Decode(byte* state, int bytes, RangeStream* stream, byte* record)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* end = stream->End;
            byte* model = state + ModelsOffset(bytes);
            for (int i = 0; i < bytes && next <= end; i++)
            {
                state[i] += (byte)SymbolModel.Decode(model, 256, ref value, ref length, ref next);
                record[i] = state[i];
                model += SymbolModel.Bytes256;
            }
            stream->Save(value, length, next);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Encode(byte* state, int bytes, RangeStream* stream, byte* record)
        {
            uint low = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* model = state + ModelsOffset(bytes);
            for (int i = 0; i < bytes; i++, model += SymbolModel.Bytes256)
            {
                SymbolModel.Encode(model, 256, (uint)(record[i] - state[i] & 255), ref low, ref length, ref next);
                state[i] = record[i];
            }
            stream->Save(low, length, next);
        }

        public static int StateBytesV1(int bytes) => ModelsOffset(bytes) + IntegerModel.BytesOf(8, bytes);

        public static void StartV1(byte* state, int bytes, byte* record)
        {
            for (int i = 0; i < bytes; i++)
                state[i] = record[i];
            IntegerModel.Initialize(state + ModelsOffset(bytes), 8, bytes);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void DecodeV1(byte* state, int bytes, RangeStream* stream, byte* record)
        {
            for (int i = 0; i < bytes && !stream->IsBeyondEnd; i++)
            {
                state[i] += (byte)IntegerModel.Decode(state + ModelsOffset(bytes), 8, bytes, i, stream);
                record[i] = state[i];
            }
        }
    }
}
