using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

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

    [BurstCompile]
    public struct CountOccupancyJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeReference<DecodeResult> Result;
        internal PositionColumns Positions;
        public PositionTransform Transform;
        public ErrorGrid Grid;

        public NativeArray<ulong> CellsOf128th;
        public NativeArray<long> PointsOfBlock;

        public void Execute() => new CountSampledCellsJob
        {
            Sample = Block,
            Positions = Positions,
            Transform = Transform,
            Count = Result.Value.Points,
            Grid = Grid,
            CellsOf128th = CellsOf128th,
            PointsOfBlock = PointsOfBlock,
        }.Execute();
    }

    [BurstCompile]
    public struct CountSampledCellsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Sample;
        internal PositionColumns Positions;
        public PositionTransform Transform;
        public int First;
        public int Count;
        public ErrorGrid Grid;

        public NativeArray<ulong> CellsOf128th;
        public NativeArray<long> PointsOfBlock;

        public unsafe void Execute()
        {
            byte* bytes = (byte*)Sample.GetUnsafeReadOnlyPtr();
            ulong* cellsOf128th = (ulong*)CellsOf128th.GetUnsafePtr();
            long* pointsOfBlock = (long*)PointsOfBlock.GetUnsafePtr();
            double* x = stackalloc double[ColumnValues.BatchLength];
            double* y = stackalloc double[ColumnValues.BatchLength];
            double* z = stackalloc double[ColumnValues.BatchLength];
            for (int done = 0; done < Count; done += ColumnValues.BatchLength)
            {
                int length = math.min(ColumnValues.BatchLength, Count - done);
                Positions.Load(bytes, First + done, length, x, y, z);
                Transform.ToGeo(length, x, y, z);
                for (int i = 0; i < length; i++)
                {
                    if (!Grid.TryCell(x[i], y[i], z[i], out uint cell))
                        continue;
                    cellsOf128th[cell >> 6] |= 1UL << (int)(cell & 63);
                    pointsOfBlock[cell >> 9]++;
                }
            }
        }
    }
}
