using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using FastPoints.Nodes;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>Maps positions to chunks: a cube in 8^<see cref="Levels"/> cells in Morton order, and the chunk of each, or of
    /// each of its subcells if many points lie in one cell. Chunks are cubes of the octree; positions outside the cube have
    /// a chunk of their own, the last one.</summary>
    internal sealed class PartitionMap : IDisposable
    {
        public const int MaxLevels = 6; // 8^6 cells are 1 MB: they stay in a core's cache while points are sorted into them.
        const int MaxSubcellLevels = 2; // For cells that need them.
        const double ErrorsAllowed = 2; // How many standard errors above its estimate a chunk may have before it must be split.

        NativeArray<int> m_chunkOfCell;
        readonly int m_subcellLevels;

        /// <param name="subcellLevels">Of cells that have some.</param>
        /// <param name="chunkOfCell">Owned.</param>
        public PartitionMap(GridCube cube, int levels, int subcellLevels, NativeArray<int> chunkOfCell, GridCube[] chunks)
        {
            Cube = cube;
            Levels = levels;
            m_subcellLevels = subcellLevels;
            Chunks = chunks;
            m_chunkOfCell = chunkOfCell;
        }

        public GridCube Cube { get; }
        public int Levels { get; }

        public GridCube[] Chunks { get; } // The chunks' cubes, in Morton order; they fill the cube.

        public int OutsideChunk => Chunks.Length;

        public GridCube[] BaseCells { get; set; } // See BaseCells: those of the cube, in Morton order.

        public double[] PointsOfBaseCell { get; set; } // Estimates, by base cell.

        public ulong SampleHash { get; set; }

        /// <summary>Indexed by Morton number of the cell; ~i: its subcells' chunks begin at i, in Morton order.</summary>
        public NativeArray<int> ChunkOfCell => m_chunkOfCell;

        public ChunkFinder Finder => new ChunkFinder(new CellFinder(Cube, Levels), m_subcellLevels, OutsideChunk);

        /// <summary>The number of levels of cells that a cube of this side can have.</summary>
        public static int LevelsFor(int sideLog2, int wanted) => Math.Min(wanted, sideLog2);

        /// <summary>Plans cubes with at most <paramref name="target"/> points by the counts, as large as possible, down to single
        /// cells.</summary>
        /// <param name="pointsOfCell">Points of each cell by its Morton number: counted, or estimated from a sample.</param>
        public static PartitionMap Plan(GridCube cube, int levels, NativeArray<long> pointsOfCell, long target)
        {
            var chunkOfCell = new NativeArray<int>(pointsOfCell.Length, Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            var before = new long[pointsOfCell.Length + 1];
            for (int i = 0; i < pointsOfCell.Length; i++)
                before[i + 1] = before[i] + pointsOfCell[i];
            var chunks = new List<GridCube>();
            Descend(cube, 0, pointsOfCell.Length);
            return new PartitionMap(cube, levels, 0, chunkOfCell, chunks.ToArray());

            void Descend(GridCube part, int first, int count)
            {
                if (count == 1 || before[first + count] - before[first] <= target)
                {
                    for (int i = first; i < first + count; i++)
                        chunkOfCell[i] = chunks.Count;
                    chunks.Add(part);
                    return;
                }
                for (int octant = 0; octant < 8; octant++)
                    Descend(part.Child(octant), first + octant * (count / 8), count / 8);
            }
        }

        /// <summary>Plans cubes with at most <paramref name="target"/> points by an estimate, as large as possible, down to its
        /// cells; smaller ones if it is so uncertain that they might have twice as many.</summary>
        /// <param name="density">The estimate for the same cube.</param>
        public static PartitionMap Plan(GridCube cube, DensityTree density, long target)
        {
            int levels = LevelsFor(cube.SideLog2, MaxLevels);
            int subcellLevels = LevelsFor(cube.SideLog2 - levels, MaxSubcellLevels);
            using var chunkOfCell = new NativeList<int>(1 << 3 * levels, Allocator.Persistent);
            chunkOfCell.ResizeUninitialized(1 << 3 * levels);
            var chunks = new List<GridCube>();
            Descend(cube, 0, 0, DensityNumbers.Root);
            return new PartitionMap(cube, levels, subcellLevels,
                new NativeArray<int>(chunkOfCell.AsArray(), Allocator.Persistent),
                chunks.ToArray());

            // The cube's cells, or subcells, begin at first.
            void Descend(GridCube part, int level, int first, int cell)
            {
                bool isOfCells = level <= levels;
                int count = 1 << 3 * (isOfCells ? levels - level : levels + subcellLevels - level);
                int below = density.FirstChildOf(cell);
                if (below < 0 || level == levels + subcellLevels || Fits(density[cell], target))
                {
                    var cells = chunkOfCell.AsArray();
                    for (int i = first; i < first + count; i++)
                        cells[i] = chunks.Count;
                    chunks.Add(part);
                    return;
                }
                if (level == levels)
                {
                    chunkOfCell.ElementAt(first) = ~chunkOfCell.Length;
                    first = chunkOfCell.Length;
                    count = 1 << 3 * subcellLevels;
                    chunkOfCell.ResizeUninitialized(first + count);
                }
                for (int octant = 0; octant < 8; octant++)
                    Descend(part.Child(octant), level + 1, first + octant * (count / 8), below + octant);
            }
        }

        /// <summary>The largest cubes with at most <paramref name="target"/> points by the estimate, however
        /// uncertain.</summary>
        public static GridCube[] BaseCellsOf(GridCube cube, DensityTree density, long target, out double[] points)
        {
            var cells = new List<GridCube>();
            var estimates = new List<double>();
            Descend(cube, DensityNumbers.Root);
            points = estimates.ToArray();
            return cells.ToArray();

            void Descend(GridCube part, int cell)
            {
                int below = density.FirstChildOf(cell);
                if (below < 0 || part.SideLog2 == 0 || density[cell].Points <= target)
                {
                    cells.Add(part);
                    estimates.Add(density[cell].Points);
                    return;
                }
                for (int octant = 0; octant < 8; octant++)
                    Descend(part.Child(octant), below + octant);
            }
        }

        public static int CountChunks(DensityTree density, long target, int cell = DensityNumbers.Root)
        {
            int below = density.FirstChildOf(cell);
            if (below < 0 || Fits(density[cell], target))
                return density[cell].IsKnown ? 1 : 0;
            int chunks = 0;
            for (int octant = 0; octant < 8; octant++)
                chunks += CountChunks(density, target, below + octant);
            return chunks;
        }

        static bool Fits(DensityCell cell, long target) => !cell.IsKnown || cell.Points <= target
            && cell.Points + ErrorsAllowed * cell.StandardError <= 2.0 * target;

        public void Dispose()
        {
            if (m_chunkOfCell.IsCreated)
                m_chunkOfCell.Dispose();
        }
    }

    internal readonly struct ChunkFinder
    {
        readonly CellFinder m_cells;
        readonly int m_subcellLog2;
        readonly int m_subcellLevels;
        readonly int m_outside;

        internal ChunkFinder(CellFinder cells, int subcellLevels, int outside)
        {
            m_cells = cells;
            m_subcellLevels = subcellLevels;
            m_subcellLog2 = cells.CellLog2 - subcellLevels;
            m_outside = outside;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public unsafe int ChunkOf(int* chunkOfCell, long x, long y, long z)
        {
            int cell = m_cells.CellOf(x, y, z);
            if (cell < 0)
                return m_outside;
            int chunk = chunkOfCell[cell];
            return chunk >= 0 ? chunk : chunkOfCell[~chunk + SubcellOf(x, y, z)];
        }

        /// <summary>Whether the cube holds a box, and is small enough for <see cref="ChunksOf"/>.</summary>
        public bool CanLocateAll(Grid3 min, Grid3 max) => m_cells.SideLog2 <= 31 && m_cells.CellOf(min.X, min.Y, min.Z) >= 0 &&
            m_cells.CellOf(max.X, max.Y, max.Z) >= 0;

        /// <summary>The chunks of many positions, all of them within the cube.</summary>
        /// <param name="offsets">From the origin: all x, then from <paramref name="stride"/> on y, then z.</param>
        public unsafe void ChunksOf(int* chunkOfCell, uint* offsets, int stride, int count, Grid3 origin, int* chunks)
        {
            uint* x = offsets, y = offsets + stride, z = offsets + 2 * stride;
            var corner = m_cells.Corner - origin;
            Morton.EncodeShort(x, y, z, count,
                new MortonCells(new uint3((uint)corner.X, (uint)corner.Y, (uint)corner.Z), m_cells.CellLog2), (uint*)chunks);
            for (int i = 0; i < count; i++)
            {
                int chunk = chunkOfCell[chunks[i]];
                chunks[i] = chunk >= 0 ? chunk
                    : chunkOfCell[~chunk + SubcellOf(origin.X + x[i], origin.Y + y[i], origin.Z + z[i])];
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        int SubcellOf(long x, long y, long z)
        {
            uint mask = (1u << m_subcellLevels) - 1;
            uint px = (uint)((x - m_cells.Corner.X) >> m_subcellLog2) & mask;
            uint py = (uint)((y - m_cells.Corner.Y) >> m_subcellLog2) & mask;
            uint pz = (uint)((z - m_cells.Corner.Z) >> m_subcellLog2) & mask;
            return Morton.EncodeShort(px, py, pz);
        }
    }

    /// <summary>Maps a position to its cell in a cube of 8^n cells, n at most <see cref="Morton.ShortBits"/>.
    /// Blittable.</summary>
    internal struct CellFinder
    {
        public Grid3 Corner;
        public int SideLog2;
        public int CellLog2;

        public CellFinder(GridCube cube, int levels)
        {
            Corner = cube.Corner;
            SideLog2 = cube.SideLog2;
            CellLog2 = cube.SideLog2 - levels;
        }

        /// <returns>The cell's Morton number, or -1 outside.</returns>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int CellOf(long x, long y, long z)
        {
            ulong dx = (ulong)(x - Corner.X), dy = (ulong)(y - Corner.Y), dz = (ulong)(z - Corner.Z);
            if ((dx | dy | dz) >> SideLog2 != 0)
                return -1;
            return Morton.EncodeShort((uint)(dx >> CellLog2), (uint)(dy >> CellLog2), (uint)(dz >> CellLog2));
        }
    }

    /// <summary>The cubes of the octree in which chunks are settled, each by its own points: the largest ones with few enough
    /// by the sample, and the octants around them if the root had to grow. They fill it.</summary>
    internal sealed class BaseCells
    {
        /// <param name="cube">The partition's, which the cells fill.</param>
        /// <param name="shells">See <see cref="RootCube.Grow"/>.</param>
        public BaseCells(GridCube cube, GridCube[] cells, GridCube[] shells)
        {
            Root = shells.Length > 0 ? shells[shells.Length - 1] : cube;
            var around = new List<GridCube>();
            var inner = cube;
            foreach (var shell in shells)
            {
                for (int octant = 0; octant < 8; octant++)
                    if (!shell.Child(octant).ContainsAligned(inner))
                        around.Add(shell.Child(octant));
                inner = shell;
            }
            around.Sort(Compare);
            Around = around.ToArray();
            around.AddRange(cells);
            around.Sort(Compare);
            All = around.ToArray();
        }

        public GridCube Root { get; } // The cube that they fill: the partition's, or the last shell.

        public GridCube[] All { get; }

        public GridCube[] Around { get; } // The octants around the partition's cube, in Morton order.

        public GridCube At(Grid3 position) => All[IndexOf(position)];

        /// <summary>Those in a larger cube, in Morton order.</summary>
        public GridCube[] In(GridCube cube)
        {
            int first = IndexOf(cube.Corner), end = first;
            while (end < All.Length && cube.ContainsAligned(All[end]))
                end++;
            var cells = new GridCube[end - first];
            Array.Copy(All, first, cells, 0, cells.Length);
            return cells;
        }

        /// <summary>The last one whose corner does not come after the position.</summary>
        int IndexOf(Grid3 position)
        {
            int found = Array.BinarySearch(All, new GridCube(position, 0), Comparer<GridCube>.Create(Compare));
            return found >= 0 ? found : ~found - 1;
        }

        int Compare(GridCube a, GridCube b) => MortonOrder.Compare(a.Corner - Root.Corner, b.Corner - Root.Corner);
    }

    /// <summary>Groups neighbours that are small enough to be one: cubes of the octree in Morton order, grouped by the largest
    /// cubes that have no more than some number of points.</summary>
    internal static class CubeGroups
    {
        /// <summary>Consecutive items. A group of one keeps its own cube.</summary>
        public struct Group
        {
            public GridCube Cube;
            public int First;
            public int Count;
        }

        /// <param name="items">Items in Morton order, all inside <paramref name="root"/>.</param>
        /// <param name="target">The most points of a group of several.</param>
        public static List<Group> Of<T>(GridCube root, IReadOnlyList<T> items, Func<T, GridCube> cubeOf, Func<T, long> pointsOf,
            long target)
        {
            var groups = new List<Group>();
            var before = new long[items.Count + 1];
            for (int i = 0; i < items.Count; i++)
                before[i + 1] = before[i] + pointsOf(items[i]);
            Descend(root, 0, items.Count);
            return groups;

            void Descend(GridCube cube, int first, int end)
            {
                if (first == end)
                    return;
                if (end - first == 1 || before[end] - before[first] <= target)
                {
                    groups.Add(new Group { Cube = cube, First = first, Count = end - first });
                    return;
                }
                if (cube.SideLog2 == 0)
                {
                    // Several may share one cube.
                    for (int i = first; i < end; i++)
                        groups.Add(new Group { Cube = cube, First = i, Count = 1 });
                    return;
                }
                for (int octant = 0; octant < 8; octant++)
                {
                    int next = first;
                    while (next < end && cube.OctantOf(cubeOf(items[next]).Corner) == octant)
                        next++;
                    Descend(cube.Child(octant), first, next);
                    first = next;
                }
            }
        }
    }
}
