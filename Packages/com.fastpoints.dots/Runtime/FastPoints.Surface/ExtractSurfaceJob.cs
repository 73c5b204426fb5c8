using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>A slice of rows of Surface Nets (Gibson 1998): a vertex in each cube of lattice points that the shell's
    /// surface passes, and two triangles across each edge that it cuts. Vertices are moved onto the surfels' plane, but for a
    /// hair on either side: what was a shell is a sheet with two faces, as high as the points. Slices run one after
    /// another.</summary>
    [BurstCompile]
    internal unsafe struct ExtractSurfaceJob : IJob
    {
        public const int RowsPerSlice = 20; // A slice of level ground, which lies in few layers, takes about a millisecond.
        internal const float HalfThickness = 0.1f; // From the plane to either face, in voxels.
        internal const float MaxFromSurfel = 0.9f; // A vertex is at most so far from the nearest surfel, in voxels.
        const int NearSide = 2 * SurfaceGrid.VertexReach + 1, MaxNear = NearSide * NearSide * NearSide;
        const float Radius = 2; // Surfels farther away do not move a vertex.
        public int First; // Rows of cubes, layer by layer, from those before the cell.
        public int End;
        public SurfaceGrid Grid;
        public SurfaceMemory Memory;
        public SliceTimes Times;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int rows = Grid.CellEdgeVoxels + 1;
            var near = stackalloc Surfel[MaxNear];
            for (int i = First; i < End; i++)
            {
                int row = i % rows, layer = i / rows;
                AddVertices(row, layer, near);
                // Cubes on all four sides of their edges have vertices now.
                if (row > 0 && layer > 0)
                    AddTriangles(row - 1, layer - 1);
            }
            Times.End(begin);
        }

        byte* InsideFlagsOfRow(int row, int layer) =>
            (byte*)Memory.IsInside.GetUnsafePtr() + Grid.SideWithMargins * RowAt(row, layer);

        int RowAt(int row, int layer) => row + Grid.SideWithMargins * layer;

        void AddVertices(int row, int layer, Surfel* near)
        {
            int before = Grid.Margin - 1, cubes = Grid.CellEdgeVoxels + 1;
            int y = before + row, z = before + layer;
            var isRowInside = (byte*)Memory.IsRowInside.GetUnsafePtr();
            var vertexOf = (int*)Memory.VertexNumberOfCube.GetUnsafePtr() + cubes * (row + cubes * layer);
            if ((isRowInside[RowAt(y, z)] | isRowInside[RowAt(y + 1, z)] | isRowInside[RowAt(y, z + 1)] |
                isRowInside[RowAt(y + 1, z + 1)]) == 0)
                return;
            byte* a = InsideFlagsOfRow(y, z) + before, b = InsideFlagsOfRow(y + 1, z) + before,
                c = InsideFlagsOfRow(y, z + 1) + before, d = InsideFlagsOfRow(y + 1, z + 1) + before;
            int right = a[0] | b[0] << 2 | c[0] << 4 | d[0] << 6;
            for (int x = 0; x < cubes; x++)
            {
                int left = right;
                right = a[x + 1] | b[x + 1] << 2 | c[x + 1] << 4 | d[x + 1] << 6;
                // Bit 0 of a corner's number is its x, bit 1 its y, bit 2 its z.
                int corners = left | right << 1;
                if (corners == 0 || corners == 255)
                    continue;
                var place = new int3(before + x, y, z);
                var steps = (int3)math.round(PositionOfVertex(corners, place, near) * SurfaceGrid.StepsPerVoxel);
                Memory.Vertices.Add((place + -Grid.Margin) * SurfaceGrid.StepsPerVoxel + steps);
                vertexOf[x] = Memory.Vertices.Length;
            }
        }

        /// <summary>Counted from the cube's corner, in voxels.</summary>
        float3 PositionOfVertex(int corners, int3 place, Surfel* near)
        {
            const int reach = SurfaceGrid.VertexReach;
            int side = Grid.SideWithMargins, count = 0, nearest = 0;
            var middle = MiddleOfCuts(corners);
            float closest = float.MaxValue;
            var surfelOf = (int*)Memory.SurfelOf.GetUnsafePtr() + place.x + side * (place.y + side * place.z);
            var surfels = Memory.Surfels.GetUnsafePtr();
            for (int z = -reach; z <= reach; z++)
                for (int y = -reach; y <= reach; y++)
                {
                    var row = surfelOf + side * (y + side * z);
                    // Most rows are empty.
                    if ((row[-2] | row[-1] | row[0] | row[1] | row[2]) == 0)
                        continue;
                    for (int x = -reach; x <= reach; x++)
                    {
                        int number = row[x];
                        if (number <= 0)
                            continue;
                        var offset = surfels[number - 1].Position + new float3(x, y, z) - middle;
                        float square = math.lengthsq(offset);
                        if (square >= Radius * Radius)
                            continue;
                        if (square < closest)
                        {
                            closest = square;
                            nearest = count;
                        }
                        near[count++] = new Surfel { Position = offset, Normal = surfels[number - 1].Normal };
                    }
                }
            return count == 0 ? middle : middle + WayToPlane(near, count, near[nearest]);
        }

        /// <summary>To the plane through the surfels that face as the nearest one does.</summary>
        static float3 WayToPlane(Surfel* near, int count, in Surfel nearest)
        {
            float3 normal = default, mean = default;
            float weights = 0;
            for (int i = 0; i < count; i++)
            {
                float weight = 1 - math.lengthsq(near[i].Position) * (1 / (Radius * Radius));
                float cosine = math.dot(near[i].Normal, nearest.Normal);
                weight *= weight * cosine * cosine;
                // Other walls, on the far side of a gap.
                if (math.abs(math.dot(near[i].Position - nearest.Position, nearest.Normal)) > 1)
                    continue;
                weights += weight;
                mean += weight * near[i].Position;
                normal += weight * (cosine < 0 ? -near[i].Normal : near[i].Normal);
            }
            if (!(weights > 0))
                return default;
            normal = math.normalize(normal);
            float height = math.dot(normal, mean) / weights;
            var way = normal * (height + (height > 0 ? -HalfThickness : HalfThickness));
            float distance = math.distance(way, nearest.Position);
            return distance <= MaxFromSurfel ? way : nearest.Position + (way - nearest.Position) * (MaxFromSurfel / distance);
        }

        /// <summary>The mean of the middles of the edges whose ends differ.</summary>
        static float3 MiddleOfCuts(int corners)
        {
            // Edges along each axis, as bits of the corners that they begin at.
            uint all = (uint)corners, x = (all ^ all >> 1) & 0x55, y = (all ^ all >> 2) & 0x33, z = (all ^ all >> 4) & 0x0F;
            int alongX = math.countbits(x), alongY = math.countbits(y), alongZ = math.countbits(z);
            return new float3(0.5f * alongX + math.countbits(y & 0xAA) + math.countbits(z & 0xAA),
                0.5f * alongY + math.countbits(x & 0xCC) + math.countbits(z & 0xCC),
                0.5f * alongZ + math.countbits(x & 0xF0) + math.countbits(y & 0xF0)) / (alongX + alongY + alongZ);
        }

        /// <summary>Across the edges from a row of the cell's lattice points, of a layer whose cubes have vertices.</summary>
        void AddTriangles(int row, int layer)
        {
            int side = Grid.SideWithMargins, cubes = Grid.CellEdgeVoxels + 1, margin = Grid.Margin;
            int y = margin + row, z = margin + layer;
            var isRowInside = (byte*)Memory.IsRowInside.GetUnsafePtr();
            if ((isRowInside[RowAt(y, z)] | isRowInside[RowAt(y + 1, z)] | isRowInside[RowAt(y, z + 1)]) == 0)
                return;
            byte* here = InsideFlagsOfRow(y, z) + margin, above = here + side, behind = here + side * side;
            // The cube that begins at the lattice point; those before it along an axis lie a stride back.
            var cube = (int*)Memory.VertexNumberOfCube.GetUnsafePtr() + 1 + cubes * (row + 1 + cubes * (layer + 1));
            int alongY = cubes, alongZ = cubes * cubes;
            for (int x = 0; x < Grid.CellEdgeVoxels; x++, cube++)
            {
                if (here[x] != here[x + 1])
                    AddQuad(cube, alongY, alongZ, here[x] != 0);
                if (here[x] != above[x])
                    AddQuad(cube, alongZ, 1, here[x] != 0);
                if (here[x] != behind[x])
                    AddQuad(cube, 1, alongY, here[x] != 0);
            }
        }

        void AddQuad(int* cube, int u, int v, bool isOutsideBehind)
        {
            int a = cube[-u - v] - 1, b = cube[-v] - 1, c = cube[0] - 1, d = cube[-u] - 1;
            if (!isOutsideBehind)
                (b, d) = (d, b);
            var at = Memory.Vertices.GetUnsafePtr();
            // Along the shorter of its diagonals; of equal ones along the first.
            if (SquareOf(at[a] - at[c]) <= SquareOf(at[b] - at[d]))
            {
                AddTriangle(at, new int3(a, b, c));
                AddTriangle(at, new int3(a, c, d));
                return;
            }
            AddTriangle(at, new int3(b, c, d));
            AddTriangle(at, new int3(b, d, a));
        }

        /// <summary>Unless two of its vertices have moved to one place.</summary>
        void AddTriangle(int3* at, int3 triangle)
        {
            int3 a = at[triangle.x], b = at[triangle.y], c = at[triangle.z];
            if (!a.Equals(b) && !b.Equals(c) && !c.Equals(a))
                Memory.Triangles.Add(triangle);
        }

        static long SquareOf(int3 steps) => (long)steps.x * steps.x + (long)steps.y * steps.y + (long)steps.z * steps.z;
    }
}
