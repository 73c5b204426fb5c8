using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // Chooses the point size in each tile from a picture drawn with points of one pixel.
    [BurstCompile]
    internal struct ChooseSizesJob : IJob
    {
        const int TileEdgePx = PointSizing.TileEdgePx;

        [ReadOnly] public NativeArray<ulong> Pixels;
        public int WidthPx;
        public int HeightPx;

        // The final picture has this many times as many points.
        public double PointsPerPointDrawn;

        // Row by row from the top.
        public NativeArray<float> SizeOfTile;

        // Of the median tile among those with points.
        public NativeReference<float> Typical;

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
}
