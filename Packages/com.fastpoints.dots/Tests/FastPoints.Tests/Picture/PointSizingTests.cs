using FastPoints.Picture;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Picture
{
    public class PointSizingTests
    {
        /// <summary>A canvas with sizes chosen, on which these shares of the left and the right half's pixels are
        /// covered.</summary>
        static PictureCanvas Chosen(double left, double right, double pointsPerPoint = 1)
        {
            var canvas = new PictureCanvas(256, 128, Allocator.Persistent);
            var pixels = canvas.Pixels;
            var random = new Unity.Mathematics.Random(3);
            for (int i = 0; i < pixels.Length; i++)
                if (random.NextDouble() < (i % 256 < 128 ? left : right))
                    pixels[i] = 1;
            canvas.ScheduleChooseSizes(pointsPerPoint, default).Complete();
            return canvas;
        }

        [TestCase(1, 1, 1), TestCase(0.95, 1, 1.2), TestCase(0.2, 3.5, 4.4), TestCase(0.1, 5, 6)]
        [TestCase(0.01, 8, 9), TestCase(0.001, 12, 12), TestCase(0, 1, 1)]
        public void Choose_EvenPicture_GrowsWithThePointSpacing(double share, double min, double max)
        {
            using var canvas = Chosen(share, share);
            Assert.That(canvas.TypicalSizePx, Is.InRange(min, max));
            foreach (float size in canvas.SizeOfTile)
                Assert.That(size, Is.InRange(1, System.Math.Min(System.Math.Max(6, canvas.TypicalSizePx),
                    2 * canvas.TypicalSizePx + 1)));
        }

        [Test]
        public void Choose_DenseAndSparseHalves_GetTheirOwnSizes()
        {
            using var canvas = Chosen(0.97, 0.5);
            int tiles = PointSizing.TilesAlong(256);
            Assert.That(canvas.SizeOfTile[5 * tiles + 5], Is.EqualTo(1).Within(0.1));
            Assert.That(canvas.SizeOfTile[5 * tiles + 25], Is.InRange(1.8, 2.7));
        }

        [Test]
        public void Choose_FewOutliersBesideASurface_StaySmall()
        {
            using var canvas = Chosen(0.97, 0.001);
            foreach (float size in canvas.SizeOfTile)
                Assert.That(size, Is.LessThanOrEqualTo(3.3f));
        }

        [Test]
        public void Choose_ManyPointsStillUnread_StaysSmall()
        {
            using var canvas = Chosen(0.1, 0.1, 100);
            Assert.That(canvas.TypicalSizePx, Is.EqualTo(1));
        }

        [Test]
        public void UseSize_AllTiles_HaveThatSize()
        {
            using var canvas = new PictureCanvas(17, 8, Allocator.Persistent);
            canvas.UseSize(2.5f);
            Assert.That(canvas.SizeOfTile.ToArray(), Is.EqualTo(new[] { 2.5f, 2.5f, 2.5f }));
            Assert.That(canvas.MaxTileSizePx, Is.EqualTo(2.5f));
        }
    }
}
