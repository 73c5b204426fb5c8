using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using FastPoints.Points;
using Unity.Collections;

namespace FastPoints.Octree
{
    /// <summary>
    /// Which chunk a place belongs to: a cube in 8^<see cref="Levels"/> cells in Morton order, and the chunk of each. Chunks are
    /// cubes of the octree; places outside the cube have a chunk of their own, the last.
    /// </summary>
    public sealed class PartitionMap : IDisposable
    {
        /// <summary>8^6 cells are 1 MB: they stay in a core's cache while points are sorted into them.</summary>
        public const int MaxLevels = 6;

        NativeArray<int> m_chunkOfCell;

        PartitionMap(GridCube cube, int levels, NativeArray<int> chunkOfCell, GridCube[] chunks)
        {
            Cube = cube;
            Levels = levels;
            Chunks = chunks;
            m_chunkOfCell = chunkOfCell;
        }

        public GridCube Cube { get; }
        public int Levels { get; }

        /// <summary>The chunks' cubes, in Morton order; they fill the cube.</summary>
        public GridCube[] Chunks { get; }

        /// <summary>The number of the chunk that has all places outside.</summary>
        public int Outside => Chunks.Length;

        public NativeArray<int> ChunkOfCell => m_chunkOfCell;

        /// <summary>Levels of cells that a cube of this side can have.</summary>
        public static int LevelsFor(int sideLog2, int wanted) => Math.Min(wanted, sideLog2);

        /// <summary>
        /// Cubes with at most <paramref name="target"/> points by the counts, as large as they can be, down to single cells.
        /// </summary>
        /// <param name="pointsOfCell">By Morton number of the cell: counted, or estimated from a sample.</param>
        public static PartitionMap Plan(GridCube cube, int levels, NativeArray<long> pointsOfCell, long target)
        {
            var chunkOfCell = new NativeArray<int>(pointsOfCell.Length, Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            var before = new long[pointsOfCell.Length + 1];
            for (int i = 0; i < pointsOfCell.Length; i++)
                before[i + 1] = before[i] + pointsOfCell[i];
            var chunks = new List<GridCube>();
            Descend(cube, 0, pointsOfCell.Length, before, target, chunkOfCell, chunks);
            return new PartitionMap(cube, levels, chunkOfCell, chunks.ToArray());
        }

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

    /// <summary>The blittable half of a <see cref="PartitionMap"/>: from a place to its cell.</summary>
    public struct CellFinder
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
            return (int)Morton.Encode((uint)(dx >> CellLog2), (uint)(dy >> CellLog2), (uint)(dz >> CellLog2));
        }
    }
}
