using FastPoints.Picture;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Tests.Picture
{
    public class PointSizingTests
    {
        /// <summary>The size chosen for a picture in which random pixels are covered, every n-th on average.</summary>
        static float Choose(double share, double pointsPerPoint)
        {
            using var canvas = new PictureCanvas(256, 256, Allocator.Persistent);
            var pixels = canvas.Pixels;
            var random = new Unity.Mathematics.Random(3);
            for (int i = 0; i < pixels.Length; i++)
                if (random.NextDouble() < share)
                    pixels[i] = 1;
            canvas.ScheduleMeasure(default).Complete();
            return PointSizing.Choose(canvas.Coverage, pointsPerPoint);
        }

        [Test]
        public void Choose_CoveredPicture_IsOnePixel()
        {
            Assert.That(Choose(1, 1), Is.EqualTo(1));
            Assert.That(Choose(0.95, 1), Is.LessThan(1.2f));
        }

        [Test]
        public void Choose_EmptyPicture_IsOnePixel()
        {
            Assert.That(Choose(0, 1), Is.EqualTo(1));
        }

        [Test]
        public void Choose_ThinPicture_GrowsWithTheGaps()
        {
            float tenth = Choose(0.1, 1), fifth = Choose(0.2, 1);
            Assert.That(tenth, Is.InRange(4, 6));
            Assert.That(fifth, Is.InRange(3, 4.2));
            Assert.That(Choose(0.01, 1), Is.EqualTo(6));
        }

        [Test]
        public void Choose_ManyMorePointsToCome_StaysSmall()
        {
            Assert.That(Choose(0.1, 100), Is.EqualTo(1));
        }

        [Test]
        public void Measure_KnownTiles_CountsTheirPixels()
        {
            using var canvas = new PictureCanvas(17, 8, Allocator.Persistent);
            var pixels = canvas.Pixels;
            pixels[0] = 1;
            pixels[17] = 1;
            pixels[16] = 1;
            canvas.ScheduleMeasure(default).Complete();
            Assert.That(canvas.Coverage[2], Is.EqualTo(1));
            Assert.That(canvas.Coverage[1], Is.EqualTo(1));
            Assert.That(canvas.Coverage[0], Is.EqualTo(1));
        }
    }
}
