using System;
using System.Linq;
using FastPoints.Nodes;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Tests.Nodes
{
    public sealed unsafe class RecordBlockTests
    {
        const int Words = 5, StrideBytes = Words * sizeof(uint);

        static readonly uint[] s_masks =
        {
            0, 1, 1u << 31, uint.MaxValue, 0x000fffff, 0x03000f01, 0x55555555, 0xaaaaaaaa, 0xff00ff00,
        };

        RecordPagePool m_pool;
        RecordPages.Page* m_page;

        [SetUp]
        public void TakePage()
        {
            m_pool = new RecordPagePool(StrideBytes, 1);
            m_page = m_pool.Take();
        }

        [TearDown]
        public void FreePages() => m_pool.FreeAll();

        // Words that differ in some bits, or count upwards by small steps.
        static uint[] Records(int count, int seed)
        {
            var random = new System.Random(seed);
            var records = new uint[count * Words];
            for (int w = 0; w < Words; w++)
            {
                uint mask = s_masks[random.Next(s_masks.Length)], common = (uint)random.Next() & ~mask;
                // Colours of 8 bits, in the lower, the upper or both halves.
                uint repeated = random.Next(3) == 0 ? 0 : new uint[] { 0x00ff, 0x00ff0000, 0x00ff00ff }[random.Next(3)];
                bool isCounting = random.Next(3) == 0;
                for (int i = 0; i < count; i++)
                {
                    uint value = isCounting ? common + (uint)(i * 3 + random.Next(5))
                        : common | mask & (uint)(random.Next() * 2L + random.Next(2));
                    records[i * Words + w] = value & ~(repeated << 8) | (value & repeated) << 8;
                }
            }
            return records;
        }

        void Pack(uint[] records)
        {
            m_page->Count = records.Length / Words;
            fixed (uint* from = records)
                UnsafeUtility.MemCpy(RecordPages.RecordsOf(m_page), from, records.Length * sizeof(uint));
            using var scratch = new NativeArray<uint>(Math.Max(1, records.Length), Allocator.Persistent);
            RecordBlock.Pack(m_page, StrideBytes, (uint*)scratch.GetUnsafePtr());
        }

        bool Unpack(int first, int count, out uint[] records)
        {
            records = Enumerable.Repeat(77u, count * Words).ToArray();
            fixed (uint* to = records)
                return RecordBlock.Unpack(new UnpackRequest
                {
                    Block = RecordBlock.Of(m_page),
                    BlockBytes = m_page->BlockBytes,
                    BlockRecords = m_page->Count,
                    First = first,
                    Count = count,
                    Records = (byte*)to,
                }, StrideBytes);
        }

        [Test]
        public void Unpack_AnyPartOfAnyRecords_IsWhatWasPacked([NUnit.Framework.Range(0, 39)] int seed)
        {
            var random = new System.Random(seed);
            int count = seed % 4 == 0 ? RecordPages.RecordsPerPage : 1 + random.Next(200);
            var records = Records(count, seed);
            Pack(records);
            Assert.That(m_page->BlockBytes, Is.LessThanOrEqualTo(RecordBlock.HeaderBytes + count * StrideBytes));
            for (int part = 0; part < 20; part++)
            {
                int first = part == 0 ? 0 : random.Next(count), wanted = part == 0 ? count : random.Next(count - first + 1);
                Assert.That(Unpack(first, wanted, out var found), Is.True);
                Assert.That(found, Is.EqualTo(records.Skip(first * Words).Take(wanted * Words)));
            }
        }

        [TestCase(1), TestCase(PackRecordsJob.PagesPerRun), TestCase(3 * PackRecordsJob.PagesPerRun + 5)]
        public void Schedule_AnyNumberOfPages_PacksAllAndLeavesTheListWhole(int count)
        {
            var pages = default(RecordPages);
            for (int p = 0; p < count; p++)
            {
                var page = m_pool.Take();
                page->Count = 1 + p;
                UnsafeUtility.MemClear(RecordPages.RecordsOf(page), page->Count * StrideBytes);
                pages.AddPage(page);
            }
            using var slices = new SliceTimes(Allocator.Persistent);
            PackRecordsJob.Schedule(new PackRecordsJob { Pages = pages, StrideBytes = StrideBytes, SliceTimes = slices }, default)
                .Complete();
            int found = 0;
            for (var page = pages.First; page != null; page = page->Next)
                Assert.That(((uint*)RecordBlock.Of(page))[0], Is.EqualTo(++found));
            Assert.That(found, Is.EqualTo(count));
        }

        [Test]
        public void Pack_EqualRecords_TakesNoBitsOfThem()
        {
            Pack(Enumerable.Repeat(new uint[] { 1, uint.MaxValue, 0, 5, 1u << 31 }, 2048).SelectMany(r => r).ToArray());
            Assert.That(m_page->BlockBytes, Is.EqualTo(RecordBlock.HeaderBytes + Words * 12));
        }

        [Test]
        public void Pack_ColoursOf8Bits_TakesHalfOfTheirBits()
        {
            var random = new System.Random(7);
            uint Colours() => (uint)(random.Next(256) * 257 | random.Next(256) * 257 << 16);
            Pack(Enumerable.Range(0, 2048).SelectMany(i => new[] { 1u, 2u, 3u, 4u, Colours() }).ToArray());
            Assert.That(m_page->BlockBytes, Is.EqualTo(RecordBlock.HeaderBytes + Words * 12 + 2048 * 2));
        }

        [Test]
        public void Unpack_DamagedBlock_IsRefusedOrHasAsManyRecords([Values] bool isShorter)
        {
            Pack(Records(500, 4));
            int bytes = m_page->BlockBytes;
            var whole = new ReadOnlySpan<byte>(RecordBlock.Of(m_page), bytes).ToArray();
            var random = new System.Random(3);
            for (int i = 0; i < 2000; i++)
            {
                byte* block = RecordBlock.Of(m_page);
                fixed (byte* from = whole)
                    UnsafeUtility.MemCpy(block, from, bytes);
                // The heads of the block and of its words more often than others.
                block[random.Next(i % 2 == 0 ? 20 : bytes)] ^= (byte)(1 << random.Next(8));
                m_page->BlockBytes = isShorter ? random.Next(2, bytes / 4) * 4 : bytes;
                bool isWhole = Unpack(0, 500, out var found);
                Assert.That(isWhole && isShorter, Is.False);
                Assert.That(found.Length, Is.EqualTo(500 * Words));
            }
        }
    }
}
