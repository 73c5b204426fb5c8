using System;
using FastPoints.Build;
using FastPoints.Store;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Core
{
    public class ColumnValuesTests
    {
        static PointBatch Column(AttributeType type, params double[] values)
        {
            var batch = TestBatches.New(values.Length, new[] { new PointAttribute("Value", type) });
            for (int i = 0; i < values.Length; i++)
                TestBatches.Set(batch, 0, i, values[i]);
            return batch;
        }

        static unsafe ColumnRange RangeOf(PointBatch batch) =>
            ColumnRange.Measure((byte*)batch.Bytes.GetUnsafeReadOnlyPtr(), batch.Schema[0].Type, 0, batch.Count);

        [TestCase(AttributeType.UInt8, 0, 255)]
        [TestCase(AttributeType.Int8, -128, 127)]
        [TestCase(AttributeType.UInt16, 0, 65535)]
        [TestCase(AttributeType.Int16, -32768, 32767)]
        [TestCase(AttributeType.UInt32, 0, 4294967295)]
        [TestCase(AttributeType.Int32, -2147483648, 2147483647)]
        [TestCase(AttributeType.UInt64, 0, 9007199254740992)]
        [TestCase(AttributeType.Int64, -9007199254740992, 9007199254740992)]
        [TestCase(AttributeType.Float32, -1.5, 3.25)]
        [TestCase(AttributeType.Float64, -1e300, 1e300)]
        public void Range_EachType_FindsItsEnds(AttributeType type, double min, double max)
        {
            using var batch = Column(type, 1, min, 2, max, 3);
            var range = RangeOf(batch);
            Assert.That(range.Min, Is.EqualTo(min));
            Assert.That(range.Max, Is.EqualTo(max));
            Assert.That(range.FiniteCount, Is.EqualTo(5));
        }

        [Test]
        public void Range_NonFiniteValues_AreCountedApart()
        {
            using var batch = Column(AttributeType.Float32, double.NaN, 2, double.PositiveInfinity, double.NegativeInfinity);
            var range = RangeOf(batch);
            Assert.That(range.NonFiniteCount, Is.EqualTo(3));
            Assert.That(range.Min, Is.EqualTo(2));
            Assert.That(range.Max, Is.EqualTo(2));
        }

        [Test]
        public unsafe void ToBits_EachSign_IsExtendedByIt()
        {
            using var bytes = Column(AttributeType.Int8, -1, 5);
            using var floats = Column(AttributeType.Float32, -1);
            ulong* bits = stackalloc ulong[2];
            ColumnValues.ToBits((byte*)bytes.Bytes.GetUnsafeReadOnlyPtr(), AttributeType.Int8, 0, 2, bits);
            Assert.That(bits[0], Is.EqualTo(ulong.MaxValue));
            Assert.That(bits[1], Is.EqualTo(5));
            ColumnValues.ToBits((byte*)floats.Bytes.GetUnsafeReadOnlyPtr(), AttributeType.Float32, 0, 1, bits);
            Assert.That(bits[0], Is.EqualTo(0xBF800000UL));
        }

        [Test]
        public void OrderedBits_AnyNumbers_KeepTheOrderAndRoundTrip()
        {
            double[] values = { double.NegativeInfinity, -1e300, -2, -1e-310, 0, 1e-310, 1, 2, double.PositiveInfinity };
            for (int i = 0; i < values.Length; i++)
            {
                Assert.That(ColumnValues.FromOrderedBits(ColumnValues.OrderedBits(values[i])), Is.EqualTo(values[i]));
                if (i > 0)
                    Assert.That(ColumnValues.OrderedBits(values[i]), Is.GreaterThan(ColumnValues.OrderedBits(values[i - 1])));
            }
        }

        static ColumnQuantiles Measure(PointBatch batch, double scale, double offset, double low, double high)
        {
            using var found = new NativeReference<ColumnQuantiles>(ColumnQuantiles.Empty, Allocator.Persistent);
            var measured = default(JobHandle);
            for (int first = 0, half = batch.Count / 2 + 1; first < batch.Count; first += half)
                measured = new MeasureRangeJob
                {
                    Bytes = batch.Bytes,
                    Column = batch.Column(0),
                    First = first,
                    Count = Math.Min(half, batch.Count - first),
                    Found = found,
                }.Schedule(measured);
            new MeasureColumnJob
            {
                Bytes = batch.Bytes,
                Column = batch.Column(0),
                Count = batch.Count,
                Scale = scale,
                Offset = offset,
                LowQuantile = low,
                HighQuantile = high,
                Found = found,
            }.Schedule(measured).Complete();
            return found.Value;
        }

        [Test]
        public void Quantiles_EvenValues_AreTheirRanks()
        {
            var values = new double[1001];
            for (int i = 0; i < values.Length; i++)
                values[i] = (i * 8) % 1001;
            using var batch = Column(AttributeType.Int32, values);
            var found = Measure(batch, 1, 0, 0.1, 0.9);
            Assert.That(found.Low, Is.EqualTo(100));
            Assert.That(found.High, Is.EqualTo(900));
            Assert.That(found.Range.Max, Is.EqualTo(1000));
        }

        [Test]
        public void Quantiles_NegativeScale_StayInOrder()
        {
            var values = new double[101];
            for (int i = 0; i < values.Length; i++)
                values[i] = i;
            using var batch = Column(AttributeType.Int32, values);
            var found = Measure(batch, -1, 10, 0.1, 0.9);
            Assert.That(found.Low, Is.EqualTo(-80));
            Assert.That(found.High, Is.EqualTo(0));
            Assert.That(found.Range.Min, Is.EqualTo(-90));
            Assert.That(found.Range.Max, Is.EqualTo(10));
        }

        [Test]
        public void Quantiles_MoreValuesThanSampled_AreWithinTheStatedError()
        {
            var random = new Unity.Mathematics.Random(11);
            var values = new double[300_000];
            for (int i = 0; i < values.Length; i++)
                values[i] = random.NextDouble();
            values[12345] = 1e300;
            using var batch = Column(AttributeType.Float64, values);
            var found = Measure(batch, 1, 0, 0.25, 0.75);
            Assert.That(found.Low, Is.EqualTo(0.25).Within(0.01));
            Assert.That(found.High, Is.EqualTo(0.75).Within(0.01));
            Assert.That(found.Range.Max, Is.EqualTo(1e300));
        }

        [Test]
        public void Quantiles_NoFiniteValue_AreNaN()
        {
            using var batch = Column(AttributeType.Float64, double.NaN, double.PositiveInfinity);
            var found = Measure(batch, 1, 0, 0.1, 0.9);
            Assert.That(found.Range.IsEmpty, Is.True);
            Assert.That(found.Low, Is.NaN);
        }

        [Test]
        public void Bounds_PointsWithOneBadCoordinate_AreIgnored()
        {
            using var batch = TestBatches.OfPositions(new double3(1, 2, 3), new double3(-50, double.NaN, 0),
                new double3(4, -5, 6), new double3(0, 0, double.PositiveInfinity));
            var transform = new PositionTransform { Scale = new double3(2, -1, 1), Offset = new double3(100, 0, 0) };
            var found = PositionBounds.RunImmediate(batch, transform);
            Assert.That(found.NonFiniteCount, Is.EqualTo(2));
            Assert.That(found.Bounds.Min, Is.EqualTo(new double3(102, -2, 3)));
            Assert.That(found.Bounds.Max, Is.EqualTo(new double3(108, 5, 6)));
        }

        [TestCase(AttributeType.UInt8)]
        [TestCase(AttributeType.UInt16)]
        [TestCase(AttributeType.Int16)]
        public unsafe void Statistics_AnyCount_MatchOneByOne(AttributeType type)
        {
            var random = new Unity.Mathematics.Random(5);
            byte* values = stackalloc byte[200];
            for (int count = 1; count <= 100; count++)
            {
                for (int i = 0; i < 200; i++)
                    values[i] = (byte)(count % 7 == 0 ? 17 : random.NextInt(256));
                var found = AttributeStatistics.Of(values, type, count);
                var wanted = AttributeStatistics.None;
                for (int i = 0; i < count; i++)
                {
                    ulong value = OrderedBits.Load(values + i * type.SizeOf(), type);
                    wanted.Include(new AttributeStatistics { OrderedMin = value, OrderedMax = value, Or = value });
                    wanted.Modulo257OrOfUInt16 |= type == AttributeType.UInt16 ? (uint)(value >> 8 ^ value & 0xFF) : 0;
                }
                Assert.That(found, Is.EqualTo(wanted));
            }
        }
    }
}
