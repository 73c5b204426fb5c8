using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Evaluation;
using FastPoints.Surface;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace FastPoints.Tests.Surface
{
    public class SurfaceBuilderTests
    {
        const double Voxel = 0.1;
        const float Hole = 3;

        static SurfaceGrid Grid(int cellVoxels = 40, float hole = Hole) => new SurfaceGrid(Voxel, cellVoxels, hole);

        static double Gauss(ref Random random) => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) *
            Math.Cos(2 * Math.PI * random.NextDouble());

        /// <summary>A jittered point a voxel, with noise, on a plane through the middle that is turned from the ground.</summary>
        static List<double3> Plane(double edge, double degrees, double noise, Func<double2, bool> isThere = null)
        {
            var random = new Random(7);
            var points = new List<double3>();
            double sin = Math.Sin(degrees * Math.PI / 180), cos = Math.Cos(degrees * Math.PI / 180);
            for (double y = -edge / 2; y < edge / 2 - Voxel / 2; y += Voxel)
                for (double x = -edge / 2; x < edge / 2 - Voxel / 2; x += Voxel)
                {
                    double u = x + Voxel * random.NextDouble(), v = y + Voxel * random.NextDouble();
                    double w = noise * Gauss(ref random);
                    if (isThere == null || isThere(new double2(u, v)))
                        points.Add(new double3(u * cos - w * sin, v, u * sin + w * cos));
                }
            return points;
        }

        [Test]
        public void Run_PlaneOfAPointAVoxelWithNoise_IsWatertight([Values(0, 20, 45, 70, 90)] double degrees)
        {
            var surface = new TestSurface(Plane(10, degrees, 0.3 * Voxel), Grid());
            var grid = surface.ToGrid();
            double sin = Math.Sin(degrees * Math.PI / 180), cos = Math.Cos(degrees * Math.PI / 180);
            var across = new double3(-sin, 0, cos);
            var random = new Random(3);
            double sum = 0;
            int passed = 0;
            const int lines = 4000;
            for (int i = 0; i < lines; i++)
            {
                double u = random.NextDouble(-4.8, 4.8), v = random.NextDouble(-4.8, 4.8);
                var place = new double3(u * cos, v, u * sin);
                var shares = TestSurface.Passes(grid, place + 3 * Voxel * across, place - 3 * Voxel * across);
                if (shares.Count == 0)
                    continue;
                passed++;
                sum += Math.Abs(shares[0] - 0.5) * 6;
            }
            Assert.That(surface.CountOpenEdges(), Is.Zero);
            Assert.That(passed, Is.EqualTo(lines));
            Assert.That(sum / passed, Is.LessThan(0.2), "voxels off the plane");
        }

        [Test]
        public void Run_InCellsOfAnySizeAndPointsInAnyOrder_MakesTheSameSurface()
        {
            var points = Bumps(20000);
            var one = new TestSurface(points, Grid(64));
            var many = new TestSurface(points.AsEnumerable().Reverse().ToList(), Grid(13));
            Assert.That(many.CountOpenEdges(), Is.Zero);
            Assert.That(Corners(many), Is.EqualTo(Corners(one)));
        }

        /// <summary>Sorted, so that it does not matter where a triangle begins and which one comes first.</summary>
        static string[] Corners(TestSurface surface) => surface.Triangles.Select(t => string.Join(" ",
            new[] { t.x, t.y, t.z }.Select(v => (surface.Vertices[v] * 1e6).ToString()).OrderBy(v => v, StringComparer.Ordinal)))
            .OrderBy(t => t, StringComparer.Ordinal).ToArray();

        static List<double3> Bumps(int count)
        {
            var random = new Random(11);
            var points = new List<double3>();
            for (int i = 0; i < count; i++)
            {
                double x = random.NextDouble(-3, 3), y = random.NextDouble(-3, 3);
                points.Add(new double3(x, y, 0.7 * Math.Sin(2 * x) * Math.Cos(y) + 0.02 * Gauss(ref random)));
            }
            return points;
        }

        [Test, Category("Smoke")]
        public void Run_HoleUpToTheStatedSize_IsClosed()
        {
            // Wide enough that the noise of places leaves none of the plane within half a hole of the middle.
            var surface = new TestSurface(Plane(6, 0, 0, at => math.length(at) > 0.45 * Hole * Voxel), Grid());
            Assert.That(PassesDown(surface, default), Is.True);
            var open = new TestSurface(Plane(6, 0, 0, at => math.length(at) > 0.45 * Hole * Voxel), Grid(hole: 0));
            Assert.That(PassesDown(open, default), Is.False);
        }

        [Test]
        public void Run_HoleWiderThanStated_StaysOpenAndEdgesDoNotGrow()
        {
            const double wide = 2 * Hole * Voxel;
            var surface = new TestSurface(Plane(6, 0, 0, at => math.length(at) > wide && at.x < 2), Grid());
            Assert.That(PassesDown(surface, default), Is.False);
            Assert.That(surface.Vertices.Max(v => v.x), Is.LessThan(2 + Voxel));
            Assert.That(surface.Vertices.Min(v => math.length(v.xy)), Is.GreaterThan(wide - Hole * Voxel));
        }

        static bool PassesDown(TestSurface surface, double2 at) =>
            TestSurface.Passes(surface.ToGrid(), new double3(at, 1), new double3(at, -1)).Count > 0;

        [Test]
        public void Run_WallScannedFromBothSides_HasBothFacesWhereThePointsAre([Values(0.5, 1, 2, 4)] double thickVoxels)
        {
            double thick = thickVoxels * Voxel;
            var points = Plane(6, 90, 0.05 * Voxel);
            points.AddRange(points.Select(p => p + new double3(thick, 0, 0)).ToArray());
            var surface = new TestSurface(points, Grid());
            var grid = surface.ToGrid();
            var random = new Random(5);
            for (int i = 0; i < 500; i++)
            {
                double y = random.NextDouble(-2.7, 2.7), z = random.NextDouble(-2.7, 2.7);
                var shares = TestSurface.Passes(grid, new double3(-1, y, z), new double3(1 + thick, y, z));
                Assert.That(shares.Count, Is.GreaterThanOrEqualTo(2));
                Assert.That(shares[0] * (2 + thick) - 1, Is.EqualTo(0).Within(0.6 * Voxel), "front");
                Assert.That(shares[shares.Count - 1] * (2 + thick) - 1, Is.EqualTo(thick).Within(0.6 * Voxel), "back");
            }
        }

        [Test]
        public void Run_SeededClouds_LieAtTheirPoints([Values("bumps", "box", "scatter")] string shape)
        {
            var points = shape == "bumps" ? Bumps(20000) : shape == "box" ? Box(30000) : Scatter(3000);
            var surface = new TestSurface(points, Grid());
            var grid = surface.ToGrid();
            var random = new Random(9);
            var toSurface = points.Where((_, i) => i % 7 == 0).Select(p => grid.DistanceTo(p, 4 * Voxel)).ToList();
            var toPoints = PlacesOn(surface, 1500, ref random).Select(s => points.Min(p => math.distance(p, s))).ToList();
            Assert.That(surface.CountOpenEdges(), Is.Zero);
            Assert.That(toSurface.Count(d => d <= 1.5 * Voxel), Is.GreaterThanOrEqualTo(0.99 * toSurface.Count));
            // Places in a volume have no surface; what is made between them still has points within a hole.
            if (shape != "scatter")
                Assert.That(toPoints.Count(d => d <= Voxel), Is.GreaterThanOrEqualTo(0.95 * toPoints.Count));
            Assert.That(toPoints.Max(), Is.LessThan(Hole * Voxel));
        }

        [Test]
        public void DistanceTo_AnyPlace_IsTheLeastOfAllTriangles()
        {
            var surface = new TestSurface(Scatter(200), Grid());
            var grid = surface.ToGrid();
            var random = new Random(13);
            for (int i = 0; i < 50; i++)
            {
                var place = random.NextDouble3(-1.5, 1.5);
                double wanted = surface.Triangles.Min(t => math.distance(place, TriangleGrid.Nearest(place,
                    surface.Vertices[t.x], surface.Vertices[t.y], surface.Vertices[t.z])));
                Assert.That(grid.DistanceTo(place, 5), Is.EqualTo(wanted));
            }
        }

        /// <summary>By area.</summary>
        static List<double3> PlacesOn(TestSurface surface, int count, ref Random random)
        {
            var ends = new double[surface.Triangles.Count];
            double area = 0;
            var at = surface.Vertices;
            for (int t = 0; t < ends.Length; t++)
            {
                var corners = surface.Triangles[t];
                ends[t] = area += math.length(math.cross(at[corners.y] - at[corners.x], at[corners.z] - at[corners.x]));
            }
            var places = new List<double3>();
            for (int i = 0; i < count; i++)
            {
                int found = Array.BinarySearch(ends, random.NextDouble() * area);
                var corners = surface.Triangles[Math.Min(found < 0 ? ~found : found, ends.Length - 1)];
                double u = random.NextDouble(), v = random.NextDouble();
                (u, v) = u + v > 1 ? (1 - u, 1 - v) : (u, v);
                places.Add(at[corners.x] + u * (at[corners.y] - at[corners.x]) + v * (at[corners.z] - at[corners.x]));
            }
            return places;
        }

        /// <summary>The faces of a cube of 3 m.</summary>
        static List<double3> Box(int count)
        {
            var random = new Random(17);
            var points = new List<double3>();
            for (int i = 0; i < count; i++)
            {
                var p = random.NextDouble3(-1.5, 1.5);
                p[i % 3] = i % 2 == 0 ? -1.5 : 1.5;
                points.Add(p + 0.01 * Gauss(ref random));
            }
            return points;
        }

        static List<double3> Scatter(int count)
        {
            var random = new Random(19);
            return Enumerable.Range(0, count).Select(_ => random.NextDouble3(-1.2, 1.2)).ToList();
        }

        [Test]
        public void Run_NoPoints_MakesNothing()
        {
            using var builder = new SurfaceBuilder(Grid(), new float3(0, 0, 1));
            using var batch = TestBatches.OfPositions(new double3(100, 0, 0));
            JobCoroutine.RunToEnd(builder.Run(default, (b, at) => b.Add(at, batch, 1)));
            Assert.That(builder.Triangles.Length, Is.Zero);
            Assert.That(builder.VoxelCount, Is.Zero);
        }

        /// <summary>Spheres fall onto a street that is scanned from 1.8 m over it, and never through what was scanned.</summary>
        [Test]
        public void Run_Street_CarriesASphereOf30CentimetresAtTenThousandPlaces()
        {
            var points = Street(400000);
            var surface = new TestSurface(points, new SurfaceGrid(Voxel, 80, Hole));
            var grid = new TriangleGrid(surface.Vertices, surface.Triangles, 3 * Voxel);
            var random = new Random(23);
            for (int i = 0; i < 10000;)
            {
                var ground = points[random.NextInt(points.Count)];
                // Nothing was scanned behind walls.
                if (Math.Abs(ground.y) > 6.6)
                    continue;
                i++;
                var rest = FallingSphere.Drop(grid, ground + new double3(0, 0, 0.7), 0.3);
                Assert.That(rest.z - 0.3, Is.GreaterThan(ground.z - 0.25), ground.ToString());
            }
        }

        /// <summary>A road with kerbs of 12 cm, pavements, and walls beside them, in steps of equal angles.</summary>
        static List<double3> Street(int rays)
        {
            var random = new Random(29);
            var points = new List<double3>();
            for (int i = 0; i < rays; i++)
            {
                double turn = random.NextDouble() * 2 * Math.PI, fall = -Math.Acos(random.NextDouble(-0.2, 0.99)) + Math.PI / 2;
                var way = new double3(new double2(Math.Cos(turn), Math.Sin(turn)) * Math.Cos(fall),
                    -Math.Sin(Math.Abs(fall)));
                double toGround = 1.8 / Math.Max(1e-9, -way.z), toWall = 7 / Math.Max(1e-9, Math.Abs(way.y));
                double reach = Math.Min(toGround, toWall);
                if (reach > 14)
                    continue;
                var p = new double3(0, 0, 1.8) + reach * way;
                // What stands on a pavement hides what is behind its kerb a little; here it is simply lifted.
                p.z += Math.Abs(p.y) > 4 ? 0.12 : 0;
                points.Add(p + 0.005 * new double3(Gauss(ref random), Gauss(ref random), Gauss(ref random)));
            }
            return points;
        }
    }
}
