using FastPoints.Drawing;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // Turns depth and colour into the picture's colours; index i is row i. Optionally applies eye-dome lighting (Boucheny,
    // "Interactive scientific visualization of large datasets", 2009, ch. 2): a pixel is darkened by how far the eight pixels
    // around it lie before it. Depth differences are taken in pixels (depth over the size of a pixel at that depth), so that
    // the shading is the same for any unit, scale and field of view. Neighbours are looked at half a point's size away. The
    // shading multiplies the encoded sRGB values, so light falls with its power of 2.2. Points that are lit get their light
    // first, by the normal that depths around them show.
    [BurstCompile]
    internal struct ResolvePictureJob : IJobFor
    {
        // A neighbour farther in front counts as this far, so that an outline is dark, not black.
        const float MaxDifferencePx = 12;

        [ReadOnly] public NativeArray<ulong> Pixels;

        // See BlendedPixels; empty if points were not blended.
        [ReadOnly, NativeDisableContainerSafetyRestriction] public NativeArray<ulong> Sums;
        public PointProjection Projection;
        public uint Background; // Of pixels without a point: bytes red, green, blue, alpha from the lowest.
        public float EdlStrength; // 0 turns eye-dome lighting off.
        public PointLighting Light; // Of the points that are lit.
        public PixelPositions PixelPositions;

        // A canvas of its own, which nothing draws into any more.
        [NativeDisableContainerSafetyRestriction] public ShadowMap Shadows;

        // Fills a pixel without a point, most of whose neighbours have one, with their mean: a gap in a surface.
        public bool FillsHoles;
        public const int MinAroundHole = 6; // At the edge of a surface there are three to five among the eight neighbours.

        [NativeDisableParallelForRestriction] public NativeArray<uint> Colors;

        public void Execute(int index)
        {
            int width = Projection.WidthPx;
            int row = index * width;
            for (int x = 0; x < width; x++)
            {
                ulong pixel = PixelAt(row + x);
                if (pixel == PointDrawing.EmptyPixel && FillsHoles)
                    pixel = Fill(x, index);
                if (pixel == PointDrawing.EmptyPixel)
                    Colors[row + x] = Background;
                else
                    Colors[row + x] = Darken(Lit(x, index, pixel), EdlStrength > 0 ? Shade(x, index, pixel) : 1);
            }
        }

        ulong PixelAt(int index)
        {
            ulong pixel = Pixels[index];
            if (Sums.Length == 0 || pixel == PointDrawing.EmptyPixel)
                return pixel;
            index *= BlendedPixels.WordsPerPixel;
            return pixel & ~0xFFFFFFul | BlendedPixels.ColorOf(Sums[index], Sums[index + 1], (uint)pixel & 0xFFFFFF);
        }

        // As a point of one pixel would, or leaves the pixel empty.
        ulong Fill(int x, int y)
        {
            int count = 0;
            int litLevel = 0;
            float depth = 0;
            uint3 color = 0;
            for (int ny = math.max(0, y - 1); ny <= math.min(Projection.HeightPx - 1, y + 1); ny++)
            {
                for (int nx = math.max(0, x - 1); nx <= math.min(Projection.WidthPx - 1, x + 1); nx++)
                {
                    ulong pixel = PixelAt(ny * Projection.WidthPx + nx);
                    if (pixel == PointDrawing.EmptyPixel)
                        continue;
                    count++;
                    litLevel += PointDrawing.LitLevelOf(pixel);
                    depth += PointProjection.DepthFromBits((uint)(pixel >> 32));
                    color += new uint3((uint)pixel & 255, (uint)pixel >> 8 & 255, (uint)pixel >> 16 & 255);
                }
            }
            if (count < MinAroundHole)
                return PointDrawing.EmptyPixel;
            color = (color + (uint)count / 2) / (uint)count;
            litLevel = (litLevel + count / 2) / count;
            return PointDrawing.KeyOf(depth / count, 1, litLevel, color.x | color.y << 8 | color.z << 16);
        }

        float Shade(int x, int y, ulong pixel)
        {
            float depth = PointProjection.DepthFromBits((uint)(pixel >> 32));
            int radiusPx = PointDrawing.LightingRadiusOf(pixel);
            float pixelsPerUnit = (float)Projection.PixelsPerUnitAt(depth) / radiusPx;
            float sum = 0;
            for (int dy = -1; dy <= 1; dy++)
            {
                int ny = y + dy * radiusPx;
                if (ny < 0 || ny >= Projection.HeightPx)
                    continue;
                for (int dx = -1; dx <= 1; dx++)
                {
                    int nx = x + dx * radiusPx;
                    if (nx < 0 || nx >= Projection.WidthPx)
                        continue;
                    ulong neighbour = Pixels[ny * Projection.WidthPx + nx];
                    if (neighbour == PointDrawing.EmptyPixel)
                        continue;
                    float before = (depth - PointProjection.DepthFromBits((uint)(neighbour >> 32))) * pixelsPerUnit;
                    sum += math.clamp(before, 0, MaxDifferencePx);
                }
            }
            return math.exp(-EdlStrength * sum / 8);
        }

        // 255ths of sRGB.
        float3 Lit(int x, int y, ulong pixel)
        {
            var color = new float3((uint)pixel & 255, (uint)pixel >> 8 & 255, (uint)pixel >> 16 & 255);
            int litLevel = PointDrawing.LitLevelOf(pixel);
            if (litLevel == 0)
                return color;
            var around = new DepthNormals
            {
                Pixels = Pixels,
                WidthPx = Projection.WidthPx,
                HeightPx = Projection.HeightPx,
                PixelPositions = PixelPositions,
            };
            var place = PixelPositions.Of(x, y, PointProjection.DepthFromBits((uint)(pixel >> 32)));
            var normal = around.NormalAt(x, y, pixel);
            float facing = PointLighting.Facing(normal, Light.Direction);
            return 255 * Light.Lit(color / 255, litLevel, normal, place, facing > 0 ? Shadows.At(place, facing) : 1);
        }

        static uint Darken(float3 color, float shade)
        {
            color = color * shade + 0.5f;
            return (uint)color.x | (uint)color.y << 8 | (uint)color.z << 16 | 0xFF000000u;
        }
    }

    internal struct DepthNormals
    {
        [ReadOnly] public NativeArray<ulong> Pixels;
        public int WidthPx;
        public int HeightPx;
        public PixelPositions PixelPositions;

        // Faces the viewer; 0 for a pixel that has no neighbour beside it, or none above or below.
        public readonly float3 NormalAt(int x, int y, ulong pixel)
        {
            float depth = PointProjection.DepthFromBits((uint)(pixel >> 32));
            int radius = PointDrawing.LightingRadiusOf(pixel);
            var place = PixelPositions.Of(x, y, depth);
            var across = Along(x, y, new int2(radius, 0), depth, place);
            var down = Along(x, y, new int2(0, radius), depth, place);
            var normal = math.normalizesafe(math.cross(across, down));
            return math.dot(normal, PixelPositions.IsOrthographic ? PixelPositions.Forward : place) > 0 ? -normal : normal;
        }

        // The mean of the ways to the neighbours on either side, each weighed by how little it differs in depth: on a surface
        // both, which averages the noise of points; at its edge the one that lies on it.
        readonly float3 Along(int x, int y, int2 step, float depth, float3 place)
        {
            float3 sum = 0;
            float edge = math.max(step.x, step.y) * (PixelPositions.IsOrthographic ? 1 : depth);
            float pixel = math.lengthsq(PixelPositions.StepX) * edge * edge;
            for (int side = 1; side >= -1; side -= 2)
            {
                int nextX = x + side * step.x, nextY = y + side * step.y;
                if (nextX < 0 || nextY < 0 || nextX >= WidthPx || nextY >= HeightPx)
                    continue;
                ulong next = Pixels[nextY * WidthPx + nextX];
                if (next == PointDrawing.EmptyPixel)
                    continue;
                float there = PointProjection.DepthFromBits((uint)(next >> 32));
                float between = there - depth;
                sum += (PixelPositions.Of(nextX, nextY, there) - place) * (side / (pixel + between * between));
            }
            return sum * pixel;
        }
    }
}
