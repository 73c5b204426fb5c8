using System;
using System.Collections.Generic;
using FastPoints.Laz;
using NUnit.Framework;

namespace FastPoints.Tests.Laz
{
    public class LazChunkListTests
    {
        static void Compare(LazChunkList list, List<LazChunk> wanted)
        {
            Assert.That(list.Count, Is.EqualTo(wanted.Count));
            long points = 0, maxBytes = 0;
            for (int i = 0; i < wanted.Count; i++)
            {
                Assert.That(list[i], Is.EqualTo(wanted[i]), "chunk " + i);
                Assert.That(list.PointsOf(i), Is.EqualTo(wanted[i].Points));
                if (list.AreContiguous)
                    Assert.That(list.FirstPointOf(i), Is.EqualTo(points));
                points += wanted[i].Points;
                maxBytes = Math.Max(maxBytes, wanted[i].Bytes);
                Assert.That(list.MaxPoints, Is.GreaterThanOrEqualTo(wanted[i].Points));
            }
            Assert.That(list.PointCount, Is.EqualTo(points));
            Assert.That(list.MaxBytes, Is.EqualTo(maxBytes));
        }

        [TestCase(0, 0, -1), TestCase(1, 1, -1), TestCase(65, 65, -1), TestCase(65, 64, -1), TestCase(1000, 999, -1)]
        [TestCase(1000, 500, -1), TestCase(1000, 128, -1), TestCase(70_000, 0, -1), TestCase(300, 300, 128)]
        [TestCase(300, 10, 200)]
        public void Add_AnyChunks_ReadsBackTheSame(int count, int equal, int gapAt)
        {
            var random = new Random(count + equal);
            var list = new LazChunkList();
            var wanted = new List<LazChunk>();
            long offset = 5_000_000_000;
            for (int i = 0; i < count; i++)
            {
                offset += i == gapAt ? 7 : 0;
                long points = i < equal ? 50 : random.Next(1, 99);
                var chunk = new LazChunk { Offset = offset, Bytes = random.Next(20, 90_000), Points = points };
                list.Add(chunk);
                wanted.Add(chunk);
                offset += chunk.Bytes;
            }
            Assert.That(list.AreContiguous, Is.EqualTo(gapAt < 0));
            Compare(list, wanted);
            list.Clear();
            Compare(list, new List<LazChunk>());
            Assert.That(list.AreContiguous, Is.True);
        }

        [Test]
        public void Add_MoreBytesThan32BitsHold_KeepsThem()
        {
            var list = new LazChunkList();
            var wanted = new List<LazChunk> { new LazChunk { Offset = 10, Bytes = 40, Points = 2 },
                new LazChunk { Offset = 50, Bytes = 6_000_000_000, Points = 9_000_000_000 } };
            foreach (var chunk in wanted)
                list.Add(chunk);
            Compare(list, wanted);
        }

        [Test]
        public void SetPoints_OfOneChunk_LeavesTheOthers()
        {
            var list = new LazChunkList();
            var wanted = new List<LazChunk>();
            for (int i = 0; i < 130; i++)
                wanted.Add(new LazChunk { Offset = 100 * i, Bytes = 100, Points = 40 });
            foreach (var chunk in wanted)
                list.Add(chunk);
            list.SetPoints(70, 3);
            wanted[70] = new LazChunk { Offset = 7000, Bytes = 100, Points = 3 };
            Compare(list, wanted);
        }

        [Test]
        public void Item_AfterTheLast_Throws()
        {
            var list = new LazChunkList();
            list.Add(new LazChunk { Offset = 1, Bytes = 30, Points = 1 });
            Assert.That(() => list[1], Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => list.PointsOf(-1), Throws.TypeOf<ArgumentOutOfRangeException>());
        }
    }
}
