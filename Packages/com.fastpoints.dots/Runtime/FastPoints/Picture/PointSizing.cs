using System;
using Unity.Collections;

namespace FastPoints.Picture
{
    /// <summary>The point size at which a picture's surfaces look closed.</summary>
    public static class PointSizing
    {
        public const float MinPx = 1;
        public const float MaxPx = 6;

        /// <summary>Tiles that are more thinly covered than the chosen one keep their gaps: edges, and strays.</summary>
        const double ThinTileShare = 0.3;

        /// <summary>Points that should cover a pixel, on average: exp(-2.5) = 8 % of random pixels stay empty.</summary>
        const double PointsPerPixel = 2.5;

        /// <summary>
        /// From a picture drawn with points of one pixel. Random points with a density of d a pixel cover 1 - exp(-d) of the
        /// pixels, which gives d for each tile, hidden points included; squares of size s have a density of d * s^2.
        /// </summary>
        /// <param name="tilesByPixels">What <see cref="MeasureCoverageJob"/> found.</param>
        /// <param name="pointsPerPointDrawn">How many times as many points the final picture has.</param>
        /// <returns>Size in pixels, from <see cref="MinPx"/> to <see cref="MaxPx"/>.</returns>
        public static float Choose(NativeArray<int> tilesByPixels, double pointsPerPointDrawn)
        {
            long tiles = 0;
            for (int pixels = 1; pixels < tilesByPixels.Length; pixels++)
                tiles += tilesByPixels[pixels];
            if (tiles == 0)
                return MinPx;

            long thinner = 0;
            int chosen = 1;
            for (int pixels = 1; pixels < tilesByPixels.Length && thinner <= tiles * ThinTileShare; pixels++)
            {
                thinner += tilesByPixels[pixels];
                chosen = pixels;
            }
            int all = tilesByPixels.Length - 1;
            double covered = Math.Min(chosen, all - 0.5) / all;
            double density = -Math.Log(1 - covered) * pointsPerPointDrawn;
            return (float)Math.Min(MaxPx, Math.Max(MinPx, Math.Sqrt(PointsPerPixel / density)));
        }
    }
}
