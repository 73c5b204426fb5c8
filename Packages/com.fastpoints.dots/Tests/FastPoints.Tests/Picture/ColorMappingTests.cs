using System;
using FastPoints.Drawing;
using FastPoints.Picture;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Picture
{
    public class ColorMappingTests
    {
        static unsafe uint[] Colors(PointBatch batch, DisplayRanges ranges, ColorMode mode, PositionTransform transform)
        {
            var mapping = ColorMapping.For(mode, ranges, batch, transform);
            using var palettes = Palettes.CreateAll(Allocator.Persistent);
            double* x = stackalloc double[batch.Count], y = stackalloc double[batch.Count], z = stackalloc double[batch.Count];
            byte* bytes = (byte*)batch.Bytes.GetUnsafeReadOnlyPtr();
            PositionColumns.Of(batch).Load(bytes, 0, batch.Count, x, y, z);
            var colors = new uint[batch.Count];
            fixed (uint* at = colors)
                PointColoring.ColorBatch(bytes, 0, mapping, (uint*)palettes.GetUnsafeReadOnlyPtr(),
                    new PointSpan { Count = batch.Count, X = x, Y = y, Z = z, Colors = at });
            return colors;
        }

        static PointBatch With(string[] names, AttributeType type, params double[][] rows)
        {
            var batch = TestBatches.New(rows.Length, AttributeType.Int32,
                Array.ConvertAll(names, name => new PointAttribute(name, type)));
            for (int i = 0; i < rows.Length; i++)
                for (int column = 0; column < rows[i].Length; column++)
                    TestBatches.Set(batch, column, i, rows[i][column]);
            return batch;
        }

        static readonly string[] s_rgb = { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue };

        [TestCase(AttributeType.UInt16, ColorDepth.Bits16, 0x1234, 0x12)]
        [TestCase(AttributeType.UInt16, ColorDepth.Bits16, 65535, 255)]
        [TestCase(AttributeType.UInt16, ColorDepth.Bits8, 200, 200)]
        [TestCase(AttributeType.UInt8, ColorDepth.Bits8, 255, 255)]
        [TestCase(AttributeType.Float32, ColorDepth.Unit, 1, 255)]
        [TestCase(AttributeType.Float32, ColorDepth.Unit, 0.5, 128)]
        [TestCase(AttributeType.Float32, ColorDepth.Unit, 7, 255)]
        [TestCase(AttributeType.Float32, ColorDepth.Unit, double.NaN, 0)]
        public void Rgb_EachBitDepth_BecomesBytes(AttributeType type, ColorDepth depth, double stored, int value)
        {
            using var batch = With(s_rgb, type, new[] { 0, 0, 0, stored, 0, stored });
            var color = Colors(batch, new DisplayRanges { Color = depth }, ColorMode.Rgb, PositionTransform.Identity)[0];
            Assert.That(color, Is.EqualTo(Palettes.Pack((byte)value, 0, (byte)value)));
        }

        [Test]
        public void Elevation_LowMiddleHigh_FollowTheRamp()
        {
            var transform = new PositionTransform { Scale = new double3(1, 1, 0.01), Offset = new double3(0, 0, 500) };
            using var batch = With(new string[0], AttributeType.UInt8, new double[] { 9, 9, 0 }, new double[] { 9, 9, 1000 },
                new double[] { 9, 9, -5000 }, new double[] { 9, 9, 9000 });
            var ranges = new DisplayRanges { ElevationLow = 500, ElevationHigh = 510 };
            var colors = Colors(batch, ranges, ColorMode.Elevation, transform);
            using var palette = Palettes.Create(ColorMode.Elevation, Allocator.Persistent);
            uint low = palette[0], high = palette[255];
            Assert.That(colors, Is.EqualTo(new[] { low, high, low, high }));
        }

        [Test]
        public void Intensity_OneValueAlone_IsTheMiddleOfTheRamp()
        {
            using var batch = With(new[] { AttributeNames.Intensity }, AttributeType.UInt16, new double[] { 0, 0, 0, 700 });
            var ranges = new DisplayRanges { IntensityLow = 700, IntensityHigh = 700 };
            var colors = Colors(batch, ranges, ColorMode.Intensity, PositionTransform.Identity);
            using var palette = Palettes.Create(ColorMode.Intensity, Allocator.Persistent);
            Assert.That(colors[0], Is.EqualTo(palette[128]));
        }

        [Test]
        public void Classification_Class_HasItsEntry()
        {
            using var batch = With(new[] { AttributeNames.Classification }, AttributeType.UInt8, new double[] { 0, 0, 0, 6 });
            using var palette = Palettes.Create(ColorMode.Classification, Allocator.Persistent);
            var colors = Colors(batch, new DisplayRanges(), ColorMode.Classification, PositionTransform.Identity);
            Assert.That(colors[0], Is.EqualTo(palette[6]));
        }
    }
}
