using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using FastPoints.Core;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>Maps positions to chunks: a cube in 8^<see cref="Levels"/> cells in Morton order, and the chunk of each, or of
    /// each of its parts if many points lie in one cell. Chunks are cubes of the octree; positions outside the cube have a chunk
    /// of their own, the last one.</summary>
    internal sealed class PartitionMap : IDisposable
    {
        /// <summary>8^6 cells are 1 MB: they stay in a core's cache while points are sorted into them.</summary>
        public const int MaxLevels = 6;

        /// <summary>The most levels of parts of a cell, for cells that need them.</summary>
        const int MaxPartLevels = DensityNumbers.Levels - MaxLevels;

        /// <summary>How many standard errors above its estimate a chunk may have before it must be split.</summary>
        const double ErrorsAllowed = 2;

        NativeArray<int> m_chunkOfCell;
        readonly int m_partLevels;

        PartitionMap(GridCube cube, int levels, int partLevels, NativeArray<int> chunkOfCell, GridCube[] chunks)
        {
            Cube = cube;
            Levels = levels;
            m_partLevels = partLevels;
            Chunks = chunks;
            m_chunkOfCell = chunkOfCell;
        }

        public GridCube Cube { get; }
        public int Levels { get; }

        /// <summary>The chunks' cubes, in Morton order; they fill the cube.</summary>
        public GridCube[] Chunks { get; }

        /// <summary>The number of the chunk for all positions outside.</summary>
        public int Outside => Chunks.Length;

        /// <summary>Indexed by Morton number of the cell; ~i means that its parts' chunks begin at i, in Morton order.</summary>
        public NativeArray<int> ChunkOfCell => m_chunkOfCell;

        /// <summary>Finds the chunk of a position in <see cref="ChunkOfCell"/>.</summary>
        public ChunkFinder Finder => new ChunkFinder(new CellFinder(Cube, Levels), m_partLevels, Outside);

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
            Descend(cube, 0, pointsOfCell.Length, before, target, chunkOfCell, chunks);
            return new PartitionMap(cube, levels, 0, chunkOfCell, chunks.ToArray());
        }

        /// <summary>Plans cubes with at most <paramref name="target"/> points by an estimate, as large as possible, down to its
        /// cells; smaller ones if it is so uncertain that they might have twice as many.</summary>
        /// <param name="density">The estimate for the same cube.</param>
        public static PartitionMap Plan(GridCube cube, DensityTree density, long target)
        {
            int levels = LevelsFor(cube.SideLog2, MaxLevels);
            int partLevels = LevelsFor(cube.SideLog2 - levels, MaxPartLevels);
            using var chunkOfCell = new NativeList<int>(1 << 3 * levels, Allocator.Persistent);
            chunkOfCell.ResizeUninitialized(1 << 3 * levels);
            var chunks = new List<GridCube>();
            Descend(cube, 0, 0, DensityNumbers.Root);
            return new PartitionMap(cube, levels, partLevels, new NativeArray<int>(chunkOfCell.AsArray(), Allocator.Persistent),
                chunks.ToArray());

            // The cube's cells, or parts of a cell, begin at first.
            void Descend(GridCube part, int level, int first, int cell)
            {
                bool isOfCells = level <= levels;
                int count = 1 << 3 * (isOfCells ? levels - level : levels + partLevels - level);
                int below = density.FirstPartOf(cell);
                if (below < 0 || level == levels + partLevels || Fits(density[cell], target))
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
                    count = 1 << 3 * partLevels;
                    chunkOfCell.ResizeUninitialized(first + count);
                }
                for (int octant = 0; octant < 8; octant++)
                    Descend(part.Child(octant), level + 1, first + octant * (count / 8), below + octant);
            }
        }

        /// <summary>The number of chunks with points in such a plan.</summary>
        public static int CountChunks(DensityTree density, long target) => CountChunks(density, target, DensityNumbers.Root);

        static int CountChunks(DensityTree density, long target, int cell)
        {
            int below = density.FirstPartOf(cell);
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

        static void Descend(GridCube cube, int first, int count, long[] before, long target, NativeArray<int> chunkOfCell,
            List<GridCube> chunks)
        {
            if (count == 1 || before[first + count] - before[first] <= target)
            {
                for (int i = first; i < first + count; i++)
                    chunkOfCell[i] = chunks.Count;
                chunks.Add(cube);
                return;
            }
            for (int octant = 0; octant < 8; octant++)
                Descend(cube.Child(octant), first + octant * (count / 8), count / 8, before, target, chunkOfCell, chunks);
        }
    }
}
