using System;
using FastPoints.Drawing;
using FastPoints.Picture;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Evaluation
{
    /// <summary>The difference that an eye sees between two pictures shown in turn, pixel by pixel: 0 for none, 1 for the largest
    /// (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: a difference evaluator for alternating images",
    /// 2020, for low dynamic range). Alpha is not looked at.</summary>
    internal sealed class FlipMap
    {
        /// <summary>The paper's viewer: 0.7 m from a screen of 0.7 m and 3840 pixels across, 67.02 pixels per degree.</summary>
        public const double DefaultPixelsPerDegree = 0.7 * (3840 / 0.7) * (Math.PI / 180);

        public readonly int Width;
        public readonly int Height;
        public readonly float[] Errors; // Row by row from the top.

        public readonly double Mean;

        FlipMap(int width, int height, float[] errors, double mean)
        {
            (Width, Height, Errors, Mean) = (width, height, errors, mean);
        }

        /// <summary>Main thread.</summary>
        public static FlipMap Of(RgbaImage picture, RgbaImage reference, double pixelsPerDegree = DefaultPixelsPerDegree)
        {
            if (picture.Width != reference.Width || picture.Height != reference.Height)
                throw new ArgumentException("pictures of " + picture.Width + "x" + picture.Height + " and " +
                    reference.Width + "x" + reference.Height + " pixels have no common error");
            using var filters = new FlipFilters(pixelsPerDegree, Allocator.Persistent);
            using var pixels = new NativeArray<byte>(picture.Rgba, Allocator.Persistent);
            using var pixelsOfReference = new NativeArray<byte>(reference.Rgba, Allocator.Persistent);
            using var light = Palettes.CreateSrgbToLinear(Allocator.Persistent);
            int tiles = ComputeFlipJob.TileCount(picture.Width, picture.Height);
            using var errors = new NativeArray<float>(picture.Width * picture.Height, Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            using var sums = new NativeArray<double>(tiles, Allocator.Persistent);
            new ComputeFlipJob
            {
                Picture = pixels.Reinterpret<uint>(1),
                ReferencePicture = pixelsOfReference.Reinterpret<uint>(1),
                Width = picture.Width,
                Height = picture.Height,
                LightOfByte = light,
                Filters = filters,
                Errors = errors,
                SumOfTile = sums,
            }.ScheduleParallel(tiles, 1, default).Complete();
            double sum = 0;
            for (int tile = 0; tile < tiles; tile++)
                sum += sums[tile];
            return new FlipMap(picture.Width, picture.Height, errors.ToArray(), sum / errors.Length);
        }

        /// <summary>In the colours of magma: black for no difference, light yellow for the largest.</summary>
        public RgbaImage ToImage()
        {
            var image = new RgbaImage(Width, Height);
            for (int i = 0; i < Errors.Length; i++)
                image[i % Width, i / Width] = Magma(Math.Floor(Errors[i] * 255 + 0.5) / 255);
            return image;
        }

        // Magma (Smith and van der Walt, 2015): even steps from black to light yellow, as of Viridis; at most 5 of 255 off.
        public static uint Magma(double t)
        {
            double red = Palettes.Polynomial(t, -0.00213649, 0.25166054, 8.35371728, -27.66873309, 52.17613981, -50.76852537,
                18.65570507);
            double green = Palettes.Polynomial(t, -0.00074966, 0.67752324, -3.57771951, 14.26473078, -27.94360607, 29.04658282,
                -11.48977352);
            double blue = Palettes.Polynomial(t, -0.00538613, 2.49402660, 0.31446790, -13.64921319, 12.94416944, 4.23415299,
                -5.60196151);
            return Palettes.Pack(Palettes.ToByte(red), Palettes.ToByte(green), Palettes.ToByte(blue));
        }
    }
}
