using System;
using FastPoints.Surface;
using Unity.Collections;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace FastPoints.Benchmarks
{
    /// <summary>The surface of a cell of 8 m in voxels of 10 cm: ground that rises and falls, a wall and a car's box on it,
    /// with noise of 1 cm.</summary>
    sealed class SurfaceWorkload : IWorkload
    {
        const double CellMetres = 8;

        readonly SurfaceGrid m_grid = new SurfaceGrid(0.1, 80, 3);
        PointBatch m_batch;
        SurfaceBuilder m_builder;

        public string Name => "surface, a cell of a street";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_builder = new SurfaceBuilder(m_grid, new float3(0, 0, 1));
            var schema = new PointSchema(PositionColumns.Attributes(AttributeType.Float64));
            m_batch = new PointBatch(schema, context.Points, Allocator.Persistent) { Count = context.Points };
            NativeArray<double> x = m_batch.Column<double>(0), y = m_batch.Column<double>(1), z = m_batch.Column<double>(2);
            var random = new Random(context.Seed);
            for (int i = 0; i < context.Points; i++)
            {
                var place = PlaceOf(i, random.NextDouble2(0, 1), m_grid.Margin * m_grid.VoxelMetres);
                place += 0.01 * random.NextDouble3(-1, 1);
                (x[i], y[i], z[i]) = (place.x, place.y, place.z);
            }
        }

        /// <summary>Of ten points, six are of the ground, two of the wall, two of the box.</summary>
        static double3 PlaceOf(int point, double2 at, double margin)
        {
            double2 all = at * (CellMetres + 2 * margin) - margin;
            if (point % 10 < 6)
                return new double3(all, 1 + 0.2 * Math.Sin(all.x) * Math.Cos(all.y));
            if (point % 10 < 8)
                return new double3(all.x, 7, 1 + 4 * at.y);
            return point % 2 == 0 ? new double3(2 + 2 * at.x, 2 + 3 * at.y, 2.4) : new double3(4, 2 + 3 * at.x, 1 + 1.4 * at.y);
        }

        public WorkloadResult Run()
        {
            JobCoroutine.RunToEnd(m_builder.Run(default, (builder, cell) => builder.Add(cell, m_batch, 1)));
            return new WorkloadResult
            {
                Points = m_batch.Count,
                Note = "slices: half within " + SliceMs(0.5) + " ms, 99 % within " + SliceMs(0.99) + " ms, longest " +
                    SliceMs(1) + " ms",
            };
        }

        string SliceMs(double share) => NumberText.Of(Math.Round(m_builder.Times.QuantileMs(share), 1));

        public void Dispose()
        {
            m_builder.Dispose();
            m_batch.Dispose();
        }
    }
}
