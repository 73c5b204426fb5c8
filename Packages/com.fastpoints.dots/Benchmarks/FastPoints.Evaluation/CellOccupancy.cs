using System;
using Unity.Collections;

namespace FastPoints.Evaluation
{
    /// <summary>Which finest cells of an <see cref="ErrorGrid"/> hold a point, and how many points its blocks of 8 x 8 x 8
    /// cells hold: 18 MiB of native memory, whatever the number of points.</summary>
    public sealed class CellOccupancy : IDisposable
    {
        NativeArray<ulong> m_cellsOf128th;
        NativeArray<long> m_pointsOfBlock;

        public CellOccupancy(Allocator allocator)
        {
            m_cellsOf128th = new NativeArray<ulong>(8 * ErrorGrid.Blocks, allocator);
            m_pointsOfBlock = new NativeArray<long>(ErrorGrid.Blocks, allocator);
        }

        /// <summary>A bit for each of the 64 finest cells of a 128th that is occupied; eight such words a block.</summary>
        public NativeArray<ulong> CellsOf128th => m_cellsOf128th;

        public NativeArray<long> PointsOfBlock => m_pointsOfBlock;

        public void Dispose()
        {
            if (!m_cellsOf128th.IsCreated)
                return;
            m_cellsOf128th.Dispose();
            m_pointsOfBlock.Dispose();
        }
    }
}
