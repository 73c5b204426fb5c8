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
            return chunkOfCell[~chunk + (int)Morton.Encode(px, py, pz)];
        }
    }
}
