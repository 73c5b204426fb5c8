using System;
using FastPoints.Picture;

namespace FastPoints.Evaluation
{
    /// <summary>How much a picture differs from a reference of the same size.</summary>
    internal struct ImageError
    {
        /// <summary>Peak signal-to-noise ratio over red, green and blue, in dB of the 8-bit sRGB values; infinite for equal
        /// pictures.</summary>
        public double Psnr;
        public double Ssim; // Mean structural similarity of the luma: 1 for equal pictures.
        public double Flip; // See FlipMap: 0 for equal pictures.

        /// <summary>The share of the pixels that the reference covers (those not of the background colour) that the picture
        /// leaves uncovered; 0 if the reference covers none.</summary>
        public double Uncovered;

        const int Window = 8;

        /// <summary>Main thread.</summary>
        public static ImageError Compare(RgbaImage picture, RgbaImage reference, uint background)
        {
            if (picture.Width != reference.Width || picture.Height != reference.Height)
                throw new ArgumentException("pictures of " + picture.Width + "x" + picture.Height + " and " +
                    reference.Width + "x" + reference.Height + " pixels have no common error");
            return new ImageError
            {
                Psnr = PsnrOf(picture.Rgba, reference.Rgba),
                Ssim = SsimOf(picture, reference),
                Flip = FlipMap.Of(picture, reference).Mean,
                Uncovered = UncoveredOf(picture, reference, background),
            };
        }

        static double PsnrOf(byte[] a, byte[] b)
        {
            long squares = 0;
            for (int i = 0; i < a.Length; i++)
            {
                if ((i & 3) == 3)
                    continue;
                int difference = a[i] - b[i];
                squares += difference * difference;
            }
            return squares == 0 ? double.PositiveInfinity : 10 * Math.Log10(255.0 * 255.0 * (a.Length / 4 * 3) / squares);
        }

        static double UncoveredOf(RgbaImage picture, RgbaImage reference, uint background)
        {
            long covered = 0, missing = 0;
            for (int y = 0; y < picture.Height; y++)
            {
                for (int x = 0; x < picture.Width; x++)
                {
                    if (reference[x, y] == background)
                        continue;
                    covered++;
                    if (picture[x, y] == background)
                        missing++;
                }
            }
            return covered == 0 ? 0 : missing / (double)covered;
        }

        /// <summary>Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment", 2004, eq. 13, computed over windows of 8 by 8
        /// pixels at every second pixel, with even weights, on Rec. 709 luma of the encoded values.</summary>
        static double SsimOf(RgbaImage a, RgbaImage b)
        {
            const double C1 = 0.01 * 255 * (0.01 * 255), C2 = 0.03 * 255 * (0.03 * 255);
            float[] lumaA = Luma(a), lumaB = Luma(b);
            int windowX = Math.Min(Window, a.Width), windowY = Math.Min(Window, a.Height);
            double total = 0;
            long windows = 0;
            for (int top = 0; top + windowY <= a.Height; top += 2)
            {
                for (int left = 0; left + windowX <= a.Width; left += 2)
                {
                    double sumA = 0, sumB = 0, sumAA = 0, sumBB = 0, sumAB = 0;
                    for (int y = top; y < top + windowY; y++)
                    {
                        for (int i = y * a.Width + left; i < y * a.Width + left + windowX; i++)
                        {
                            double va = lumaA[i], vb = lumaB[i];
                            sumA += va;
                            sumB += vb;
                            sumAA += va * va;
                            sumBB += vb * vb;
                            sumAB += va * vb;
                        }
                    }
                    double n = windowX * windowY;
                    double meanA = sumA / n, meanB = sumB / n;
                    double varianceA = sumAA / n - meanA * meanA, varianceB = sumBB / n - meanB * meanB;
                    double covariance = sumAB / n - meanA * meanB;
                    total += (2 * meanA * meanB + C1) * (2 * covariance + C2) /
                        ((meanA * meanA + meanB * meanB + C1) * (varianceA + varianceB + C2));
                    windows++;
                }
            }
            return total / windows;
        }

        static float[] Luma(RgbaImage image)
        {
            var luma = new float[image.Width * image.Height];
            for (int i = 0; i < luma.Length; i++)
                luma[i] = 0.2126f * image.Rgba[i * 4] + 0.7152f * image.Rgba[i * 4 + 1] + 0.0722f * image.Rgba[i * 4 + 2];
            return luma;
        }

        /// <summary>The share of differing pixels among those that either of two pictures of one size covers.</summary>
        /// <param name="maxPerChannel">Colours that differ by no more than this, in 255ths, count as equal.</param>
        /// <param name="covered">The number of pixels that either picture covers.</param>
        public static double ShareThatDiffers(in RgbaImage image, in RgbaImage other, uint background, out int covered,
            int maxPerChannel = 0)
        {
            int differ = 0;
            covered = 0;
            for (int y = 0; y < image.Height; y++)
            {
                for (int x = 0; x < image.Width; x++)
                {
                    uint a = image[x, y], b = other[x, y];
                    covered += a != background || b != background ? 1 : 0;
                    differ += IsNear(a, b, maxPerChannel) ? 0 : 1;
                }
            }
            return differ / (double)Math.Max(1, covered);
        }

        static bool IsNear(uint a, uint b, int maxPerChannel)
        {
            for (int shift = 0; shift < 32; shift += 8)
                if (Math.Abs((int)(a >> shift & 255) - (int)(b >> shift & 255)) > maxPerChannel)
                    return false;
            return true;
        }
    }
}
