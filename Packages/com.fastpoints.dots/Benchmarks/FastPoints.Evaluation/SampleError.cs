using System;
using FastPoints.Picture;

namespace FastPoints.Evaluation
{
    public sealed class SampleError
    {
        public int Points;

        /// <summary>Sampled share of the full cloud, 0 to 1.</summary>
        public double Fraction;

        /// <summary>In units of the diagonal of the full cloud's robust bounds.</summary>
        public DistanceError Distance;

        public CellError Cells;
        internal ImageError Picture;

        /// <summary>The same against the views of a uniform sample of as many points; null if there was none.</summary>
        internal ImageError? PictureAtSameCount;

        public RgbaImage[] Views;
        public int LookedUp;
        public int Found;

        /// <summary>One error for several pictures: their squared errors averaged for the PSNR, the mean of SSIM, of FLIP and
        /// of the share of pixels left uncovered.</summary>
        internal static ImageError Mean(RgbaImage[] pictures, RgbaImage[] references, uint background)
        {
            var mean = new ImageError();
            double squares = 0;
            for (int i = 0; i < pictures.Length; i++)
            {
                var error = ImageError.Compare(pictures[i], references[i], background);
                squares += Math.Pow(10, -error.Psnr / 10) / pictures.Length;
                mean.Ssim += error.Ssim / pictures.Length;
                mean.Flip += error.Flip / pictures.Length;
                mean.Uncovered += error.Uncovered / pictures.Length;
            }
            mean.Psnr = squares == 0 ? double.PositiveInfinity : -10 * Math.Log10(squares);
            return mean;
        }
    }
}
