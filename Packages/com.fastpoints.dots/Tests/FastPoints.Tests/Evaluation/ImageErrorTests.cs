using System;
using FastPoints.Evaluation;
using FastPoints.Picture;
using NUnit.Framework;

namespace FastPoints.Tests.Evaluation
{
    public class ImageErrorTests
    {
        static RgbaImage Filled(int width, int height, uint color)
        {
            var image = new RgbaImage(width, height);
            for (int y = 0; y < height; y++)
                for (int x = 0; x < width; x++)
                    image[x, y] = color;
            return image;
        }

        [Test]
        public void Compare_EqualPictures_HasNoError()
        {
            var image = Filled(20, 20, 0xFF204060);
            image[3, 4] = 0xFFFFFFFF;
            var error = ImageError.Compare(image, image, 0xFF204060);
            Assert.That(error.Psnr, Is.EqualTo(double.PositiveInfinity));
            Assert.That(error.Ssim, Is.EqualTo(1).Within(1e-9));
            Assert.That(error.Flip, Is.Zero);
            Assert.That(error.Uncovered, Is.EqualTo(0));
        }

        [Test]
        public void Compare_EveryChannelOffByTen_HasItsPsnr()
        {
            var error = ImageError.Compare(Filled(16, 16, 0xFF646464), Filled(16, 16, 0xFF6E6E6E), 0);
            // 10 log10(255^2 / 10^2)
            Assert.That(error.Psnr, Is.EqualTo(28.1308).Within(1e-4));
            // Two flat pictures: (2 * 100 * 110 + C1) / (100^2 + 110^2 + C1), C1 = 2.55^2.
            double c1 = 2.55 * 2.55;
            Assert.That(error.Ssim, Is.EqualTo((2 * 100 * 110 + c1) / (100 * 100 + 110 * 110 + c1)).Within(1e-5));
        }

        [Test]
        public void Compare_InvertedPattern_HasNegativeSimilarity()
        {
            var one = Filled(32, 32, 0xFF000000);
            var other = Filled(32, 32, 0xFFFFFFFF);
            for (int y = 0; y < 32; y++)
                for (int x = y & 1; x < 32; x += 2)
                {
                    one[x, y] = 0xFFFFFFFF;
                    other[x, y] = 0xFF000000;
                }
            Assert.That(ImageError.Compare(one, other, 0).Ssim, Is.LessThan(-0.9));
        }

        [Test]
        public void Compare_MissingPixels_AreCountedAmongCoveredPixels()
        {
            const uint Background = 0xFF101010;
            var reference = Filled(10, 10, Background);
            var picture = Filled(10, 10, Background);
            for (int x = 0; x < 8; x++)
                reference[x, 0] = 0xFFFFFFFF;
            for (int x = 0; x < 6; x++)
                picture[x, 0] = 0xFF000000;
            picture[9, 9] = 0xFFFFFFFF;
            Assert.That(ImageError.Compare(picture, reference, Background).Uncovered, Is.EqualTo(0.25));
        }

        [Test]
        public void Compare_DifferentSizes_Throws() =>
            Assert.That(() => ImageError.Compare(Filled(2, 2, 0), Filled(2, 3, 0), 0), Throws.TypeOf<ArgumentException>());

        [Test]
        public void Compare_PicturesSmallerThanAWindow_HasASimilarity() =>
            Assert.That(ImageError.Compare(Filled(1, 1, 5), Filled(1, 1, 5), 0).Ssim, Is.EqualTo(1).Within(1e-9));
    }
}
