using System.Linq;
using FastPoints.Core;
using FastPoints.Picture;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Picture
{
    public class CloseSurfacesTests
    {
        const int Edge = 64;
        const float Typical = 2;

        /// <summary>Sizes of the tiles that a cell of 16 units at (x, 0, z) fills, seen along z with a pixel a unit; others keep
        /// 1.</summary>
        static float[] Close(params SparseCell[] cells)
        {
            using var drawn = new NativeArray<SparseCell>(cells, Allocator.TempJob);
            using var sizes = new NativeArray<float>(Edge * Edge / PointSizing.PixelsPerTile, Allocator.TempJob);
            var all = sizes;
            for (int tile = 0; tile < all.Length; tile++)
                all[tile] = 1;
            var camera = new Camera
            {
                IsOrthographic = true,
                HeightGeo = Edge,
                EyeGeo = new double3(0, 0, -100),
                Right = new double3(1, 0, 0),
                Up = new double3(0, 1, 0),
                Forward = new double3(0, 0, 1),
            };
            new CloseSurfacesJob
            {
                Cells = drawn,
                Projection = new PointProjection(camera, PositionTransform.Identity, Edge, Edge),
                TypicalPx = Typical,
                SizeOfTile = sizes,
            }.Schedule().Complete();
            return sizes.ToArray();
        }

        static SparseCell Cell(double x, double z, double points) =>
            new SparseCell { Center = new double3(x, 0, z), Edge = 16, PointsDrawn = points };

        [Test]
        public void Sizes_OfAThinSurface_GrowAndNoOthers()
        {
            var sizes = Close(Cell(0, 0, 10));
            Assert.That(sizes.Count(s => s > 1), Is.EqualTo(9));
            Assert.That(sizes.Max(), Is.EqualTo(PointSizing.Limit(PointSizing.SizeFor(10 / (16 * 16 * 0.35)), Typical)));
        }

        [Test]
        public void Sizes_GoByTheSurfaceInFront()
        {
            Assert.That(Close(Cell(0, 0, 10), Cell(0, 50, 100_000)), Is.EqualTo(Close(Cell(0, 0, 10))));
            Assert.That(Close(Cell(0, 50, 10), Cell(0, 0, 100_000)), Has.All.EqualTo(1));
        }

        [Test]
        public void Sizes_OfCellsBesideThePicture_ChangeNothing() => Assert.That(Close(Cell(100, 0, 10)), Has.All.EqualTo(1));
    }
}
