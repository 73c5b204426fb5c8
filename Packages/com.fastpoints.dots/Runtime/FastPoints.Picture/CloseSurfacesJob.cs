using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // Enlarges the points of a thin sample where they do not close the surface in front: points drawn through its gaps make a
    // tile's pixels look denser than that surface is.
    [BurstCompile]
    internal struct CloseSurfacesJob : IJob
    {
        // Share of the face of its cube that the points of a cell cover: a surface crosses few cells as a whole. Found by trial
        // on ca13_d and lion: larger values leave fewer pixels bare and blur more.
        const double ShareOfFace = 0.35;

        [ReadOnly] public NativeArray<SparseCell> Cells;
        public PointProjection Projection;
        public float TypicalPx; // Of the median tile.
        public NativeArray<float> SizeOfTile; // Row by row from the top; sizes never become smaller.

        public void Execute()
        {
            int across = PointSizing.TilesAlong(Projection.WidthPx), down = PointSizing.TilesAlong(Projection.HeightPx);
            var depths = new NativeArray<float>(across * down, Allocator.Temp);
            var sizes = new NativeArray<float>(across * down, Allocator.Temp);
            for (int tile = 0; tile < depths.Length; tile++)
                depths[tile] = float.PositiveInfinity;
            for (int i = 0; i < Cells.Length; i++)
            {
                var cell = Cells[i];
                if (!Projection.Project(cell.Center.x, cell.Center.y, cell.Center.z, out double x, out double y, out float depth))
                    continue;
                double edgePx = cell.Edge * (Projection.IsOrthographic ? Projection.ScalePx : Projection.ScalePx / depth);
                if (math.abs(x - Projection.WidthPx * 0.5) > (Projection.WidthPx + edgePx) / 2
                    || math.abs(y - Projection.HeightPx * 0.5) > (Projection.HeightPx + edgePx) / 2)
                    continue;
                float size = PointSizing.SizeFor(cell.PointsDrawn / (edgePx * edgePx * ShareOfFace));
                int left = TileAt(x - edgePx / 2, across), right = TileAt(x + edgePx / 2, across);
                int top = TileAt(y - edgePx / 2, down), bottom = TileAt(y + edgePx / 2, down);
                for (int tileY = top; tileY <= bottom; tileY++)
                {
                    for (int tile = tileY * across + left; tile <= tileY * across + right; tile++)
                    {
                        if (depth >= depths[tile])
                            continue;
                        depths[tile] = depth;
                        sizes[tile] = size;
                    }
                }
            }
            for (int tile = 0; tile < sizes.Length; tile++)
                if (sizes[tile] > 0)
                    SizeOfTile[tile] = math.max(SizeOfTile[tile], PointSizing.Limit(sizes[tile], TypicalPx));
            depths.Dispose();
            sizes.Dispose();
        }

        // The last tile for pixels beyond the picture's edge.
        static int TileAt(double px, int tiles) => (int)math.clamp(px / PointSizing.TileEdgePx, 0, tiles - 1);
    }

    // A cell of a cloud, and how many points of it are drawn.
    internal struct SparseCell
    {
        public double3 Center;

        public double Edge;

        public double PointsDrawn;
    }
}
