using System;
using Unity.Collections;

namespace FastPoints.Preview
{
    /// <summary>Which finest cells of an <see cref="ErrorGrid"/> hold a point, and how many points its blocks of 4 x 4 x 4
    /// cells hold: 4 MiB of native memory, whatever the number of points.</summary>
    public sealed class CellOccupancy : IDisposable
    {
        NativeArray<ulong> m_cellsOfBlock;
        NativeArray<long> m_pointsOfBlock;

        public CellOccupancy(Allocator allocator)
        {
            m_cellsOfBlock = new NativeArray<ulong>(ErrorGrid.Blocks, allocator);
            m_pointsOfBlock = new NativeArray<long>(ErrorGrid.Blocks, allocator);
        }

        /// <summary>A bit for each of a block's 64 cells that is occupied.</summary>
        public NativeArray<ulong> CellsOfBlock => m_cellsOfBlock;

        public NativeArray<long> PointsOfBlock => m_pointsOfBlock;

        public void Dispose()
        {
            if (!m_cellsOfBlock.IsCreated)
                return;
            m_cellsOfBlock.Dispose();
            m_pointsOfBlock.Dispose();
        }
    }
}
