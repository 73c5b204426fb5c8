using System.Collections.Generic;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Sampling;
using NUnit.Framework;

namespace FastPoints.Tests.Sampling
{
    public class RefiningPlanTests
    {
        static MemoryPointReader Blocks(int count, int pointsPerBlock) =>
            new MemoryPointReader(TestBatches.New(count, PositionColumns.Attributes(AttributeType.Int32)), pointsPerBlock, false);

        [TestCase(1000, 100, true), TestCase(1000, 100, false), TestCase(1003, 7, true), TestCase(5, 1, true)]
        [TestCase(1, 1, false), TestCase(0, 1, true)]
        public void Next_UntilTheEnd_GivesEachPointOnceAndBlocksInOrder(int count, int pointsPerBlock, bool canSlice)
        {
            using var reader = Blocks(count, pointsPerBlock);
            var plan = new RefiningPlan(reader, canSlice, 1);
            var taken = new int[reader.BlockCount];
            foreach (double share in new[] { 1 / 15.0, 0.2, 0.5, 1 })
            {
                for (var ranges = plan.Next(share); ranges.Count > 0; ranges = plan.Next(share))
                    foreach (var range in ranges)
                    {
                        Assert.That(range.First, Is.EqualTo(taken[range.Block]));
                        taken[range.Block] += range.Count;
                        plan.EndIfShort(range, range.Count);
                    }
                Assert.That(plan.Taken, Is.GreaterThanOrEqualTo(share * count));
                Assert.That(plan.Taken,
                    Is.LessThanOrEqualTo(share * count + (plan.IsSliced ? reader.BlockCount : pointsPerBlock)));
            }
            for (int block = 0; block < taken.Length; block++)
                Assert.That(plan.IsTaken(block) && taken[block] == reader.PointsInBlock(block), Is.True);
        }

        [Test]
        public void Next_BlocksWithStates_AreReadToEqualDepth()
        {
            using var reader = Blocks(100_000, 1000);
            var plan = new RefiningPlan(reader, true, 1);
            var taken = new int[reader.BlockCount];
            foreach (double share in new[] { 0.2, 0.5 })
            {
                for (var ranges = plan.Next(share); ranges.Count > 0; ranges = plan.Next(share))
                    foreach (var range in ranges)
                        taken[range.Block] += range.Count;
                Assert.That(taken, Has.All.EqualTo((int)(1000 * share)));
            }
        }

        [Test]
        public void Next_BrokenBlock_IsNotReadAgain()
        {
            using var reader = Blocks(800, 100);
            var plan = new RefiningPlan(reader, true, 1);
            int ofThird = 0;
            foreach (double share in new[] { 0.5, 1 })
                for (var ranges = plan.Next(share); ranges.Count > 0; ranges = plan.Next(share))
                    foreach (var range in ranges)
                    {
                        ofThird += range.Block == 3 ? 1 : 0;
                        plan.EndIfShort(range, range.Block == 3 ? range.Count - 1 : range.Count);
                    }
            Assert.That(ofThird, Is.EqualTo(1));
            Assert.That(plan.Taken, Is.EqualTo(800));
        }

        [Test]
        public void Next_MoreBlocksThanStates_GivesWholeBlocksSpreadOverTheSource()
        {
            using var reader = Blocks(40_000, 100);
            var plan = new RefiningPlan(reader, true, 1);
            Assert.That(plan.IsSliced, Is.False);
            var ranges = new List<BlockRange>();
            for (var round = plan.Next(0.25); round.Count > 0; round = plan.Next(0.25))
                ranges.AddRange(round);
            Assert.That(ranges, Has.Count.EqualTo(100));
            Assert.That(ranges.Select(r => r.Count), Has.All.EqualTo(100));
            foreach (var quarter in ranges.GroupBy(r => r.Block / 100))
                Assert.That(quarter.Count(), Is.EqualTo(25).Within(6));
        }
    }
}
