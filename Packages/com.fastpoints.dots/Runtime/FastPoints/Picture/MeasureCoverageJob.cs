using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    /// <summary>
    /// How closely a picture is covered: for tiles of 8 by 8 pixels, the number of tiles with so many pixels drawn.
    /// </summary>
    [BurstCompile]
    public struct MeasureCoverageJob : IJob
    {
        public const int TileEdgePx = 8;

        /// <summary>Entries of <see cref="TilesByPixels"/>: 0 to 64 pixels.</summary>
        public const int Length = TileEdgePx * TileEdgePx + 1;

        [ReadOnly] public NativeArray<ulong> Pixels;
        public int WidthPx;
        public int HeightPx;
        public NativeArray<int> TilesByPixels;

        public void Execute()
        {
            for (int i = 0; i < Length; i++)
                TilesByPixels[i] = 0;
            for (int top = 0; top < HeightPx; top += TileEdgePx)
            {
                for (int left = 0; left < WidthPx; left += TileEdgePx)
                {
                    int drawn = 0;
                    for (int y = top; y < math.min(top + TileEdgePx, HeightPx); y++)
                        for (int x = left; x < math.min(left + TileEdgePx, WidthPx); x++)
                            drawn += Pixels[y * WidthPx + x] != PointDrawing.EmptyPixel ? 1 : 0;
                    TilesByPixels[drawn]++;
                }
            }
        }
    }
}
