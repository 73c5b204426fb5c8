using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>Wave packets of 29 bytes: item WAVEPACKET13, and the layer of WAVEPACKET14. The record's descriptor index comes
    /// first; the offset into the waveforms follows the last packet, repeats it, or steps. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct WavePacketItem
    {
        public const int RecordBytes = 29;

        const int IndexOffset = 64;
        const int OffsetKindOffset = IndexOffset + SymbolModel.Bytes256;
        const int OffsetModelOffset = OffsetKindOffset + 4 * SymbolModel.Bytes4;
        const int OneIntegerBytes = 64 + SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;
        const int SizeOffset = OffsetModelOffset + OneIntegerBytes;
        const int LocationOffset = SizeOffset + OneIntegerBytes;
        const int DirectionOffset = LocationOffset + OneIntegerBytes;
        public const int StateBytes = DirectionOffset + 64 + 3 * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;

        const int SameOffset = 0;
        const int FollowingOffset = 1;
        const int SteppedOffset = 2;

        int m_step;
        int m_offsetKind;

        public fixed byte Last[RecordBytes - 1];

        public static void Start(WavePacketItem* state, byte* record)
        {
            *state = default;
            for (int i = 0; i < RecordBytes - 1; i++)
                state->Last[i] = record[i + 1];
            byte* memory = (byte*)state;
            SymbolModel.Initialize(memory + IndexOffset, 256);
            for (int i = 0; i < 4; i++)
                SymbolModel.Initialize(memory + OffsetKindOffset + i * SymbolModel.Bytes4, 4);
            IntegerModel.Initialize(memory + OffsetModelOffset, 32, 1);
            IntegerModel.Initialize(memory + SizeOffset, 32, 1);
            IntegerModel.Initialize(memory + LocationOffset, 32, 1);
            IntegerModel.Initialize(memory + DirectionOffset, 32, 3);
        }

        // "last" (28 bytes) becomes the packet.
        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Decode(WavePacketItem* state, byte* last, RangeStream* stream, byte* record)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* memory = (byte*)state;

            record[0] = (byte)SymbolModel.Decode(memory + IndexOffset, 256, ref value, ref length, ref next);

            ulong lastOffset = *(ulong*)last;
            uint lastSize = *(uint*)(last + 8);
            state->m_offsetKind = (int)SymbolModel.Decode(memory + OffsetKindOffset + state->m_offsetKind * SymbolModel.Bytes4, 4,
                ref value, ref length, ref next);
            ulong offset;
            if (state->m_offsetKind == SameOffset)
            {
                offset = lastOffset;
            }
            else if (state->m_offsetKind == FollowingOffset)
            {
                offset = lastOffset + lastSize;
            }
            else if (state->m_offsetKind == SteppedOffset)
            {
                state->m_step += IntegerModel.Decode(memory + OffsetModelOffset, 32, 1, 0, ref value, ref length, ref next);
                offset = lastOffset + (ulong)(long)state->m_step;
            }
            else
            {
                uint low = RangeCoder.UInt32(ref value, ref length, ref next);
                offset = (ulong)RangeCoder.UInt32(ref value, ref length, ref next) << 32 | low;
            }
            stream->Save(value, length, next);

            *(ulong*)last = offset;
            *(uint*)(last + 8) = lastSize + (uint)IntegerModel.Decode(memory + SizeOffset, 32, 1, 0, stream);
            *(int*)(last + 12) += IntegerModel.Decode(memory + LocationOffset, 32, 1, 0, stream);
            for (int i = 0; i < 3; i++)
                *(int*)(last + 16 + 4 * i) += IntegerModel.Decode(memory + DirectionOffset, 32, 3, i, stream);
            for (int i = 0; i < RecordBytes - 1; i++)
                record[i + 1] = last[i];
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Encode(WavePacketItem* state, byte* last, RangeStream* stream, byte* record)
        {
            uint low = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            byte* memory = (byte*)state;
            byte* packet = record + 1;
            SymbolModel.Encode(memory + IndexOffset, 256, record[0], ref low, ref length, ref next);
            long difference = *(long*)packet - *(long*)last;
            int kind = difference == 0 ? SameOffset : difference == *(uint*)(last + 8) ? FollowingOffset
                : difference == (int)difference ? SteppedOffset : SteppedOffset + 1;
            SymbolModel.Encode(memory + OffsetKindOffset + state->m_offsetKind * SymbolModel.Bytes4, 4, (uint)kind, ref low,
                ref length, ref next);
            state->m_offsetKind = kind;
            if (kind == SteppedOffset)
            {
                IntegerModel.Encode(memory + OffsetModelOffset, 32, 1, 0, (int)difference - state->m_step, out _, ref low,
                    ref length, ref next);
                state->m_step = (int)difference;
            }
            else if (kind > SteppedOffset)
            {
                RangeCoder.PutUInt32(*(uint*)packet, ref low, ref length, ref next);
                RangeCoder.PutUInt32(*(uint*)(packet + 4), ref low, ref length, ref next);
            }
            stream->Save(low, length, next);
            IntegerModel.Encode(memory + SizeOffset, 32, 1, 0, *(int*)(packet + 8) - *(int*)(last + 8), stream);
            IntegerModel.Encode(memory + LocationOffset, 32, 1, 0, *(int*)(packet + 12) - *(int*)(last + 12), stream);
            for (int i = 16; i < RecordBytes - 1; i += 4)
                IntegerModel.Encode(memory + DirectionOffset, 32, 3, (i - 16) / 4, *(int*)(packet + i) - *(int*)(last + i),
                    stream);
            for (int i = 0; i < RecordBytes - 1; i++)
                last[i] = packet[i];
        }
    }
}
