using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    [BurstCompile]
    internal struct ChooseSizesJob : IJob
    {
        const int TileEdgePx = PointSizing.TileEdgePx;

        [ReadOnly] public NativeArray<ulong> Pixels;
        public int WidthPx;
        public int HeightPx;
        public double PointsPerPointDrawn; // The final picture has this many times as many points.
        public NativeArray<float> SizeOfTile; // Row by row from the top.
        public NativeReference<float> Typical; // Of the median tile among those with points.

        public void Execute()
        {
            int across = PointSizing.TilesAlong(WidthPx), down = PointSizing.TilesAlong(HeightPx);
            var drawn = new NativeArray<int>(across * down, Allocator.Temp);
            var tilesByPixels = new NativeArray<int>(PointSizing.PixelsPerTile + 1, Allocator.Temp);
            int pixelsDrawn = 0;
            for (int tile = 0; tile < drawn.Length; tile++)
            {
                pixelsDrawn += drawn[tile] = CountDrawn(tile % across, tile / across);
                tilesByPixels[drawn[tile]]++;
            }
            float typical = PointSizing.TypicalFor(PointSizing.DensityOf(MedianOf(tilesByPixels)) * PointsPerPointDrawn,
                pixelsDrawn / (float)Pixels.Length);
            Typical.Value = typical;
            for (int tile = 0; tile < drawn.Length; tile++)
            {
                double density = MeanDensity(drawn, tile % across, tile / across, across, down) * PointsPerPointDrawn;
                SizeOfTile[tile] = PointSizing.Limit(density > 0 ? PointSizing.SizeFor(density) : typical, typical);
            }
            tilesByPixels.Dispose();
            drawn.Dispose();
        }

        int CountDrawn(int tileX, int tileY)
        {
            int right = math.min((tileX + 1) * TileEdgePx, WidthPx), bottom = math.min((tileY + 1) * TileEdgePx, HeightPx);
            int count = 0;
            for (int y = tileY * TileEdgePx; y < bottom; y++)
                for (int x = tileX * TileEdgePx; x < right; x++)
                    count += Pixels[y * WidthPx + x] != PointDrawing.EmptyPixel ? 1 : 0;
            return count;
        }

        // Drawn in the median tile among those with any; those of a full tile if there is none.
        static int MedianOf(NativeArray<int> tilesByPixels)
        {
            int occupied = 0;
            for (int pixels = 1; pixels < tilesByPixels.Length; pixels++)
                occupied += tilesByPixels[pixels];
            int below = 0;
            for (int pixels = 1; pixels < tilesByPixels.Length; pixels++)
            {
                below += tilesByPixels[pixels];
                if (below * 2 > occupied)
                    return pixels;
            }
            return PointSizing.PixelsPerTile;
        }

        // Over those of a tile and its eight neighbours that have points, so that sizes change gently.
        static double MeanDensity(NativeArray<int> drawn, int tileX, int tileY, int across, int down)
        {
            double sum = 0;
            int tiles = 0;
            for (int y = math.max(0, tileY - 1); y <= math.min(down - 1, tileY + 1); y++)
            {
                for (int x = math.max(0, tileX - 1); x <= math.min(across - 1, tileX + 1); x++)
                {
                    int pixels = drawn[y * across + x];
                    if (pixels == 0)
                        continue;
                    sum += PointSizing.DensityOf(pixels);
                    tiles++;
                }
            }
            return tiles == 0 ? 0 : sum / tiles;
        }
    }

    // Chooses the point sizes at which a picture's surfaces look closed, for each tile of 8 by 8 pixels: dense points stay
    // sharp, sparse ones grow.
    internal static class PointSizing
    {
        public const int TileEdgePx = 8;
        public const int PixelsPerTile = TileEdgePx * TileEdgePx;
        public const float MinPx = 1;
        public const float MaxPx = 12; // For pictures of few points, which would be lost otherwise; half of it for others.

        // With a smaller share of a picture's pixels drawn by points of one pixel, sizes may exceed half of MaxPx.
        const float SparseShare = 0.02f;

        // How many points should cover a pixel on average: exp(-3.5) = 3 % of random pixels stay empty.
        const double PointsPerPixel = 3.5;

        // Times the median tile's size at most: beyond that, outliers would turn into blocks.
        const float MaxTypicalFactor = 1.5f;

        public static int TilesAlong(int edgePx) => (edgePx + TileEdgePx - 1) / TileEdgePx;

        // From 1 to 12 pixels: squares of size s, at a density of d points a pixel, cover each pixel d * s^2 times.
        public static float SizeFor(double density) => (float)math.clamp(math.sqrt(PointsPerPixel / density), MinPx, MaxPx);

        // Size for the median tile, by its density and the share of the picture's pixels that were drawn.
        public static float TypicalFor(double density, float drawn) => math.min(SizeFor(density),
            math.clamp(MaxPx / 2 * math.sqrt(SparseShare / math.max(1e-9f, drawn)), MaxPx / 2, MaxPx));

        // Points a pixel, hidden ones included, in a tile with this many drawn pixels: random points with a density of d cover
        // 1 - exp(-d) of them. A full tile counts as one with half a pixel missing.
        public static double DensityOf(int pixelsDrawn) =>
            -math.log(1 - math.min(pixelsDrawn, PixelsPerTile - 0.5) / PixelsPerTile);

        public static uint LightingRadiusOf(float sizePx) =>
            (uint)math.clamp((int)(sizePx * 0.5f + 0.5f), 1, PointDrawing.MaxRadiusPx);

        public static float Limit(float size, float typical) =>
            math.clamp(size, MinPx, math.min(math.max(MaxPx / 2, typical), MaxTypicalFactor * typical + 1));
    }
}
