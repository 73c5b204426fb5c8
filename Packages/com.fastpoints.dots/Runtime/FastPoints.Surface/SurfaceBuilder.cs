using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>Makes the surface of one cell after another, each by a chain of short jobs: voxels of points, surfels of
    /// voxels, a shell around surfels, triangles of the shell. A cell and its neighbour agree on what both have.</summary>
    internal sealed class SurfaceBuilder : IDisposable
    {
        readonly SurfaceGrid m_grid;
        readonly float3 m_up;
        SurfaceMemory m_memory;
        SliceTimes m_times = new SliceTimes(Allocator.Persistent);

        /// <param name="up">A unit vector along the source's axes.</param>
        public SurfaceBuilder(in SurfaceGrid grid, float3 up)
        {
            m_grid = grid;
            m_up = up;
            m_memory = new SurfaceMemory(grid, Allocator.Persistent);
        }

        public NativeArray<int3> Vertices => m_memory.Vertices.AsArray(); // Of the last cell: valid until the next one.
        public NativeArray<int3> Triangles => m_memory.Triangles.AsArray();

        public int VoxelCount { get; private set; } // How many voxels of it and its margins have points.

        public SliceTimes Times => m_times; // How long the slices of jobs took so far.

        /// <summary>Coroutine.</summary>
        /// <param name="points">Adds the points in the cell and around it, batch by batch, by <see cref="Add"/>.</param>
        public IEnumerator<JobStep> Run(int3 cell, Func<SurfaceBuilder, int3, IEnumerator<JobStep>> points)
        {
            VoxelCount = 0;
            yield return JobStep.Of(Slices.Run(0, 1, 1, (first, end, after) =>
                new ClearSurfaceJob { Memory = m_memory, Times = m_times }.Schedule(after)));
            yield return JobStep.Of(points(this, cell));
            int measured = VoxelCount = m_memory.Voxels.Length;
            if (measured == 0)
                yield break;
            m_memory.Means.Resize(measured, NativeArrayOptions.UninitializedMemory);
            m_memory.Surfels.Resize(measured, NativeArrayOptions.UninitializedMemory);
            yield return JobStep.Of(Slices.Run(0, measured, AverageVoxelsJob.VoxelsPerSlice, (first, end, after) =>
                new AverageVoxelsJob { First = first, End = end, Memory = m_memory }.Schedule(after)));
            yield return JobStep.Of(Slices.Run(0, measured, FitSurfelsJob.VoxelsPerSlice, (first, end, after) => new FitSurfelsJob
            {
                First = first,
                End = end,
                Grid = m_grid,
                Up = m_up,
                Memory = m_memory,
                Times = m_times,
            }.Schedule(after)));
            for (int ring = 0, first = 0; ring < m_grid.HoleRings; ring++)
            {
                int end = m_memory.Surfels.Length;
                yield return JobStep.Of(Slices.Run(first, end, CloseHolesJob.SurfelsPerSlice, (from, to, after) =>
                    new CloseHolesJob
                    {
                        First = from,
                        End = to,
                        Grid = m_grid,
                        Measured = measured,
                        Memory = m_memory,
                        Times = m_times,
                    }.Schedule(after)));
                first = end;
            }
            yield return JobStep.Of(Slices.Run(0, m_memory.Surfels.Length, RasterizeSurfelsJob.SurfelsPerSlice,
                (first, end, after) =>
                new RasterizeSurfelsJob { First = first, End = end, Grid = m_grid, Memory = m_memory, Times = m_times }
                    .Schedule(after)));
            int rows = (m_grid.CellEdgeVoxels + 1) * (m_grid.CellEdgeVoxels + 1);
            yield return JobStep.Of(Slices.Run(0, rows, ExtractSurfaceJob.RowsPerSlice, (first, end, after) =>
                new ExtractSurfaceJob { First = first, End = end, Grid = m_grid, Memory = m_memory, Times = m_times }
                    .Schedule(after)));
        }

        /// <summary>Coroutine: adds points to the cell that is being made.</summary>
        /// <param name="batch">Positions as doubles from the root's corner.</param>
        /// <param name="metres">Metres of what they are stored in.</param>
        /// <param name="hidden">Points of these classes are left out; the batch has classes, or it is empty.</param>
        public IEnumerator<JobStep> Add(int3 cell, PointBatch batch, double3 metres, ClassMask hidden = default)
        {
            var x = batch.Column<double>(AttributeNames.X);
            var y = batch.Column<double>(AttributeNames.Y);
            var z = batch.Column<double>(AttributeNames.Z);
            int column = hidden.IsEmpty ? -1 : batch.Schema.IndexOf(AttributeNames.Classification);
            var classes = column < 0 ? batch.Bytes.GetSubArray(0, 0) : batch.Column<byte>(column);
            return Slices.Run(0, batch.Count, CollectVoxelsJob.PointsPerSlice, (first, end, after) => new CollectVoxelsJob
            {
                First = first,
                End = end,
                Grid = m_grid,
                Cell = cell,
                StepMetres = metres,
                Hidden = hidden,
                X = x,
                Y = y,
                Z = z,
                Classes = classes,
                Memory = m_memory,
                Times = m_times,
            }.Schedule(after));
        }

        public void Dispose()
        {
            m_memory.Dispose();
            m_times.Dispose();
        }
    }

    [BurstCompile]
    internal unsafe struct ClearSurfaceJob : IJob
    {
        public SurfaceMemory Memory;
        public SliceTimes Times;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            UnsafeUtility.MemClear(Memory.SurfelOf.GetUnsafePtr(), Memory.SurfelOf.Length * (long)sizeof(int));
            UnsafeUtility.MemClear(Memory.IsInside.GetUnsafePtr(), Memory.IsInside.Length);
            UnsafeUtility.MemClear(Memory.IsRowInside.GetUnsafePtr(), Memory.IsRowInside.Length);
            UnsafeUtility.MemClear(Memory.VertexNumberOfCube.GetUnsafePtr(),
                Memory.VertexNumberOfCube.Length * (long)sizeof(int));
            Memory.Voxels.Clear();
            Memory.Surfels.Clear();
            Memory.Vertices.Clear();
            Memory.Triangles.Clear();
            Times.End(begin);
        }
    }
}
