using FastPoints.Picture;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Tests.Picture
{
    public class ResolvePictureTests
    {
        const uint White = 0xFFFFFFFF, RadiusOfOne = 1 << 24;

        /// <summary>A row of pixels with these depths (NaN: none), orthographic, one unit a pixel.</summary>
        static uint[] Resolve(float strength, uint background, params float[] depths)
        {
            using var pixels = new NativeArray<ulong>(depths.Length, Allocator.Persistent);
            using var colors = new NativeArray<uint>(depths.Length, Allocator.Persistent);
            var keys = pixels;
            for (int i = 0; i < depths.Length; i++)
                keys[i] = float.IsNaN(depths[i])
                    ? PointDrawing.EmptyPixel
                    : (ulong)PointProjection.DepthToBits(depths[i]) << 32 | RadiusOfOne | White & 0xFFFFFF;
            new ResolvePictureJob
            {
                Pixels = pixels,
                Projection = new PointProjection { WidthPx = depths.Length, HeightPx = 1, IsOrthographic = true, ScalePx = 1 },
                Background = background,
                EdlStrength = strength,
                Colors = colors,
            }.Schedule(1, default).Complete();
            return colors.ToArray();
        }

        [Test]
        public void Resolve_NoLighting_KeepsColoursAndFillsTheBackground() =>
            Assert.That(Resolve(0, 0x80402010, 1, float.NaN, 5), Is.EqualTo(new[] { White, 0x80402010u, White }));

        [Test]
        public void Resolve_FlatSurface_IsNotDarkened() =>
            Assert.That(Resolve(1, 0, 3, 3, 3), Is.EqualTo(new[] { White, White, White }));

        [Test]
        public void Resolve_PixelBehindItsNeighbour_IsDarkenedAndTheNeighbourIsNot()
        {
            var colors = Resolve(1, 0, 1, 5, 5);
            Assert.That(colors[0], Is.EqualTo(White));
            // 4 pixels behind one of eight: exp(-4 / 8) * 255 = 154.7.
            Assert.That(colors[1], Is.EqualTo(0xFF9B9B9Bu));
            Assert.That(colors[2], Is.EqualTo(White));
        }

        /// <summary>3 by 3 pixels of depth 1, the middle empty, and as many more empty as told.</summary>
        [TestCase(0, true), TestCase(2, true), TestCase(3, false)]
        public void Resolve_HoleAmongPixels_IsFilledByTheirMean(int empty, bool isFilled)
        {
            using var pixels = new NativeArray<ulong>(9, Allocator.Persistent);
            using var colors = new NativeArray<uint>(9, Allocator.Persistent);
            var keys = pixels;
            for (int i = 0; i < 9; i++)
                keys[i] = i < empty || i == 4 ? PointDrawing.EmptyPixel : PointDrawing.KeyOf(1, 1, 0, i < 6 ? 0x000010u : 0x00FF20u);
            new ResolvePictureJob
            {
                Pixels = pixels,
                Projection = new PointProjection { WidthPx = 3, HeightPx = 3, IsOrthographic = true, ScalePx = 1 },
                Background = 0x12345678,
                FillsHoles = true,
                Colors = colors,
            }.Schedule(3, default).Complete();
            // Three of the pixels have 0xFF, 0x20.
            int count = 8 - empty;
            uint green = (uint)((3 * 0xFF + count / 2) / count),
                red = (uint)((3 * 0x20 + (count - 3) * 0x10 + count / 2) / count);
            Assert.That(colors[4], Is.EqualTo(isFilled ? 0xFF000000u | green << 8 | red : 0x12345678u));
        }

        [Test]
        public void Resolve_NextToBackground_IsNotDarkened() =>
            Assert.That(Resolve(1, 0, float.NaN, 5, float.NaN)[1], Is.EqualTo(White));
    }
}
