using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Laz
{
    /// <summary>The range coder under all of LAZ (Said 2004, "Introduction to arithmetic coding"; Isenburg 2013, "LASzip"):
    /// 32-bit value and length, renormalized by whole bytes, most significant first. HPC#.</summary>
    /// <remarks>Value, length and pointer go as three locals through inlined methods: as one struct passed by reference .NET's
    /// compiler kept them on the stack, a third slower. Value stays below length, whatever the input, so that every table lookup
    /// stays inside its table. Nothing here checks the input's end: callers do so once a point, and their input is followed by
    /// <see cref="PaddingBytes"/> readable bytes.</remarks>
    internal static unsafe class RangeCoder
    {
        /// <summary>Readable bytes behind every input: more than the items of one point can take between two checks.</summary>
        public const int PaddingBytes = 256;
        public const uint MinLength = 1u << 24; // Bytes are taken until the length is this or more.

        /// <summary>Starts a stream: its first four bytes are the value. No encoder writes four bytes of ones, which would be
        /// the whole length: they become the largest value below it.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void StartDecoding(out uint value, out uint length, ref byte* next)
        {
            value = BigEndian(next);
            next += 4;
            length = uint.MaxValue;
            if (value == length)
                value--;
        }

        /// <summary>Bits that are not modelled, at most 19 of them.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint FewBits(int bits, ref uint value, ref uint length, ref byte* next)
        {
            length >>= bits;
            uint symbol = value / length;
            value -= length * symbol;
            Renormalize(ref value, ref length, ref next);
            return symbol;
        }

        /// <summary>1 to 32 bits that are not modelled; the lower 16 come first where there are more than 19.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint Bits(int bits, ref uint value, ref uint length, ref byte* next)
        {
            uint low = 0;
            int shift = 0;
            if (bits > 19)
            {
                low = FewBits(16, ref value, ref length, ref next);
                shift = 16;
            }
            return FewBits(bits - shift, ref value, ref length, ref next) << shift | low;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint UInt32(ref uint value, ref uint length, ref byte* next)
        {
            uint low = FewBits(16, ref value, ref length, ref next);
            return FewBits(16, ref value, ref length, ref next) << 16 | low;
        }

        /// <summary>Takes as many bytes (0 to 3) as bring the length back to 25 bits or more. Without a branch on whether there
        /// are any, which is about as good as random: 7 to 11 % less time a point.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Renormalize(ref uint value, ref uint length, ref byte* next)
        {
            int bits = math.lzcnt(length) & 24;
            value = (uint)(((ulong)value << 32 | BigEndian(next)) << bits >> 32);
            length <<= bits;
            next += bits >> 3;
        }

        /// <summary>An encoder's step: takes the part of the interval that begins at <paramref name="from"/>, and writes as many
        /// bytes as bring the length back. Four bytes behind <paramref name="next"/> must be writable.</summary>
        /// <param name="low">Where the interval begins: an encoder has it in place of the value.</param>
        /// <param name="size">Of the part.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Narrow(uint from, uint size, ref uint low, ref uint length, ref byte* next)
        {
            uint before = low;
            low += from;
            if (low < before)
                Carry(next);
            int bits = math.lzcnt(size) & 24;
            *(uint*)next = Reversed(low);
            next += bits >> 3;
            low <<= bits;
            length = size << bits;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void PutBits(int bits, uint symbol, ref uint low, ref uint length, ref byte* next)
        {
            if (bits > 19)
            {
                Narrow((symbol & 0xFFFF) * (length >> 16), length >> 16, ref low, ref length, ref next);
                symbol >>= 16;
                bits -= 16;
            }
            Narrow(symbol * (length >> bits), length >> bits, ref low, ref length, ref next);
        }

        public static void PutUInt32(uint symbol, ref uint low, ref uint length, ref byte* next)
        {
            PutBits(16, symbol & 0xFFFF, ref low, ref length, ref next);
            PutBits(16, symbol >> 16, ref low, ref length, ref next);
        }

        /// <summary>Ends a stream with as many bytes as a decoder reads.</summary>
        public static void EndEncoding(uint low, uint length, ref byte* next)
        {
            bool isLong = length > 2 * MinLength;
            Narrow(isLong ? MinLength : MinLength >> 1, isLong ? MinLength >> 1 : MinLength >> 9, ref low, ref length, ref next);
            for (int i = 0; i < (isLong ? 3 : 2); i++)
                *next++ = 0;
        }

        /// <summary>An interval that begins beyond the largest number adds one to the bytes that are written.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        static void Carry(byte* next)
        {
            for (next--; *next == 255; next--)
                *next = 0;
            (*next)++;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static uint BigEndian(byte* bytes) => Reversed(*(uint*)bytes);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static uint Reversed(uint word) => math.ror(word & 0x00FF00FF, 8) | math.rol(word & 0xFF00FF00, 8);
    }
}
