using System;
using System.Collections.Generic;
using FastPoints.Build;
using FastPoints.Drawing;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>Normals of points on a sphere with noise of 0.3 spacings, in any order, on all workers. The error is the median
    /// angle.</summary>
    sealed class NormalsWorkload : IWorkload
    {
        const double Radius = 100;

        readonly int m_neighbours;
        PointBatch m_batch;
        NativeArray<ushort> m_normals;
        SliceTimes m_slices;

        NormalsWorkload(int neighbours) => m_neighbours = neighbours;

        public static IEnumerable<IWorkload> All()
        {
            foreach (int neighbours in new[] { 8, 12, 16, 24, 32 })
                yield return new NormalsWorkload(neighbours);
        }

        public string Name => "normals, " + m_neighbours.ToString("00") + " neighbours";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_slices = new SliceTimes(Allocator.Persistent);
            m_normals = new NativeArray<ushort>(context.Points, Allocator.Persistent);
            var schema = new PointSchema(PositionColumns.Attributes(AttributeType.Float64));
            m_batch = new PointBatch(schema, context.Points, Allocator.Persistent) { Count = context.Points };
            NativeArray<double> x = m_batch.Column<double>(0), y = m_batch.Column<double>(1), z = m_batch.Column<double>(2);
            double noise = 0.3 * Radius * Math.Sqrt(4 * Math.PI / context.Points);
            var random = new Unity.Mathematics.Random(context.Seed);
            for (int i = 0; i < context.Points; i++)
            {
                double height = random.NextDouble(-1, 1), angle = 2 * Math.PI * random.NextDouble();
                double gauss = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
                double radius = Radius + noise * gauss, across = radius * Math.Sqrt(1 - height * height);
                (x[i], y[i], z[i]) = (across * Math.Cos(angle), across * Math.Sin(angle), radius * height);
            }
        }

        public WorkloadResult Run()
        {
            JobCoroutine.RunToEnd(NormalEstimator.Run(m_batch, new NormalRegion
            {
                Min = -2 * Radius,
                Max = 2 * Radius,
                StepMetres = 1,
                Neighbours = m_neighbours,
            }, m_normals, m_slices));
            return new WorkloadResult { Points = m_batch.Count, Error = MedianDegrees(), ErrorUnit = "degrees" };
        }

        public void Dispose()
        {
            m_batch.Dispose();
            m_normals.Dispose();
            m_slices.Dispose();
        }

        /// <summary>Of every hundredth point: it is timed, too.</summary>
        double MedianDegrees()
        {
            NativeArray<double> x = m_batch.Column<double>(0), y = m_batch.Column<double>(1), z = m_batch.Column<double>(2);
            var degrees = new double[(m_batch.Count + 99) / 100];
            for (int i = 0; i < degrees.Length; i++)
            {
                var normal = (double3)OctahedralNormal.Decode(m_normals[100 * i]);
                var wanted = new double3(x[100 * i], y[100 * i], z[100 * i]);
                degrees[i] = 180 / Math.PI *
                    Math.Atan2(math.length(math.cross(normal, wanted)), Math.Abs(math.dot(normal, wanted)));
            }
            Array.Sort(degrees);
            return degrees[degrees.Length / 2];
        }
    }
}
