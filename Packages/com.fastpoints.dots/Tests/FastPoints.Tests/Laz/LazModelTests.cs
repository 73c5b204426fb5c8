using System;
using System.Collections.Generic;
using FastPoints.Laz;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Tests.Laz
{
    public unsafe class LazModelTests
    {
        [TestCase(4, SymbolModel.Bytes4), TestCase(6, SymbolModel.Bytes6), TestCase(9, SymbolModel.Bytes9)]
        [TestCase(13, SymbolModel.Bytes13), TestCase(16, SymbolModel.Bytes16), TestCase(17, SymbolModel.Bytes17)]
        [TestCase(33, SymbolModel.Bytes33), TestCase(64, SymbolModel.Bytes64), TestCase(128, SymbolModel.Bytes128)]
        [TestCase(256, SymbolModel.Bytes256), TestCase(512, SymbolModel.Bytes512)]
        [TestCase(516, SymbolModel.Bytes516)]
        public void BytesOf_EachCapacity_IsItsConstant(int capacity, int bytes) =>
            Assert.That(SymbolModel.BytesOf(capacity), Is.EqualTo(bytes));

        [TestCase(2, 2), TestCase(3, 4), TestCase(5, 6), TestCase(16, 16), TestCase(33, 33), TestCase(128, 128)]
        [TestCase(64, 256), TestCase(256, 256), TestCase(515, 516)]
        public void SymbolModel_EncodedSymbols_RoundTrip(int symbols, int capacity)
        {
            var random = new Random(symbols);
            var wanted = new int[20000];
            for (int i = 0; i < wanted.Length; i++)
                wanted[i] = Math.Min(random.Next(symbols), random.Next(symbols));
            var stream = new byte[4 * wanted.Length];
            using (var state = new NativeArray<byte>(SymbolModel.BytesOf(capacity), Allocator.Persistent))
                fixed (byte* input = stream)
                {
                    byte* place = (byte*)state.GetUnsafePtr(), next = input;
                    SymbolModel.Initialize((SymbolModel*)place, symbols, capacity);
                    uint low = 0, size = uint.MaxValue;
                    foreach (int symbol in wanted)
                        SymbolModel.Encode(place, capacity, (uint)symbol, ref low, ref size, ref next);
                    RangeCoder.EndEncoding(low, size, ref next);
                    byte* end = next;
                    SymbolModel.Initialize((SymbolModel*)place, symbols, capacity);
                    next = input;
                    RangeCoder.StartDecoding(out uint value, out uint length, ref next);
                    for (int i = 0; i < wanted.Length; i++)
                        Assert.That(SymbolModel.Decode(place, capacity, ref value, ref length, ref next), Is.EqualTo(wanted[i]));
                    Assert.That(next - input, Is.EqualTo(end - input), "a decoder takes all that the encoder wrote");
                }
        }

        [TestCase(8), TestCase(16), TestCase(32)]
        public void IntegerModel_EncodedIntegers_RoundTrip(int bits)
        {
            const int Contexts = 3;
            var random = new Random(bits);
            long mask = (1L << bits) - 1;
            var predictions = new int[30000];
            var wanted = new int[predictions.Length];
            for (int i = 0; i < wanted.Length; i++)
            {
                predictions[i] = (int)(random.Next() & mask);
                int spread = random.Next(1, Math.Min(bits, 30) + 1);
                int value = unchecked(predictions[i] + random.Next(-(1 << spread - 1), 1 << spread - 1));
                wanted[i] = i % 1000 == 0 ? unchecked(predictions[i] + int.MinValue) : (int)(value & mask);
                if (bits < 32)
                    wanted[i] &= (int)mask;
            }
            var stream = new byte[8 * wanted.Length];
            using (var state = new NativeArray<byte>(IntegerModel.BytesOf(bits, Contexts), Allocator.Persistent))
                fixed (byte* input = stream)
                {
                    byte* place = (byte*)state.GetUnsafePtr(), next = input;
                    IntegerModel.Initialize(place, bits, Contexts);
                    uint low = 0, size = uint.MaxValue;
                    for (int i = 0; i < wanted.Length; i++)
                        IntegerModel.Encode(place, bits, Contexts, i % Contexts, unchecked(wanted[i] - predictions[i]), out _,
                            ref low, ref size, ref next);
                    RangeCoder.EndEncoding(low, size, ref next);
                    byte* end = next;
                    IntegerModel.Initialize(place, bits, Contexts);
                    next = input;
                    RangeCoder.StartDecoding(out uint value, out uint length, ref next);
                    for (int i = 0; i < wanted.Length; i++)
                    {
                        int difference = IntegerModel.Decode(place, bits, Contexts, i % Contexts, ref value, ref length,
                            ref next);
                        Assert.That((int)(unchecked(predictions[i] + difference) & mask), Is.EqualTo(wanted[i]), "number " + i);
                    }
                    Assert.That(next - input, Is.EqualTo(end - input));
                }
        }

        [TestCase(1), TestCase(8), TestCase(19), TestCase(20), TestCase(32)]
        public void Bits_EncodedBits_RoundTrip(int bits)
        {
            var random = new Random(bits);
            var wanted = new uint[1000];
            fixed (byte* input = new byte[8 * wanted.Length])
            {
                byte* next = input;
                uint low = 0, size = uint.MaxValue;
                for (int i = 0; i < wanted.Length; i++)
                {
                    wanted[i] = (uint)(((long)random.Next() << 16 ^ random.Next()) & ((1L << bits) - 1));
                    RangeCoder.PutBits(bits, wanted[i], ref low, ref size, ref next);
                }
                RangeCoder.EndEncoding(low, size, ref next);
                next = input;
                RangeCoder.StartDecoding(out uint value, out uint length, ref next);
                for (int i = 0; i < wanted.Length; i++)
                    Assert.That(RangeCoder.Bits(bits, ref value, ref length, ref next), Is.EqualTo(wanted[i]));
            }
        }

        [Test]
        public void SymbolModel_Noise_StaysInsideItsTables()
        {
            // Whatever comes, value < length: the worst is a start of nothing but ones.
            var random = new Random(7);
            var noise = new byte[4096 + RangeCoder.PaddingBytes];
            foreach (int symbols in new[] { 2, 16, 33, 256, 516 })
            {
                random.NextBytes(noise);
                for (int i = 0; i < 64; i++)
                    noise[i] = 255;
                using (var state = new NativeArray<byte>(SymbolModel.BytesOf(symbols), Allocator.Persistent))
                    fixed (byte* input = noise)
                    {
                        byte* place = (byte*)state.GetUnsafePtr();
                        SymbolModel.Initialize(place, symbols);
                        byte* next = input;
                        RangeCoder.StartDecoding(out uint value, out uint length, ref next);
                        bool isValid = true;
                        for (int i = 0; i < 100000 && next < input + 4000; i++)
                            isValid &= SymbolModel.Decode(place, symbols, ref value, ref length, ref next) < symbols
                                && value < length && length >= 1u << 24;
                        Assert.That(isValid, Is.True, symbols + " symbols");
                    }
            }
        }

        [Test]
        public void Median5_AnyValues_MatchesSorting()
        {
            var random = new Random(3);
            int* median = stackalloc int[Median5.Ints];
            Median5.Initialize(median);
            var plain = new MedianOfFive();
            for (int i = 0; i < 20000; i++)
            {
                int value = random.Next(10) == 0 ? int.MinValue + random.Next(3)
                    : random.Next(10) == 0 ? int.MaxValue - random.Next(3) : random.Next(-5, 6);
                Median5.Add(median, value);
                plain.Add(value);
                Assert.That(Median5.Get(median), Is.EqualTo(plain.Value), "value " + i);
            }
        }

        /// <summary>The hashes are those of an encoder that was written after the format's description alone and agreed with
        /// LASzip's files: of 9,000 points without and with three extra bytes.</summary>
        [TestCase(0, 2, 0x8230E8A3A246F42Cul, 0x8E9311E2B728944Ful)]
        [TestCase(1, 2, 0x2EC69652952B46E9ul, 0xE0AD99D615B4CBC2ul)]
        [TestCase(2, 2, 0x060A5A42386C2784ul, 0x6BE31B0ADF2D1602ul)]
        [TestCase(3, 2, 0x761AAA29A0CB31B9ul, 0xE857A367E0A691EEul)]
        [TestCase(4, 2, 0x9AAA78D79E402623ul, 0x71E36C90C1500DDBul)]
        [TestCase(5, 2, 0x26C60BA0ED16628Ful, 0x1F8857E94F3B18E5ul)]
        [TestCase(6, 3, 0x15410D602940EA82ul, 0x0B11D59C3555FBA5ul)]
        [TestCase(6, 4, 0x15410D602940EA82ul, 0x903F2B8AC7B63A7Bul)]
        [TestCase(7, 3, 0xF8F26F485FB11E27ul, 0x3A1E89D9A8453473ul)]
        [TestCase(7, 4, 0xFE5A3C78E1367CC3ul, 0xBDF26BBB855017DDul)]
        [TestCase(8, 3, 0xF475E113A74C8BB1ul, 0xE4F64212E3077490ul)]
        [TestCase(8, 4, 0x0F75400F586F4BFEul, 0xEBFE73FA566FB811ul)]
        [TestCase(9, 3, 0x0DC4242B4AB052CEul, 0x7B3A0AD69BF28817ul)]
        [TestCase(9, 4, 0x620B0C089B57D42Aul, 0x584D6A5D6339A4D6ul)]
        [TestCase(10, 3, 0xA936644C9D8EFFF9ul, 0x0318C1D5CB69A7E6ul)]
        [TestCase(10, 4, 0xC9E8F095F3680323ul, 0xCFF2546BD913890Eul)]
        public void Chunk_OfEachFormatAndVersion_HasTheRecordedBytes(int format, int version, ulong plain, ulong withExtra)
        {
            foreach (int extra in new[] { 0, 3 })
            {
                var records = LazRecords.Make(format, extra, 9000, 7 + format);
                var chunk = LazEncoder.Chunk(LazItems.Of(format, version, extra), records);
                fixed (byte* bytes = chunk)
                    Assert.That(ContentHash.Of(bytes, chunk.Length), Is.EqualTo(extra == 0 ? plain : withExtra));
            }
        }
    }

    /// <summary>What <see cref="FastPoints.Laz.Median5"/> computes, in plain steps: sorted values, of which the largest or the
    /// smallest leaves for the new one.</summary>
    sealed class MedianOfFive
    {
        readonly List<int> m_values = new List<int> { 0, 0, 0, 0, 0 };
        bool m_dropsLargest = true;

        public int Value => m_values[2];

        public void Add(int value)
        {
            int middle = Value;
            m_values.RemoveAt(m_dropsLargest ? 4 : 0);
            m_values.Add(value);
            m_values.Sort();
            m_dropsLargest = m_dropsLargest ? value < middle : value <= middle;
        }
    }
}
