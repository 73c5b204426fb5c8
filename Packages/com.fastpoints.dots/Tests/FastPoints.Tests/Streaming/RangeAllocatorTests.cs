using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Streaming
{
    public class RangeAllocatorTests
    {
        [TestCase(1, 1u), TestCase(64, 2u), TestCase(1000, 3u), TestCase(4096, 4u)]
        public void AllocateAndFree_AtRandom_NeverOverlapAndLoseNothing(int capacity, uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var owner = new int[capacity];
            var ranges = new List<(int First, int Count)>();
            using var heap = new RangeAllocator(capacity, Allocator.Persistent);
            var books = heap;
            int used = 0;
            for (int turn = 1; turn <= 3000; turn++)
            {
                if (ranges.Count == 0 || random.NextInt(5) < 3)
                {
                    int count = 1 + random.NextInt(Math.Max(1, capacity / (random.NextBool() ? 50 : 5)));
                    int first = books.Allocate(count);
                    if (first >= 0)
                    {
                        for (int i = first; i < first + count; i++)
                        {
                            Assert.That(owner[i], Is.Zero);
                            owner[i] = turn;
                        }
                        ranges.Add((first, count));
                        used += count;
                    }
                    else
                    {
                        Assert.That(LongestFree(owner), Is.LessThan(count));
                    }
                }
                else
                {
                    int at = random.NextInt(ranges.Count);
                    if (random.NextInt(3) == 0)
                    {
                        var (first, count) = ranges[at];
                        int kept = 1 + random.NextInt(count);
                        books.Shorten(first, kept);
                        Array.Clear(owner, first + kept, count - kept);
                        used -= count - kept;
                        ranges[at] = (first, kept);
                        Assert.That(books.UsedLength, Is.EqualTo(used));
                        continue;
                    }
                    books.Free(ranges[at].First);
                    Array.Clear(owner, ranges[at].First, ranges[at].Count);
                    used -= ranges[at].Count;
                    ranges.RemoveAt(at);
                }
                Assert.That(books.UsedLength, Is.EqualTo(used));
                if (turn % 50 == 0)
                    Assert.That(books.FindProblem(), Is.Null);
            }
            foreach (var range in ranges)
                books.Free(range.First);
            Assert.That(books.FindProblem(), Is.Null);
            Assert.That(books.Allocate(capacity), Is.Zero);
        }

        static int LongestFree(int[] owner)
        {
            int longest = 0, length = 0;
            foreach (int slot in owner)
            {
                length = slot == 0 ? length + 1 : 0;
                longest = Math.Max(longest, length);
            }
            return longest;
        }

        [Test]
        public void Free_InvalidRange_Throws()
        {
            using var heap = new RangeAllocator(100, Allocator.Persistent);
            var books = heap;
            int range = books.Allocate(10);
            Assert.That(() => books.Free(range + 3), Throws.ArgumentException);
            Assert.That(() => books.Free(50), Throws.ArgumentException);
            Assert.That(() => books.Free(-1), Throws.ArgumentException);
            books.Free(range);
            Assert.That(() => books.Free(range), Throws.ArgumentException);
        }

        [Test]
        public void Allocate_MoreThanAvailable_Fails()
        {
            using var heap = new RangeAllocator(100, Allocator.Persistent);
            var books = heap;
            Assert.That(books.Allocate(101), Is.EqualTo(-1));
            Assert.That(books.Allocate(0), Is.EqualTo(-1));
            Assert.That(books.Allocate(60), Is.Not.EqualTo(-1));
            Assert.That(books.Allocate(60), Is.EqualTo(-1));
        }
    }
}
