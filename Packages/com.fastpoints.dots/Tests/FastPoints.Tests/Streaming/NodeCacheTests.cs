using System.Collections.Generic;
using FastPoints.Streaming;
using NUnit.Framework;

namespace FastPoints.Tests.Streaming
{
    public class NodeCacheTests
    {
        [Test]
        public void NextToEvict_AfterAnyUse_IsTheLeastRecentlyUsed()
        {
            var random = new Unity.Mathematics.Random(9);
            var order = new List<int>();
            using var cache = new NodeCache();
            for (uint turn = 1; turn < 2000; turn++)
            {
                int what = random.NextInt(4);
                if (order.Count == 0 || what == 0)
                {
                    order.Add(cache.Add(0, 0, (int)turn, default));
                }
                else
                {
                    int slot = order[random.NextInt(order.Count)];
                    order.Remove(slot);
                    if (what == 1)
                    {
                        int version = cache[slot].Version;
                        cache.Remove(slot);
                        Assert.That(cache.IsValid(slot, version), Is.False);
                    }
                    else
                    {
                        cache.Touch(slot, turn, 0);
                        order.Add(slot);
                    }
                }
                Assert.That(cache.Count, Is.EqualTo(order.Count));
                Assert.That(cache.NextToEvict, Is.EqualTo(order.Count == 0 ? NodeCache.None : order[0]));
            }
        }
    }
}
