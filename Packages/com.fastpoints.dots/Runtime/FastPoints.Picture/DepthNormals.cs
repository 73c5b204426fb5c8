using FastPoints.Drawing;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // Normals of a picture's surfaces, from its depths.
    internal struct DepthNormals
    {
        [ReadOnly] public NativeArray<ulong> Pixels;
        public int WidthPx;
        public int HeightPx;
        public PixelPlaces Places;

        // Faces the viewer; 0 for a pixel that has no neighbour beside it, or none above or below.
        public readonly float3 NormalAt(int x, int y, ulong pixel)
        {
            float depth = PointProjection.DepthFromBits((uint)(pixel >> 32));
            int radius = PointDrawing.RadiusOf(pixel);
            var place = Places.Of(x, y, depth);
            var across = Along(x, y, new int2(radius, 0), depth, place);
            var down = Along(x, y, new int2(0, radius), depth, place);
            var normal = math.normalizesafe(math.cross(across, down));
            return math.dot(normal, Places.IsOrthographic ? Places.Forward : place) > 0 ? -normal : normal;
        }

        // Of the neighbours to either side the one that differs less in depth.
        readonly float3 Along(int x, int y, int2 step, float depth, float3 place)
        {
            var best = float3.zero;
            float least = float.PositiveInfinity;
            for (int side = 1; side >= -1; side -= 2)
            {
                int besideX = x + side * step.x, besideY = y + side * step.y;
                if (besideX < 0 || besideY < 0 || besideX >= WidthPx || besideY >= HeightPx)
                    continue;
                ulong beside = Pixels[besideY * WidthPx + besideX];
                if (beside == PointDrawing.EmptyPixel)
                    continue;
                float there = PointProjection.DepthFromBits((uint)(beside >> 32));
                if (math.abs(there - depth) >= least)
                    continue;
                least = math.abs(there - depth);
                best = (Places.Of(besideX, besideY, there) - place) * side;
            }
            return best;
        }
    }
}
