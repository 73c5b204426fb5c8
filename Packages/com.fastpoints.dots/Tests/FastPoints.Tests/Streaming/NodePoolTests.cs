using System.Collections.Generic;
using FastPoints.Streaming;
using NUnit.Framework;

namespace FastPoints.Tests.Streaming
{
    public class NodePoolTests
    {
        const int BankBytes = 64 << 10;

        [Test]
        public void TryAllocate_ToTheLimit_UsesWholeBanks()
        {
            using var pool = new MemoryNodePool(5 * BankBytes + 1000, BankBytes);
            var ranges = new List<PoolRange>();
            while (pool.TryAllocate(20_000, out var range))
            {
                ranges.Add(range);
                Assert.That(pool.AllocatedBytes, Is.LessThanOrEqualTo(pool.LimitBytes));
            }
            Assert.That(ranges.Count, Is.EqualTo(15));
            Assert.That(pool.UsedBytes, Is.EqualTo(15 * 20 * NodePool.PageBytes));
            Assert.That(pool.TryAllocate(BankBytes + 1, out _), Is.False);
            foreach (var range in ranges)
                pool.Release(range);
            Assert.That(pool.FindProblem(), Is.Null);
            Assert.That(pool.UsedBytes, Is.Zero);
        }

        [Test]
        public void TryShorten_LongerRangeThanNeeded_FreesTheRest()
        {
            using var pool = new MemoryNodePool(BankBytes, BankBytes);
            pool.TryAllocate(BankBytes, out var range);
            Assert.That(pool.TryAllocate(1, out _), Is.False);
            Assert.That(pool.TryShorten(ref range, BankBytes + 1), Is.False);
            Assert.That(pool.TryShorten(ref range, 5000), Is.True);
            Assert.That((range.PageCount, pool.UsedBytes), Is.EqualTo((5, 5L * NodePool.PageBytes)));
            Assert.That(pool.TryAllocate(BankBytes - 5 * NodePool.PageBytes, out var rest), Is.True);
            Assert.That(pool.FindProblem(), Is.Null);
            pool.Release(range);
            pool.Release(rest);
            Assert.That((pool.UsedBytes, pool.FindProblem()), Is.EqualTo((0L, (string)null)));
        }

        [Test]
        public void LimitBytes_Lowered_FreesBanksAsTheyBecomeEmpty()
        {
            using var pool = new MemoryNodePool(4 * BankBytes, BankBytes);
            var ranges = new List<PoolRange>();
            while (pool.TryAllocate(BankBytes / 2, out var range))
                ranges.Add(range);
            pool.LimitBytes = 2 * BankBytes;
            Assert.That(pool.TryAllocate(1, out _), Is.False);
            for (int i = ranges.Count - 1; i >= 4; i--)
                pool.Release(ranges[i]);
            Assert.That(pool.AllocatedBytes, Is.EqualTo(2 * BankBytes));
            pool.LimitBytes = 3 * BankBytes;
            Assert.That(pool.TryAllocate(1, out var more), Is.True);
            pool.LimitBytes = 0;
            pool.Release(more);
            for (int i = 0; i < 4; i++)
                pool.Release(ranges[i]);
            Assert.That(pool.AllocatedBytes, Is.Zero);
            Assert.That(pool.FindProblem(), Is.Null);
        }
    }
}
