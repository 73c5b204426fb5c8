using System;
using System.Linq;
using FastPoints.Evaluation;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Evaluation
{
    [Category("Smoke")]
    public class SummariseCloudTests
    {
        static CloudSummary Summarise(MemoryPointReader reader, int slots)
        {
            var cloud = new SummariseCloud(reader);
            JobCoroutine.RunToEnd(cloud.Run(new StageProgress(), slots));
            return cloud.Summary;
        }

        [TestCase(1, 10_000), TestCase(3, 333), TestCase(8, 1)]
        public void Run_SeededScan_FindsCountBoundsRangesAndSums(int slots, int pointsPerBlock)
        {
            var batch = TestBatches.Scan(2000, 6);
            ulong sumX = 0, sumTime = 0;
            int minX = int.MaxValue, maxX = int.MinValue;
            var x = batch.Column<int>(0);
            var time = batch.Column<double>(AttributeNames.GpsTime);
            for (int i = 0; i < batch.Count; i++)
            {
                sumX += (ulong)x[i];
                sumTime += (ulong)BitConverter.DoubleToInt64Bits(time[i]);
                minX = Math.Min(minX, x[i]);
                maxX = Math.Max(maxX, x[i]);
            }
            using var reader = new MemoryPointReader(batch, pointsPerBlock);
            reader.Info.Transform = new PositionTransform
            {
                Scale = new double3(0.01, 0.01, 0.01),
                Offset = new double3(5e5, 5e6, 0)
            };
            var summary = Summarise(reader, slots);
            Assert.That(summary.Points, Is.EqualTo(2000));
            Assert.That(summary.NonFiniteCount, Is.EqualTo(0));
            Assert.That(summary.Bounds.Min.x, Is.EqualTo(minX * 0.01 + 5e5));
            Assert.That(summary.Bounds.Max.x, Is.EqualTo(maxX * 0.01 + 5e5));
            Assert.That(summary.Columns[0].Sum, Is.EqualTo(sumX));
            Assert.That(summary.Columns[0].MinText, Is.EqualTo(minX.ToString()));
            Assert.That(summary.Columns[5].Sum, Is.EqualTo(sumTime));
            Assert.That(summary.Columns[5].Max, Is.EqualTo(1999 * 0.25));
        }

        [Test]
        public void Run_EachType_IsExactToTheLastDigit()
        {
            var types = (AttributeType[])Enum.GetValues(typeof(AttributeType));
            var attributes = PositionColumns.Attributes(AttributeType.Int32)
                .Concat(types.Select(type => new PointAttribute(type.ToString(), type)));
            var batch = TestBatches.New(2, attributes);
            for (int i = 0; i < types.Length; i++)
            {
                TestBatches.Set(batch, 3 + i, 0, 1);
                TestBatches.Set(batch, 3 + i, 1, 2);
            }
            TestBatches.Put(batch, 3 + (int)AttributeType.UInt64, 0, ulong.MaxValue);
            TestBatches.Put(batch, 3 + (int)AttributeType.Int64, 0, long.MinValue);
            TestBatches.Put(batch, 3 + (int)AttributeType.Int8, 0, (sbyte)-5);
            using var reader = new MemoryPointReader(batch, 1);
            var columns = Summarise(reader, 2).Columns;
            Assert.That(columns[3 + (int)AttributeType.UInt64].MaxText, Is.EqualTo("18446744073709551615"));
            Assert.That(columns[3 + (int)AttributeType.UInt64].MinText, Is.EqualTo("2"));
            Assert.That(columns[3 + (int)AttributeType.UInt64].Sum, Is.EqualTo(1));
            Assert.That(columns[3 + (int)AttributeType.Int64].MinText, Is.EqualTo("-9223372036854775808"));
            Assert.That(columns[3 + (int)AttributeType.Int64].MaxText, Is.EqualTo("2"));
            Assert.That(columns[3 + (int)AttributeType.Int8].Min, Is.EqualTo(-5));
            Assert.That(columns[3 + (int)AttributeType.Int8].Sum, Is.EqualTo(unchecked((ulong)-3)));
            Assert.That(columns[3 + (int)AttributeType.Float32].Sum, Is.EqualTo(0x3F800000UL + 0x40000000UL));
            Assert.That(columns[3 + (int)AttributeType.Float32].MaxText, Is.EqualTo("2"));
        }

        [Test]
        public void IncludeColumn_SeededValuesOfEachType_MatchOneByOne(
            [Values(1, 7, 8, 9, 300)] int count, [Values(1, 3, 1000)] int valuesAlike)
        {
            var random = new System.Random(count * valuesAlike);
            foreach (AttributeType type in Enum.GetValues(typeof(AttributeType)))
            {
                int size = type.SizeOf();
                var column = new byte[count * size];
                for (int i = 0; i < count; i++)
                {
                    if (i % valuesAlike == 0)
                        random.NextBytes(column.AsSpan(i * size, size));
                    else
                        column.AsSpan((i - 1) * size, size).CopyTo(column.AsSpan(i * size, size));
                }
                var whole = ColumnSummary.EmptyOf(type);
                var single = ColumnSummary.EmptyOf(type);
                unsafe
                {
                    fixed (byte* first = column)
                    {
                        whole.IncludeColumn(first, count);
                        for (int i = 0; i < count; i++)
                            Add(ref single, type, first + i * size);
                    }
                }
                Assert.That((whole.Sum, whole.MinText, whole.MaxText, whole.Finite, whole.NonFiniteCount),
                    Is.EqualTo((single.Sum, single.MinText, single.MaxText, single.Finite, single.NonFiniteCount)),
                    type.ToString());
                Assert.That(whole.Finite + whole.NonFiniteCount, Is.EqualTo(count));
                if (type == AttributeType.Int16 || type == AttributeType.UInt8)
                {
                    long sum = 0, min = long.MaxValue, max = long.MinValue;
                    for (int i = 0; i < count; i++)
                    {
                        long value = type == AttributeType.UInt8 ? column[i] : BitConverter.ToInt16(column, 2 * i);
                        (sum, min, max) = (sum + value, Math.Min(min, value), Math.Max(max, value));
                    }
                    Assert.That((whole.Sum, whole.Min, whole.Max), Is.EqualTo(((ulong)sum, (double)min, (double)max)));
                }
            }
        }

        static unsafe void Add(ref ColumnSummary summary, AttributeType type, byte* value)
        {
            var one = ColumnSummary.EmptyOf(type);
            one.IncludeColumn(value, 1);
            summary.Include(one);
        }

        [TestCase(0.01, 5e5), TestCase(-0.25, -3), TestCase(0, 7), TestCase(double.NaN, 0), TestCase(1e308, 0)]
        public void Run_Integers_HaveTheBoundsOfTheirPositions(double scale, double offset)
        {
            var batch = TestBatches.Scan(500, 9);
            using var reader = new MemoryPointReader(batch, 77);
            var (x, y) = (new double3(scale, 1, 1), new double3(offset, 0, 0));
            reader.Info.Transform = new PositionTransform { Scale = x, Offset = y };
            var expected = PositionBounds.RunImmediate(batch, reader.Info.Transform);
            var summary = Summarise(reader, 3);
            Assert.That((summary.Bounds, summary.NonFiniteCount), Is.EqualTo((expected.Bounds, expected.NonFiniteCount)));
        }

        [Test]
        public void Run_NonFiniteValues_AreSummedButNotInTheRange()
        {
            var batch = TestBatches.OfPositions(new double3(1, 2, 3), new double3(double.NaN, 50, 60), new double3(7, 8, 9));
            using var reader = new MemoryPointReader(batch, 2);
            var summary = Summarise(reader, 2);
            Assert.That(summary.NonFiniteCount, Is.EqualTo(1));
            Assert.That(summary.Bounds.Max, Is.EqualTo(new double3(7, 8, 9)));
            Assert.That(summary.Columns[0].NonFiniteCount, Is.EqualTo(1));
            Assert.That(summary.Columns[0].Finite, Is.EqualTo(2));
            Assert.That(summary.Columns[1].Max, Is.EqualTo(50));
        }

        [Test]
        public void Run_NoPoints_IsEmpty()
        {
            using var reader = new MemoryPointReader(TestBatches.OfPositions(), 10);
            var summary = Summarise(reader, 2);
            Assert.That(summary.Points, Is.EqualTo(0));
            Assert.That(summary.Bounds.IsEmpty, Is.True);
            Assert.That(summary.Columns[0].MinText, Is.Null);
        }

        [Test]
        public void Run_TruncatedSource_CountsTheExistingPoints()
        {
            using var reader = new MemoryPointReader(TestBatches.Scan(1000, 1), 128, true, 700);
            Assert.That(Summarise(reader, 3).Points, Is.EqualTo(700));
        }
    }
}
