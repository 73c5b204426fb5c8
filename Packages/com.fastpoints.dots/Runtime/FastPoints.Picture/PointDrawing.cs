using System.Runtime.CompilerServices;
using System.Threading;
using FastPoints.Drawing;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    /// <summary>
    /// How the points of one batch layout are drawn: projection, colours, size. Draws into pixels of 64 bits, depth above
    /// colour, of which the smallest wins:
    /// <code>
    /// bit 63 ............ 32  31 .. 24  23 .. 16  15 .. 8  7 .. 0
    ///     depth (ordered)   lit, radius  blue      green    red
    /// </code>
    /// (bits 31 .. 29 are the share that is lit, see PointLighting; 28 .. 24 half a point's size in pixels, how far lighting
    /// looks around it, at most 31) so that a picture depends on no order and on no number of threads; of two points at one
    /// depth the smaller colour stays. Blittable, for jobs.
    /// </summary>
    internal struct PointDrawing
    {
        public const ulong EmptyPixel = ulong.MaxValue;

        public const float MaxSizePx = 64;

        public const int RadiusBits = 5, MaxRadiusPx = (1 << RadiusBits) - 1;

        public PositionColumns Positions;
        public PointProjection Projection;
        public ColorMapping Colors;
        public float MaxTileSizePx; // A size of 1 is drawn faster.
        public bool IsWorldSize; // Whatever the tiles' sizes are.
        public PointSize Size;
        public bool IsRound;
        public int LitLevel; // Of PointLighting.MaxLitLevel; 0 for points that are lit by normals of their own.
        public PointNormals Normals;

        // Discs that bulge towards the camera: paraboloids whose rim is farther away by the radius than the middle, which has
        // the point's own depth. Each pixel of overlapping points goes to the nearest centre.
        public bool IsParaboloid;

        // Any number of threads may draw at once.
        public readonly unsafe void Draw(byte* bytes, int first, int count, in PictureMemory picture)
        {
            double* x = stackalloc double[ColumnValues.BatchLength];
            double* y = stackalloc double[ColumnValues.BatchLength];
            double* z = stackalloc double[ColumnValues.BatchLength];
            uint* colors = stackalloc uint[ColumnValues.BatchLength];
            var span = new PointSpan { X = x, Y = y, Z = z, Colors = colors };
            for (int done = 0; done < count; done += ColumnValues.BatchLength)
            {
                span.Count = math.min(ColumnValues.BatchLength, count - done);
                Positions.Load(bytes, first + done, span.Count, x, y, z);
                PointColoring.ColorBatch(bytes, first + done, Colors, picture.Palettes, span);
                if (Normals.LitLevel > 0)
                    Normals.LightColors(bytes, first + done, Projection, span);
                if (MaxTileSizePx <= 1 && picture.Sums == null)
                    DrawPixels(span, picture.Pixels);
                else
                    DrawSplats(span, picture, picture.Gaps == null ? null : picture.Gaps + done);
            }
        }

        readonly unsafe void DrawPixels(in PointSpan span, ulong* pixels)
        {
            double* x = span.X, y = span.Y, z = span.Z;
            uint* colors = span.Colors;
            int count = span.Count;
            int width = Projection.WidthPx;
            double widthPx = width, heightPx = Projection.HeightPx;
            for (int i = 0; i < count; i++)
            {
                if (!Projection.Project(x[i], y[i], z[i], out double xPx, out double yPx, out float depth))
                    continue;
                if (!(xPx >= 0 && xPx < widthPx && yPx >= 0 && yPx < heightPx))
                    continue;
                Lower(pixels + ((long)(int)yPx * width + (int)xPx), KeyOf(depth, 1, LitLevel, colors[i]));
            }
        }

        readonly unsafe void DrawSplats(in PointSpan span, in PictureMemory picture, float* gaps)
        {
            double* x = span.X, y = span.Y, z = span.Z;
            uint* colors = span.Colors;
            ulong* pixels = picture.Pixels, sums = picture.Sums;
            int count = span.Count;
            int width = Projection.WidthPx, height = Projection.HeightPx;
            int tilesAcross = PointSizing.TilesAlong(width);
            double maxHalf = MaxTileSizePx * 0.5;
            for (int i = 0; i < count; i++)
            {
                if (!Projection.Project(x[i], y[i], z[i], out double xPx, out double yPx, out float depth))
                    continue;
                if (!(xPx >= -maxHalf && xPx < width + maxHalf && yPx >= -maxHalf && yPx < height + maxHalf))
                    continue;
                float size;
                if (IsWorldSize)
                {
                    size = Size.ToPx(gaps == null ? 0 : gaps[i], (float)Projection.PixelsPerUnitAt(depth));
                }
                else
                {
                    int tileX = math.clamp((int)xPx, 0, width - 1) / PointSizing.TileEdgePx;
                    int tileY = math.clamp((int)yPx, 0, height - 1) / PointSizing.TileEdgePx;
                    size = picture.SizeOfTile[tileY * tilesAcross + tileX];
                }
                double half = size * 0.5;
                uint radiusPx = PointSizing.LightingRadiusOf(size);
                ulong key = KeyOf(depth, radiusPx, LitLevel, colors[i]);
                // Depth in world units behind the middle, for each squared pixel of distance: the radius at the rim.
                double behindPerSq = IsParaboloid ? 1 / (half * Projection.PixelsPerUnitAt(depth)) : 0;
                float nearest = sums == null ? 0
                    : (float)(depth - BlendedPixels.WindowOf(size, Projection.PixelsPerUnitAt(depth)));

                // Selects the pixels whose centres, at a half, lie within half a size: more than c - half, at most c + half.
                int left = math.max(0, (int)math.floor(xPx - half - 0.5) + 1);
                int right = math.min(width - 1, (int)math.floor(xPx + half - 0.5));
                int top = math.max(0, (int)math.floor(yPx - half - 0.5) + 1);
                int bottom = math.min(height - 1, (int)math.floor(yPx + half - 0.5));
                for (int row = top; row <= bottom; row++)
                {
                    double dy = row + 0.5 - yPx;
                    for (int column = left; column <= right; column++)
                    {
                        double dx = column + 0.5 - xPx;
                        double distanceSq = dx * dx + dy * dy;
                        if ((IsRound || IsParaboloid) && distanceSq > half * half)
                            continue;
                        long pixel = (long)row * width + column;
                        if (sums != null)
                        {
                            if (nearest <= PointProjection.DepthFromBits((uint)(pixels[pixel] >> 32)))
                                BlendedPixels.Add(sums + pixel * BlendedPixels.WordsPerPixel, colors[i],
                                    BlendedPixels.WeightOf(distanceSq / (half * half)));
                            continue;
                        }
                        if (IsParaboloid)
                            key = KeyOf((float)(depth + distanceSq * behindPerSq), radiusPx, LitLevel, colors[i]);
                        Lower(pixels + pixel, key);
                    }
                }
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ulong KeyOf(float depth, uint radiusPx, int litLevel, uint color) =>
            (ulong)PointProjection.DepthToBits(depth) << 32 | (uint)litLevel << 24 + RadiusBits | radiusPx << 24 |
            color & 0xFFFFFFu;

        public static int LightingRadiusOf(ulong key) => (int)(key >> 24) & MaxRadiusPx;

        public static int LitLevelOf(ulong key) => (int)(key >> 24 + RadiusBits) & PointLighting.MaxLitLevel;

        // Keeps the smaller of two values while other threads write. Pixels only ever fall, so a value read too early costs one
        // more round; the plain read is atomic on 64-bit processors.
        static unsafe void Lower(ulong* pixel, ulong key)
        {
            ulong seen = *pixel;
            while (key < seen)
            {
                ulong was = (ulong)Interlocked.CompareExchange(ref *(long*)pixel, (long)key, (long)seen);
                if (was == seen)
                    return;
                seen = was;
            }
        }
    }
    internal unsafe struct PictureMemory
    {
        public uint* Palettes;

        // At least 1: the edge of a point's square or the diameter of its disc. Pixels whose centres lie in it are drawn.
        public float* SizeOfTile;
        public ulong* Pixels;
        public float* Gaps; // Of the points from the first on; null if no size is adaptive.
        public ulong* Sums; // Null to draw; once all is drawn, the points are added up here (BlendedPixels).

        public PictureMemory(NativeArray<uint> palettes, NativeArray<float> sizeOfTile, NativeArray<ulong> pixels)
        {
            Palettes = (uint*)palettes.GetUnsafeReadOnlyPtr();
            SizeOfTile = (float*)sizeOfTile.GetUnsafeReadOnlyPtr();
            // Other jobs may write to it.
            Pixels = (ulong*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(pixels);
            Gaps = null;
            Sums = null;
        }
    }
}
