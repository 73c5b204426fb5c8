using System;
using System.Linq;
using FastPoints.Drawing;
using FastPoints.Evaluation;
using FastPoints.Picture;
using NUnit.Framework;

namespace FastPoints.Tests.Evaluation
{
    /// <summary>Expected values are of the authors' implementation (github.com/NVlabs/flip, C++, version 1.6) for the same
    /// pictures.</summary>
    public class FlipMapTests
    {
        const int Width = 150, Height = 140;

        /// <summary>A ramp, a disc and a fine pattern, so large that it has four tiles.</summary>
        static RgbaImage Reference() => Filled(Width, Height, (x, y) =>
            Palettes.Pack((byte)(x * 5 + y * 2), Disc(x, y, 60), (byte)((x ^ y) * 3)));

        /// <summary>The same with squares of other red, the disc two pixels to the right, and noise in blue.</summary>
        static RgbaImage Picture() => Filled(Width, Height, (x, y) =>
        {
            int red = x * 5 + y * 2 & 255, noise = (int)(Mix((uint)(y * Width + x)) & 31);
            return Palettes.Pack((byte)((x / 8 + y / 8) % 3 == 0 ? red ^ 40 : red), Disc(x, y, 62),
                (byte)Math.Min(255, ((x ^ y) * 3 & 255) + noise));
        });

        static RgbaImage Filled(int width, int height, Func<int, int, uint> colorAt)
        {
            var image = new RgbaImage(width, height);
            for (int y = 0; y < height; y++)
                for (int x = 0; x < width; x++)
                    image[x, y] = colorAt(x, y);
            return image;
        }

        static byte Disc(int x, int y, int centre) =>
            (byte)((x - centre) * (x - centre) + (y - 50) * (y - 50) < 900 ? 220 : 60 + y);

        static uint Mix(uint value)
        {
            value ^= value >> 16;
            value *= 0x7feb352du;
            value ^= value >> 15;
            value *= 0x846ca68bu;
            return value ^ value >> 16;
        }

        [TestCase(FlipMap.DefaultPixelsPerDegree, 0.2450378), TestCase(30, 0.2478211)]
        public void Of_TwoPictures_HasTheAuthorsMean(double pixelsPerDegree, double mean) =>
            Assert.That(FlipMap.Of(Picture(), Reference(), pixelsPerDegree).Mean, Is.EqualTo(mean).Within(2e-6));

        // Corners, both sides of the disc, both sides of the seams between tiles.
        [TestCase(0, 0, 0.168692), TestCase(149, 139, 0.164425), TestCase(31, 50, 0.849446), TestCase(92, 51, 0.714110)]
        [TestCase(127, 64, 0.203492), TestCase(128, 64, 0.200158), TestCase(70, 127, 0.238051), TestCase(70, 128, 0.232307)]
        [TestCase(140, 5, 0.207533), TestCase(60, 50, 0.156279)]
        public void Of_TwoPictures_HasTheAuthorsErrorOfAPixel(int x, int y, double error) =>
            Assert.That(FlipMap.Of(Picture(), Reference()).Errors[y * Width + x], Is.EqualTo(error).Within(1e-5));

        [Test]
        public void Of_PicturesSmallerThanTheFilters_HasTheAuthorsErrors()
        {
            var map = FlipMap.Of(Filled(7, 5, (x, y) => Ramp(41 * (y * 7 + x), 90)),
                Filled(7, 5, (x, y) => Ramp(37 * (y * 7 + x), 80)));
            Assert.That(map.Mean, Is.EqualTo(0.6496485).Within(2e-6));
            Assert.That(map.Errors[2 * 7 + 3], Is.EqualTo(0.755807).Within(1e-5));
        }

        static uint Ramp(int first, int step) => Palettes.Pack((byte)first, (byte)(first + step), (byte)(first + 2 * step));

        [Test]
        public void Of_GreenAgainstBlue_IsTheLargestError() =>
            Assert.That(FlipMap.Of(Filled(20, 20, (x, y) => 0xFFFF0000), Filled(20, 20, (x, y) => 0xFF00FF00)).Errors,
                Has.All.EqualTo(1).Within(1e-5));

        [Test]
        public void Of_EqualPictures_IsZero() =>
            Assert.That(FlipMap.Of(Picture(), Picture()).Errors, Has.All.Zero);

        [Test]
        public void Of_DifferentSizes_Throws() =>
            Assert.That(() => FlipMap.Of(Filled(2, 2, (x, y) => 0), Filled(2, 3, (x, y) => 0)),
                Throws.TypeOf<ArgumentException>());

        [Test]
        public void ToImage_Errors_AreEntriesOfMagma()
        {
            var map = FlipMap.Of(Picture(), Reference());
            var image = map.ToImage();
            Assert.That(Enumerable.Range(0, Width * Height).Select(i => image[i % Width, i / Width]),
                Is.EqualTo(map.Errors.Select(e => FlipMap.Magma((int)(e * 255 + 0.5) / 255.0))));
        }

        [TestCase(0, 0, 0, 4), TestCase(64, 81, 18, 124), TestCase(128, 183, 55, 121)]
        [TestCase(191, 251, 135, 97), TestCase(255, 252, 253, 191)]
        public void Magma_KnownEntries_AreWithinFiveSteps(int entry, int red, int green, int blue)
        {
            uint color = FlipMap.Magma(entry / 255.0);
            Assert.That((int)(color & 255), Is.EqualTo(red).Within(5));
            Assert.That((int)(color >> 8 & 255), Is.EqualTo(green).Within(5));
            Assert.That((int)(color >> 16 & 255), Is.EqualTo(blue).Within(5));
        }
    }
}
