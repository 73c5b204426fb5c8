using FastPoints.Picture;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Tests.Picture
{
    public class ResolvePictureTests
    {
        const uint White = 0xFFFFFFFF;
        const uint RadiusOfOne = 1 << 24;

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
        public void Resolve_NoLighting_KeepsColoursAndFillsTheBackground()
        {
            Assert.That(Resolve(0, 0x80402010, 1, float.NaN, 5), Is.EqualTo(new[] { White, 0x80402010u, White }));
        }

        [Test]
        public void Resolve_FlatSurface_IsNotDarkened()
        {
            Assert.That(Resolve(1, 0, 3, 3, 3), Is.EqualTo(new[] { White, White, White }));
        }

        [Test]
        public void Resolve_PixelBehindItsNeighbour_IsDarkenedAndTheNeighbourIsNot()
        {
            var colors = Resolve(1, 0, 1, 5, 5);
            Assert.That(colors[0], Is.EqualTo(White));
            // 4 pixels behind one of eight: exp(-4 / 8) * 255 = 154.7.
            Assert.That(colors[1], Is.EqualTo(0xFF9B9B9Bu));
            Assert.That(colors[2], Is.EqualTo(White));
        }

        [Test]
        public void Resolve_NextToNothing_IsNotDarkened()
        {
            Assert.That(Resolve(1, 0, float.NaN, 5, float.NaN)[1], Is.EqualTo(White));
        }
    }
}
