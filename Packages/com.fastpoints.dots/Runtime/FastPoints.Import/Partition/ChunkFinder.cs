using System.Runtime.CompilerServices;
using FastPoints.Points;

namespace FastPoints.Partition
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
            if (chunk >= 0)
                return chunk;
            uint mask = (1u << m_partLevels) - 1;
            uint px = (uint)((x - m_cells.Corner.X) >> m_partLog2) & mask;
            uint py = (uint)((y - m_cells.Corner.Y) >> m_partLog2) & mask;
            uint pz = (uint)((z - m_cells.Corner.Z) >> m_partLog2) & mask;
            return chunkOfCell[~chunk + Morton.EncodeFew(px, py, pz)];
        }
    }

    /// <summary>Maps a position to its cell in a cube of 8^n cells, n at most <see cref="Morton.FewBits"/>.
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
            return Morton.EncodeFew((uint)(dx >> CellLog2), (uint)(dy >> CellLog2), (uint)(dz >> CellLog2));
        }
    }
}
