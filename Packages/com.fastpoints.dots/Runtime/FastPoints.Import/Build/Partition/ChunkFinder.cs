using System.Runtime.CompilerServices;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>The blittable half of a <see cref="PartitionMap"/>, which finds a position's chunk.</summary>
    internal readonly struct ChunkFinder
    {
        readonly CellFinder m_cells;
        readonly int m_partLog2;
        readonly int m_partLevels;
        readonly int m_outside;

        internal ChunkFinder(CellFinder cells, int partLevels, int outside)
        {
            m_cells = cells;
            m_partLevels = partLevels;
            m_partLog2 = cells.CellLog2 - partLevels;
            m_outside = outside;
        }

        /// <param name="chunkOfCell">See <see cref="PartitionMap.ChunkOfCell"/>.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public unsafe int ChunkOf(int* chunkOfCell, long x, long y, long z)
        {
            int cell = m_cells.CellOf(x, y, z);
            if (cell < 0)
                return m_outside;
            int chunk = chunkOfCell[cell];
            return chunk >= 0 ? chunk : chunkOfCell[~chunk + PartOf(x, y, z)];
        }

        /// <summary>Whether the cube holds a box, and is small enough for <see cref="ChunksOf"/>.</summary>
        public bool Contains(Grid3 min, Grid3 max) => m_cells.SideLog2 <= 31 && m_cells.CellOf(min.X, min.Y, min.Z) >= 0 &&
            m_cells.CellOf(max.X, max.Y, max.Z) >= 0;

        /// <summary>The chunks of many positions, all of them within the cube.</summary>
        /// <param name="x">Offsets from the origin.</param>
        public unsafe void ChunksOf(int* chunkOfCell, uint* x, uint* y, uint* z, int count, Grid3 origin, int* chunks)
        {
            var corner = m_cells.Corner - origin;
            Morton.EncodeShort(x, y, z, count,
                new MortonCells(new uint3((uint)corner.X, (uint)corner.Y, (uint)corner.Z), m_cells.CellLog2), (uint*)chunks);
            for (int i = 0; i < count; i++)
            {
                int chunk = chunkOfCell[chunks[i]];
                chunks[i] = chunk >= 0 ? chunk : chunkOfCell[~chunk + PartOf(origin.X + x[i], origin.Y + y[i], origin.Z + z[i])];
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        int PartOf(long x, long y, long z)
        {
            uint mask = (1u << m_partLevels) - 1;
            uint px = (uint)((x - m_cells.Corner.X) >> m_partLog2) & mask;
            uint py = (uint)((y - m_cells.Corner.Y) >> m_partLog2) & mask;
            uint pz = (uint)((z - m_cells.Corner.Z) >> m_partLog2) & mask;
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
}
