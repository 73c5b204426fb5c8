using System.Collections.Generic;
using System.Linq;
using FastPoints.Files;
using FastPoints.Points;
using FastPoints.Preview;
using FastPoints.Tests.Support;
using NUnit.Framework;

namespace FastPoints.Tests.Preview
{
    public class DepthPlanTests
    {
        static MemoryPointReader Blocks(int count, int pointsPerBlock) =>
            new MemoryPointReader(TestBatches.New(count, TestBatches.Xyz(AttributeType.Int32)), pointsPerBlock, false);

        [TestCase(1000, 100, true)]
        [TestCase(1000, 100, false)]
        [TestCase(1003, 7, true)]
        [TestCase(5, 1, true)]
        [TestCase(1, 1, false)]
        [TestCase(0, 1, true)]
        public void Next_UntilTheEnd_GivesEachPointOnceAndBlocksInOrder(int count, int pointsPerBlock, bool canSlice)
        {
            using var reader = Blocks(count, pointsPerBlock);
            var plan = new DepthPlan(reader, canSlice, 1);
            var taken = new int[reader.BlockCount];
            foreach (long until in new long[] { count / 15, count / 5, count / 2, count })
            {
                for (var ranges = plan.Next(until); ranges.Count > 0; ranges = plan.Next(until))
                {
                    foreach (var range in ranges)
                    {
                        Assert.That(range.First, Is.EqualTo(taken[range.Block]));
                        taken[range.Block] += range.Count;
                        plan.Tell(range, range.Count, range.Block % 3);
                    }
                }
                Assert.That(plan.Taken, Is.GreaterThanOrEqualTo(until));
                Assert.That(plan.Taken, Is.LessThan(until + pointsPerBlock));
            }
            for (int block = 0; block < taken.Length; block++)
                Assert.That(plan.IsTaken(block) && taken[block] == reader.PointsInBlock(block), Is.True);
        }

        [Test]
        public void Next_BlocksThatFindBareCells_AreGoneOnWithFirst()
        {
            using var reader = Blocks(16_000, 1000);
            var plan = new DepthPlan(reader, true, 1);
            var taken = new int[reader.BlockCount];
            for (var ranges = plan.Next(8000); ranges.Count > 0; ranges = plan.Next(8000))
            {
                foreach (var range in ranges)
                {
                    taken[range.Block] += range.Count;
                    plan.Tell(range, range.Count, range.Block < 4 ? range.Count : 1);
                }
            }
            Assert.That(taken.Take(4), Has.All.EqualTo(1000));
            Assert.That(taken.Skip(4), Has.All.InRange(125, 500));
        }

        [Test]
        public void Next_ABrokenBlock_IsAskedForNothingMore()
        {
            using var reader = Blocks(800, 100);
            var plan = new DepthPlan(reader, true, 1);
            int ofThird = 0;
            foreach (long until in new long[] { 400, 800 })
            {
                for (var ranges = plan.Next(until); ranges.Count > 0; ranges = plan.Next(until))
                {
                    foreach (var range in ranges)
                    {
                        ofThird += range.Block == 3 ? 1 : 0;
                        plan.Tell(range, range.Block == 3 ? range.Count - 1 : range.Count, 0);
                    }
                }
            }
            Assert.That(ofThird, Is.EqualTo(1));
            Assert.That(plan.Taken, Is.EqualTo(800));
        }

        [Test]
        public void Next_MoreBlocksThanStates_GivesWholeOnesSpreadOverTheSource()
        {
            using var reader = Blocks(40_000, 100);
            var plan = new DepthPlan(reader, true, 1);
            Assert.That(plan.IsSliced, Is.False);
            var ranges = new List<BlockRange>();
            for (var round = plan.Next(10_000); round.Count > 0; round = plan.Next(10_000))
                ranges.AddRange(round);
            Assert.That(ranges, Has.Count.EqualTo(100));
            Assert.That(ranges.Select(r => r.Count), Has.All.EqualTo(100));
            foreach (var quarter in ranges.GroupBy(r => r.Block / 100))
                Assert.That(quarter.Count(), Is.EqualTo(25).Within(6));
        }
    }
}
