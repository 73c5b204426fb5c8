using Unity.Mathematics;

namespace FastPoints.Picture
{
    // Chooses the point sizes at which a picture's surfaces look closed, for each tile of 8 by 8 pixels: dense points stay
    // sharp, sparse ones grow.
    internal static class PointSizing
    {
        public const int TileEdgePx = 8;
        public const int PixelsPerTile = TileEdgePx * TileEdgePx;
        public const float MinPx = 1;

        // For pictures of few points, which would be lost otherwise; the others have half of that.
        public const float MaxPx = 12;

        // With a smaller share of a picture's pixels drawn by points of one pixel, sizes may exceed half of MaxPx.
        const float FewPixels = 0.02f;

        // How many points should cover a pixel on average: exp(-3.5) = 3 % of random pixels stay empty.
        const double PointsPerPixel = 3.5;

        // Times the median tile's size at most: beyond that, outliers would turn into blocks.
        const float MaxTypicalFactor = 1.5f;

        public static int TilesAlong(int edgePx) => (edgePx + TileEdgePx - 1) / TileEdgePx;

        // From 1 to 12 pixels: squares of size s, at a density of d points a pixel, cover each pixel d * s^2 times.
        public static float SizeFor(double density) => (float)math.clamp(math.sqrt(PointsPerPixel / density), MinPx, MaxPx);

        // Of the median tile, by its density and the share of the picture's pixels that were drawn.
        public static float TypicalFor(double density, float drawn) => math.min(SizeFor(density),
            math.clamp(MaxPx / 2 * math.sqrt(FewPixels / math.max(1e-9f, drawn)), MaxPx / 2, MaxPx));

        // Points a pixel, hidden ones included, in a tile with this many drawn pixels: random points with a density of d cover
        // 1 - exp(-d) of them. A full tile counts as one with half a pixel missing.
        public static double DensityOf(int pixelsDrawn) =>
            -math.log(1 - math.min(pixelsDrawn, PixelsPerTile - 0.5) / PixelsPerTile);

        // How far eye-dome lighting looks around a point, in whole pixels.
        public static uint RadiusOf(float sizePx) => (uint)math.max(1, (int)(sizePx * 0.5f + 0.5f));

        public static float Limit(float size, float typical) =>
            math.clamp(size, MinPx, math.min(math.max(MaxPx / 2, typical), MaxTypicalFactor * typical + 1));
    }
}
