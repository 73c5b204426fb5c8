using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Build;
using FastPoints.Drawing;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace FastPoints.Tests.Build
{
    public class NormalEstimatorTests
    {
        const int Count = 20000;
        static readonly double s_spacing = Math.Sqrt(4.0 / Count); // Spacing of that many points on a surface of 4.

        public struct Surface
        {
            public string Name;
            public Func<double2, double3> At;
            public Func<double3, double3> Across;
            public Func<double3, bool> IsInside;

            public override readonly string ToString() => Name;
        }

        /// <summary>Of area 4 each; inside is farther than two spacings from edges.</summary>
        static readonly Surface[] s_surfaces =
        {
            new Surface
            {
                Name = "plane",
                At = u => Rotate(new double3(2 * u.x - 1, 2 * u.y - 1, 0)),
                Across = _ => Rotate(new double3(0, 0, 1)),
                IsInside = p => math.cmax(math.abs(RotateBack(p).xy)) < 1 - 2 * s_spacing,
            },
            new Surface
            {
                Name = "sphere",
                At = u => 1 / Math.Sqrt(Math.PI) * OnSphere(u),
                Across = math.normalize,
                IsInside = _ => true,
            },
            new Surface
            {
                Name = "cylinder",
                At = u => Rotate(new double3(Math.Cos(2 * Math.PI * u.x) / Math.PI, Math.Sin(2 * Math.PI * u.x) / Math.PI,
                    2 * u.y - 1)),
                Across = p => Rotate(math.normalize(new double3(RotateBack(p).xy, 0))),
                IsInside = p => Math.Abs(RotateBack(p).z) < 1 - 2 * s_spacing,
            },
        };

        [Test]
        public void Estimate_SurfaceWithoutNoise_IsWithinThreeDegrees([ValueSource(nameof(s_surfaces))] Surface surface)
        {
            double[] errors = ErrorsOf(surface, 0, 16);
            Assert.That(Median(errors), Is.LessThan(1), "the bar is 3");
            Assert.That(errors.Max(), Is.LessThan(8));
        }

        [Test]
        public void Estimate_NoiseOfAThirdOfTheSpacing_IsWithinSixDegrees([ValueSource(nameof(s_surfaces))] Surface surface) =>
            Assert.That(Median(ErrorsOf(surface, 0.3, 16)), Is.LessThan(6));

        [Test]
        public void Estimate_AnyPlaceAndScale_IsTheSame([Values(1e-3, 1, 1e6)] double scale, [Values(0, 1e9)] double offset)
        {
            var surface = s_surfaces[1];
            var points = PointsOf(surface, 0).Select(p => p * scale + offset).ToArray();
            ushort[] normals = Estimate(points, 16);
            var errors = new double[Count];
            for (int i = 0; i < Count; i++)
                errors[i] = DegreesBetween(normals[i], surface.Across(points[i] - offset));
            Assert.That(Median(errors), Is.LessThan(1));
        }

        [Test]
        public void Estimate_GridOfOtherStepsAlongZ_IsInMetres()
        {
            var surface = s_surfaces[1];
            var steps = new double3(9e-6, 9e-6, 1);
            var points = PointsOf(surface, 0);
            ushort[] normals = Estimate(points.Select(p => p / steps).ToArray(), 16, steps);
            Assert.That(Median(points.Select((p, i) => DegreesBetween(normals[i], surface.Across(p))).ToArray()),
                Is.LessThan(1));
        }

        [Test]
        public void Estimate_Neighbours_AreTheNearestWhereverCellsAre()
        {
            var random = new Random(7);
            // Dense, sparse, and in between.
            var points = Enumerable.Range(0, 3000).Select(_ => Math.Pow(random.NextDouble(), 3) * random.NextDouble3(-1, 1))
                .ToArray();
            ushort[] normals = Estimate(points, 16);
            int differing = 0;
            for (int i = 0; i < points.Length; i++)
                differing += normals[i] == NormalOfNearest(points, i, 16) ? 0 : 1;
            // What is rounded the other way.
            Assert.That(differing, Is.LessThan(10));
        }

        [Test]
        public void Estimate_WithoutAPlane_HasNoNormal()
        {
            Assert.That(Estimate(new[] { new double3(1, 2, 3) }, 16), Is.All.EqualTo(OctahedralNormal.None));
            Assert.That(Estimate(Enumerable.Repeat(new double3(1, 2, 3), 5000).ToArray(), 16),
                Is.All.EqualTo(OctahedralNormal.None));
            Assert.That(Estimate(Enumerable.Range(0, 1000).Select(i => i * new double3(1, 2, 3)).ToArray(), 16),
                Is.All.EqualTo(OctahedralNormal.None));
            Assert.That(Estimate(new[] { default, new double3(1, 2, 3) }, 16), Is.All.EqualTo(OctahedralNormal.None));
        }

        [Test]
        public void Estimate_ThreePoints_HaveTheirPlane()
        {
            var three = new[] { new double3(1, 0, 5), new double3(0, 2, 5), new double3(-3, 0, 5) };
            Assert.That(Estimate(three, 16), Is.All.EqualTo(OctahedralNormal.Encode(new float3(0, 0, 1))));
        }

        /// <summary>Beyond the distance of 16 neighbours they are those of one plane; nearer, in between.</summary>
        [Test]
        public void Estimate_Edge_ReachesAsFarAsNeighboursDo()
        {
            var beyondTwo = new List<double>();
            var random = new Random(9);
            var points = Enumerable.Range(0, Count).Select(i => i % 2 == 0
                ? new double3(random.NextDouble(0, 1.41), random.NextDouble(0, 1.41), 0)
                : new double3(0, random.NextDouble(0, 1.41), random.NextDouble(0, 1.41))).ToArray();
            ushort[] normals = Estimate(points, 16);
            for (int i = 0; i < Count; i++)
            {
                bool isFlat = points[i].z == 0;
                double error = DegreesBetween(normals[i], isFlat ? new double3(0, 0, 1) : new double3(1, 0, 0));
                double spacings = (isFlat ? points[i].x : points[i].z) / s_spacing;
                Assert.That(error, Is.LessThan(spacings < 3.5 ? 85 : 0.01));
                if (spacings >= 2)
                    beyondTwo.Add(error);
            }
            Assert.That(Median(beyondTwo.ToArray()), Is.LessThan(1), "the bar is 3");
        }

        [Test]
        public void TryFit_AnySums_GivesAUnitVectorOrNone()
        {
            var random = new Random(13);
            int fitted = 0;
            for (int i = 0; i < 100000; i++)
            {
                // Points, lines and planes, nearly so, of any size and distance from the first.
                double3 size = new double3(math.pow(10, random.NextDouble(-18, 18)), math.pow(10, random.NextDouble(-18, 18)),
                    math.pow(10, random.NextDouble(-18, 18))), far = i % 3 == 0 ? random.NextDouble3(-1, 1) : 0;
                var sums = new OffsetSums();
                for (int p = 0; p <= i % 17; p++)
                {
                    var d = (float3)(far + (p % 4 == 3 ? 0 : size * random.NextDouble3(-1, 1)));
                    sums.Count++;
                    sums.Offset += d;
                    sums.Squares += d * d;
                    sums.Mixed += new float3(d.x * d.y, d.x * d.z, d.y * d.z);
                }
                if (!PlaneFit.TryFit(sums, out var normal))
                    continue;
                Assert.That(math.length(normal), Is.EqualTo(1).Within(1e-4));
                fitted++;
            }
            Assert.That(fitted, Is.InRange(1000, 99000));
        }

        [Test]
        public void Estimate_PlaneWithDuplicatesAndAFarPoint_IsThePlane()
        {
            var points = PointsOf(s_surfaces[0], 0).SelectMany(p => new[] { p, p }).Append(new double3(1e7, 1e7, 1e7)).ToArray();
            ushort[] normals = Estimate(points, 16);
            var errors = normals.Take(2 * Count).Select(n => DegreesBetween(n, s_surfaces[0].Across(default))).ToArray();
            Assert.That(errors.Max(), Is.LessThan(1));
        }

        [Test]
        public void Estimate_Slices_ChangeNothing()
        {
            var points = PointsOf(s_surfaces[1], 0.3);
            ushort[] whole = Estimate(points, 16);
            using (new WorkerCount(1))
                Assert.That(Estimate(points, 16), Is.EqualTo(whole));
        }

        [Test]
        public void Estimate_Region_LeavesOthersAndIsAsOfTheWhole()
        {
            var points = PointsOf(s_surfaces[1], 0.3);
            ushort[] whole = Estimate(points, 16);
            ushort[] part = Estimate(points, 16, 1, new NormalRegion { Min = -1, Max = new double3(0.1, 1, 1) });
            for (int i = 0; i < Count; i++)
                Assert.That(part[i], Is.EqualTo(points[i].x < 0.1 ? whole[i] : OctahedralNormal.None));
        }

        [Test]
        public void Encode_AnyDirection_IsDecodedWithinADegree()
        {
            var random = new Random(3);
            double sum = 0, largest = 0;
            for (int i = 0; i < 100000; i++)
            {
                var direction = OnSphere(random.NextDouble2(0, 1));
                ushort code = OctahedralNormal.Encode((float3)direction);
                Assert.That(code, Is.Not.EqualTo(OctahedralNormal.None));
                Assert.That(math.dot(OctahedralNormal.Decode(code), OctahedralNormal.Decode(OctahedralNormal.Opposite(code))),
                    Is.EqualTo(-1).Within(1e-6));
                double error = DegreesBetween(code, direction);
                sum += error;
                largest = Math.Max(largest, error);
            }
            Assert.That(sum / 100000, Is.EqualTo(0.33).Within(0.01));
            Assert.That(largest, Is.LessThan(0.95));
        }

        [Test]
        public unsafe void Sum_WithoutAvx2_IsTheSame()
        {
            float* scratch = stackalloc float[Neighbourhood.ScratchFloats], lanes = stackalloc float[9 * 8];
            var near = new Neighbourhood(scratch);
            var random = new Random(11);
            float* x = near.End;
            near.Add(101);
            for (int i = 0; i < 101; i++)
                for (int axis = 0; axis < 3; axis++)
                    x[i + axis * Neighbourhood.MaxPoints] = random.NextFloat(-1.5f, 1.5f);
            near.Pad();
            var q = new float3(x[0], x[Neighbourhood.MaxPoints], x[2 * Neighbourhood.MaxPoints]);
            int limit = 0;
            near.MeasureFrom(q);
            Assert.That(near.FindLimit(17, ref limit), Is.EqualTo(17));
            near.SumLanesPlain(q, limit, lanes);
            Assert.That(near.Sum(q, limit, 17), Is.EqualTo(Neighbourhood.Total(lanes, 17)));
        }

        static double[] ErrorsOf(Surface surface, double noise, int neighbours)
        {
            var points = PointsOf(surface, noise);
            ushort[] normals = Estimate(points, neighbours);
            return points.Select((p, i) => (p, i)).Where(of => surface.IsInside(of.p))
                .Select(of => DegreesBetween(normals[of.i], surface.Across(of.p))).ToArray();
        }

        static double3[] PointsOf(Surface surface, double noise)
        {
            var random = new Random(5);
            return Enumerable.Range(0, Count).Select(_ =>
            {
                var p = surface.At(random.NextDouble2(0, 1));
                double normal = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
                return p + noise * s_spacing * normal * surface.Across(p);
            }).ToArray();
        }

        internal static ushort[] Estimate(double3[] points, int neighbours, double3? metres = null, NormalRegion? own = null)
        {
            var schema = new PointSchema(new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z }
                .Select(name => new PointAttribute(name, AttributeType.Float64)).ToArray());
            using var batch = new PointBatch(schema, points.Length, Allocator.Persistent) { Count = points.Length };
            double3 min = points.Aggregate(math.min), max = points.Aggregate(math.max);
            var region = own ?? new NormalRegion { Min = min, Max = max + math.max(1e-6 * (max - min), 1e-15 * math.abs(max)) };
            region.StepMetres = metres ?? 1;
            region.Neighbours = neighbours;
            region.MarginMetres = own.HasValue ? 0.5 : 0;
            for (int axis = 0; axis < 3; axis++)
                batch.Column<double>(axis).CopyFrom(points.Select(p => p[axis]).ToArray());
            using var normals = new NativeArray<ushort>(points.Length, Allocator.Persistent);
            using var slices = new SliceTimes(Allocator.Persistent);
            JobCoroutine.RunToEnd(NormalEstimator.Run(batch, region, normals, slices));
            return normals.ToArray();
        }

        static ushort NormalOfNearest(double3[] points, int of, int neighbours)
        {
            var near = points.Select(p => p - points[of]).OrderBy(math.lengthsq).Take(neighbours + 1).ToArray();
            double scale = 1 / Math.Max(1e-300, math.length(near[neighbours]));
            var sums = new OffsetSums();
            foreach (var offset in near)
            {
                var d = (float3)(scale * offset);
                sums.Count++;
                sums.Offset += d;
                sums.Squares += d * d;
                sums.Mixed += new float3(d.x * d.y, d.x * d.z, d.y * d.z);
            }
            return !PlaneFit.TryFit(sums, out var normal) ? OctahedralNormal.None
                : OctahedralNormal.Encode(normal.z < 0 ? -normal : normal);
        }

        /// <summary>Of lines: a normal that is turned round is right.</summary>
        internal static double DegreesBetween(ushort normal, double3 wanted)
        {
            if (normal == OctahedralNormal.None)
                return 90;
            var got = (double3)OctahedralNormal.Decode(normal);
            return 180 / Math.PI * (Math.Atan2(math.length(math.cross(got, wanted)), Math.Abs(math.dot(got, wanted))));
        }

        internal static double Median(double[] values) => values.OrderBy(v => v).ElementAt(values.Length / 2);

        static double3 OnSphere(double2 u)
        {
            double z = 2 * u.y - 1, r = Math.Sqrt(1 - z * z);
            return new double3(r * Math.Cos(2 * Math.PI * u.x), r * Math.Sin(2 * Math.PI * u.x), z);
        }

        /// <summary>Along no axis: cells are cut across.</summary>
        static readonly double3x3 s_rotation = new double3x3(math.normalize(new double3(2, -1, 0)),
            math.normalize(math.cross(new double3(1, 2, 3), new double3(2, -1, 0))), math.normalize(new double3(1, 2, 3)));

        static double3 Rotate(double3 p) => math.mul(s_rotation, p);

        static double3 RotateBack(double3 p) => math.mul(math.transpose(s_rotation), p);
    }
}
