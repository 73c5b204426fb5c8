using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests
{
    public static class TestBatches
    {
        /// <summary>Positions as float64 columns.</summary>
        public static PointBatch OfPositions(params double3[] positions)
        {
            var batch = New(positions.Length, PositionColumns.Attributes(AttributeType.Float64));
            for (int i = 0; i < positions.Length; i++)
                for (int axis = 0; axis < 3; axis++)
                    Set(batch, axis, i, positions[i][axis]);
            return batch;
        }

        /// <summary>Positions as float64 columns, with 8-bit colours packed as pictures have them.</summary>
        public static PointBatch OfColoredPositions(double3[] positions, uint[] colors)
        {
            var batch = New(positions.Length, AttributeType.Float64, Colors(AttributeType.UInt8));
            for (int i = 0; i < positions.Length; i++)
            {
                for (int axis = 0; axis < 3; axis++)
                    Set(batch, axis, i, positions[i][axis]);
                for (int channel = 0; channel < 3; channel++)
                    Set(batch, 3 + channel, i, colors[i] >> (8 * channel) & 255);
            }
            return batch;
        }

        /// <summary>A seeded scan: int32 positions on an uneven surface, 16-bit colour, intensity, class; gpstime to be left
        /// out.</summary>
        public static PointBatch Scan(int count, uint seed)
        {
            var others = new[]
            {
                new PointAttribute(AttributeNames.Intensity, AttributeType.UInt16),
                new PointAttribute(AttributeNames.Classification, AttributeType.UInt8),
                new PointAttribute(AttributeNames.GpsTime, AttributeType.Float64),
            };
            var batch = New(count, AttributeType.Int32, others.Concat(Colors(AttributeType.UInt16)).ToArray());
            var random = new Unity.Mathematics.Random(seed);
            for (int i = 0; i < count; i++)
            {
                double x = random.NextDouble(0, 100_000), y = random.NextDouble(0, 60_000);
                Set(batch, 0, i, Math.Floor(x));
                Set(batch, 1, i, Math.Floor(y));
                Set(batch, 2, i, Math.Floor(5000 + 4000 * Math.Sin(x * 1e-4) * Math.Cos(y * 2e-4)));
                Set(batch, 3, i, random.NextInt(10, 4000));
                Set(batch, 4, i, random.NextInt(0, 20));
                Set(batch, 5, i, i * 0.25);
                for (int channel = 0; channel < 3; channel++)
                    Set(batch, 6 + channel, i, random.NextInt(0, 65536));
            }
            return batch;
        }

        public static PointAttribute[] Colors(AttributeType type) => new[]
        {
            new PointAttribute(AttributeNames.Red, type), new PointAttribute(AttributeNames.Green, type),
            new PointAttribute(AttributeNames.Blue, type),
        };

        /// <summary>Points of which x is the index, y its negative; z and the intensity follow from it, times are zero.</summary>
        public static PointBatch Numbered(int count)
        {
            var batch = New(count, AttributeType.Int32, new PointAttribute(AttributeNames.GpsTime, AttributeType.Float64),
                new PointAttribute(AttributeNames.Intensity, AttributeType.UInt16));
            for (int i = 0; i < count; i++)
            {
                Set(batch, 0, i, i);
                Set(batch, 1, i, -i);
                Set(batch, 2, i, i % 1000);
                Set(batch, 4, i, i % 60_000);
            }
            return batch;
        }

        public static PointBatch New(int count, AttributeType positions, params PointAttribute[] others) =>
            New(count, PositionColumns.Attributes(positions).Concat(others));

        public static PointBatch New(int count, IEnumerable<PointAttribute> attributes) =>
            new PointBatch(new PointSchema(attributes), Math.Max(1, count), Allocator.Persistent) { Count = count };

        public static void Set(PointBatch batch, int column, int index, double value)
        {
            switch (batch.Schema[column].Type)
            {
                case AttributeType.UInt8: Put(batch, column, index, (byte)value); break;
                case AttributeType.Int8: Put(batch, column, index, (sbyte)value); break;
                case AttributeType.UInt16: Put(batch, column, index, (ushort)value); break;
                case AttributeType.Int16: Put(batch, column, index, (short)value); break;
                case AttributeType.UInt32: Put(batch, column, index, (uint)value); break;
                case AttributeType.Int32: Put(batch, column, index, (int)value); break;
                case AttributeType.UInt64: Put(batch, column, index, (ulong)value); break;
                case AttributeType.Int64: Put(batch, column, index, (long)value); break;
                case AttributeType.Float32: Put(batch, column, index, (float)value); break;
                default: Put(batch, column, index, value); break;
            }
        }

        public static void Put<T>(PointBatch batch, int column, int index, T value) where T : unmanaged
        {
            var values = batch.Column<T>(column);
            values[index] = value;
        }
    }
}
