using FastPoints.Drawing;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Picture
{
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
            int radius = PointDrawing.RadiusOf(pixel);
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
