using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Laz
{
    /// <summary>An integer coded as its difference from a prediction (Isenburg 2013, section 5): first the number k of bits of
    /// the difference, in one of several contexts, then its rank among the numbers of that many bits, the upper eight bits of it
    /// modelled, the others raw. HPC#.</summary>
    /// <remarks><code>
    /// byte   0  uint  bit k set: the corrector of k has been made (a chunk uses few of them; 1.5 KB each)
    ///        8  BitModel of k = 0
    ///       64  SymbolModel[contexts] of k, bits + 1 symbols
    ///           SymbolModel[bits] correctors of k = 1, 2, ..., with 2^min(k, 8) symbols
    /// </code>
    /// Decoded differences are added with wrap-around: with less than 32 bits the caller keeps the lower ones, which is the same
    /// as LASzip's folding into the range.
    /// </remarks>
    internal static unsafe class IntegerModel
    {
        const int BitModelOffset = 8;
        const int ContextsOffset = 64;
        const int ModelledBits = 8;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int BytesOf(int bits, int contexts) =>
            ContextsOffset + contexts * SymbolModel.BytesOf(bits + 1) + (bits < 32 ? bits : 31) * SymbolModel.Bytes256;

        public static void Initialize(byte* model, int bits, int contexts)
        {
            *(uint*)model = 0;
            ((BitModel*)(model + BitModelOffset))->Initialize();
            int stride = SymbolModel.BytesOf(bits + 1);
            for (int i = 0; i < contexts; i++)
                SymbolModel.Initialize(model + ContextsOffset + i * stride, bits + 1);
        }

        /// <summary>The difference from the prediction, and <paramref name="k"/>, which other models take for a
        /// context.</summary>
        /// <param name="bits">The same as at initialisation, like <paramref name="contexts"/>; pass constants for speed.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int Decode(byte* model, int bits, int contexts, int context, out int k,
            ref uint value, ref uint length, ref byte* next)
        {
            byte* kModel = model + ContextsOffset + context * SymbolModel.BytesOf(bits + 1);
            k = (int)SymbolModel.Decode(kModel, bits + 1, ref value, ref length, ref next);
            if (k == 0)
                return (int)BitModel.Decode((BitModel*)(model + BitModelOffset), ref value, ref length, ref next);
            if (bits == 32 && k == 32)
                return int.MinValue;

            byte* corrector = model + ContextsOffset + contexts * SymbolModel.BytesOf(bits + 1) + (k - 1) * SymbolModel.Bytes256;
            if ((*(uint*)model >> k & 1) == 0)
                InitializeCorrector(model, corrector, k);
            int c = (int)SymbolModel.Decode(corrector, 256, ref value, ref length, ref next);
            if (k > ModelledBits)
            {
                int raw = k - ModelledBits;
                c = c << raw | (int)RangeCoder.Bits(raw, ref value, ref length, ref next);
            }
            // The lower half of the numbers of k bits stands for -(2^k - 1) to -2^(k-1), the upper one for 2^(k-1) + 1 to 2^k.
            int isLower = (int)(((long)c - (1L << (k - 1))) >> 63);
            return c + 1 - (isLower & 1 << k);
        }

        // Without k, for callers that do not need it.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int Decode(byte* model, int bits, int contexts, int context,
            ref uint value, ref uint length, ref byte* next) =>
            Decode(model, bits, contexts, context, out _, ref value, ref length, ref next);

        // Not inlined: for values that seldom change.
        [MethodImpl(MethodImplOptions.NoInlining)]
        public static int Decode(byte* model, int bits, int contexts, int context, RangeStream* stream)
        {
            uint value = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            int difference = Decode(model, bits, contexts, context, out _, ref value, ref length, ref next);
            stream->Save(value, length, next);
            return difference;
        }

        /// <param name="difference">With fewer than 32 bits, only the lower ones count.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Encode(byte* model, int bits, int contexts, int context, int difference, out int k,
            ref uint low, ref uint length, ref byte* next)
        {
            difference = difference << 32 - bits >> 32 - bits;
            // The sign is as good as random: no branch asks for it.
            long less = difference - 1L, isLower = less >> 63;
            k = 32 - math.lzcnt((uint)(less ^ isLower));
            byte* kModel = model + ContextsOffset + context * SymbolModel.BytesOf(bits + 1);
            SymbolModel.Encode(kModel, bits + 1, (uint)k, ref low, ref length, ref next);
            if (k == 0)
            {
                BitModel.Encode((BitModel*)(model + BitModelOffset), (uint)difference, ref low, ref length, ref next);
                return;
            }
            if (k == 32)
                return;
            byte* corrector = model + ContextsOffset + contexts * SymbolModel.BytesOf(bits + 1) + (k - 1) * SymbolModel.Bytes256;
            if ((*(uint*)model >> k & 1) == 0)
                InitializeCorrector(model, corrector, k);
            uint rank = (uint)less + ((uint)isLower & 1u << k);
            if (k <= ModelledBits)
            {
                SymbolModel.Encode(corrector, 256, rank, ref low, ref length, ref next);
                return;
            }
            int raw = k - ModelledBits;
            SymbolModel.Encode(corrector, 256, rank >> raw, ref low, ref length, ref next);
            RangeCoder.PutBits(raw, rank & ((1u << raw) - 1), ref low, ref length, ref next);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Encode(byte* model, int bits, int contexts, int context, int difference, RangeStream* stream)
        {
            uint low = stream->Value, length = stream->Length;
            byte* next = stream->Next;
            Encode(model, bits, contexts, context, difference, out _, ref low, ref length, ref next);
            stream->Save(low, length, next);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        static void InitializeCorrector(byte* model, byte* corrector, int k)
        {
            *(uint*)model |= 1u << k;
            SymbolModel.Initialize((SymbolModel*)corrector, 1 << (k < ModelledBits ? k : ModelledBits), 256);
        }
    }
}
