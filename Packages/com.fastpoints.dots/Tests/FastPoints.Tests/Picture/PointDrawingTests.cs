using System.Linq;
using FastPoints.Drawing;
using FastPoints.Picture;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Picture
{
    [Category("Smoke")]
    public class PointDrawingTests
    {
        const uint Red = 0xFF0000FF, Green = 0xFF00FF00, Blue = 0xFFFF0000;

        /// <summary>One unit a pixel, looking along -z from z = 10: pixel (0, 0) covers x 0 to 1 and y 3 to 4 of a 4 by 4
        /// picture.</summary>
        static Camera FromAbove(double size) => Camera.Orthographic(new double3(size / 2, size / 2, 10),
            new double3(size / 2, size / 2, 0), new double3(0, 1, 0), size);

        static PointDrawing DrawingOf(PointBatch batch, Camera camera, PositionTransform transform, int2 size,
            float largestPx = 1, bool round = false) =>
            new PointDrawing
            {
                Positions = PositionColumns.Of(batch),
                Projection = new PointProjection(camera, transform, size.x, size.y),
                Colors = ColorMapping.For(ColorMode.Rgb, new DisplayRanges { Color = ColorDepth.Bits8 }, batch, transform),
                MaxTileSizePx = largestPx,
                IsRound = round,
            };

        static RgbaImage Draw(PointBatch batch, Camera camera, int width, int height, float sizePx = 1, bool round = false)
        {
            using var canvas = new PictureCanvas(width, height, Allocator.Persistent);
            canvas.UseSize(sizePx);
            var drawing = DrawingOf(batch, camera, PositionTransform.Identity, new int2(width, height), sizePx, round);
            var drawn = canvas.ScheduleDraw(batch, 0, batch.Count, drawing, default);
            canvas.ScheduleResolve(new ResolvePictureJob { Projection = drawing.Projection }, drawn).Complete();
            return canvas.ToImage();
        }

        // Squares whose edges lie on those of pixels.
        [TestCase(2), TestCase(4)]
        public void Draw_SeveralSamplesAPixel_HasPointsAsLarge(int samplesPerEdge)
        {
            using var batch = TestBatches.OfColoredPositions(new[] { new double3(2, 2, 1), new double3(3, 1, 2) },
                new[] { Green, Red });
            using var canvas = new PictureCanvas(4, 4, Allocator.Persistent, samplesPerEdge);
            canvas.UseSize(2);
            var drawing = DrawingOf(batch, FromAbove(4), PositionTransform.Identity, 4 * samplesPerEdge, canvas.MaxTileSizePx);
            var drawn = canvas.ScheduleDraw(batch, 0, batch.Count, drawing, default);
            canvas.ScheduleResolve(new ResolvePictureJob { Projection = drawing.Projection }, drawn).Complete();
            Assert.That(canvas.ToImage().Rgba, Is.EqualTo(Draw(batch, FromAbove(4), 4, 4, 2).Rgba));
        }

        [Test]
        public void ToImage_SeveralSamplesAPixel_IsTheirMeanLight()
        {
            using var canvas = new PictureCanvas(2, 1, Allocator.Persistent, 2);
            // Row by row: the left pixel is half white, of the right one a quarter is red.
            uint[] samples = { 0xFFFFFF, 0xFFFFFF, 0xFF, 0, 0, 0, 0, 0 };
            var pixels = canvas.Pixels;
            for (int i = 0; i < samples.Length; i++)
                pixels[i] = samples[i];
            var projection = new PointProjection(FromAbove(4), PositionTransform.Identity, canvas.WidthPx, canvas.HeightPx);
            canvas.ScheduleResolve(new ResolvePictureJob { Projection = projection }, default).Complete();
            var image = canvas.ToImage();
            Assert.That(image[0, 0], Is.EqualTo(0xFFBCBCBC), "half the light is 188 of 255 in sRGB");
            Assert.That(image[1, 0], Is.EqualTo(0xFF000089), "a quarter is 137");
        }

        [Test]
        public void UseSizesOf_ASmallPicture_AreLargerForEachTile()
        {
            using var small = new PictureCanvas(20, 12, Allocator.Persistent);
            using var canvas = new PictureCanvas(20, 12, Allocator.Persistent, 4);
            var sizes = small.SizeOfTile;
            for (int i = 0; i < sizes.Length; i++)
                sizes[i] = i + 1;
            canvas.UseSizesOf(small);
            // 3 x 2 tiles of 8 pixels; 10 x 6 of 8 samples, of which 4 x 4 lie in one of the others.
            Assert.That(canvas.SizeOfTile.Length, Is.EqualTo(60));
            Assert.That(canvas.SizeOfTile[3 * 10 + 3], Is.EqualTo(4));
            Assert.That(canvas.SizeOfTile[3 * 10 + 4], Is.EqualTo(8));
            Assert.That(canvas.SizeOfTile[4 * 10 + 9], Is.EqualTo(24));
        }

        static int Covered(RgbaImage image)
        {
            int covered = 0;
            for (int y = 0; y < image.Height; y++)
                for (int x = 0; x < image.Width; x++)
                    covered += image[x, y] != 0 ? 1 : 0;
            return covered;
        }

        [TestCase(0.5, 3.5, 0, 0), TestCase(3.5, 0.5, 3, 3), TestCase(1.01, 2.99, 1, 1), TestCase(0, 4, 0, 0)]
        public void Draw_PointInPixel_CoversThatPixelAlone(double x, double y, int pixelX, int pixelY)
        {
            using var batch = TestBatches.OfColoredPositions(new[] { new double3(x, y, 1) }, new[] { Green });
            var image = Draw(batch, FromAbove(4), 4, 4);
            Assert.That(image[pixelX, pixelY], Is.EqualTo(Green));
            Assert.That(Covered(image), Is.EqualTo(1));
        }

        [TestCase(-0.01, 2), TestCase(4, 2), TestCase(2, 4.01), TestCase(2, -0.01), TestCase(double.NaN, 2)]
        [TestCase(1e300, 2), TestCase(double.PositiveInfinity, 2)]
        public void Draw_PointOutsideOrNonFinite_LeavesThePictureEmpty(double x, double y)
        {
            using var batch = TestBatches.OfColoredPositions(new[] { new double3(x, y, 1) }, new[] { Green });
            Assert.That(Covered(Draw(batch, FromAbove(4), 4, 4)), Is.EqualTo(0));
        }

        [Test]
        public void Draw_SeveralPointsInOnePixel_KeepsTheNearestInAnyOrder()
        {
            var positions = new[] { new double3(0.5, 0.5, 1), new double3(0.5, 0.5, 3), new double3(0.5, 0.5, -20) };
            var colors = new[] { Red, Green, Blue };
            int[][] orders = { new[] { 0, 1, 2 }, new[] { 1, 0, 2 }, new[] { 2, 1, 0 }, new[] { 2, 0, 1 } };
            foreach (int[] order in orders)
            {
                using var batch = TestBatches.OfColoredPositions(order.Select(i => positions[i]).ToArray(),
                    order.Select(i => colors[i]).ToArray());
                Assert.That(Draw(batch, FromAbove(1), 1, 1)[0, 0], Is.EqualTo(Green));
            }
        }

        [Test]
        public void Draw_EqualDepth_KeepsTheSmallerColourInAnyOrder()
        {
            var at = new double3(0.5, 0.5, 1);
            using var one = TestBatches.OfColoredPositions(new[] { at, at }, new[] { Red, Blue });
            using var other = TestBatches.OfColoredPositions(new[] { at, at }, new[] { Blue, Red });
            Assert.That(Draw(one, FromAbove(1), 1, 1)[0, 0], Is.EqualTo(Draw(other, FromAbove(1), 1, 1)[0, 0]));
        }

        [Test]
        public void Draw_OrthographicBehindTheEye_IsDrawn()
        {
            using var batch = TestBatches.OfColoredPositions(new[] { new double3(0.5, 0.5, 500) }, new[] { Green });
            Assert.That(Covered(Draw(batch, FromAbove(1), 1, 1)), Is.EqualTo(1));
        }

        [TestCase(2f, false, 4), TestCase(3f, false, 9), TestCase(6f, false, 36), TestCase(3f, true, 9)]
        [TestCase(5f, true, 21)]
        public void Draw_SizeInPixels_CoversTheCentresWithin(float size, bool round, int covered)
        {
            // In the middle of a pixel for odd sizes, on a corner for even ones.
            double at = size % 2 == 0 ? 8 : 8.5;
            using var batch = TestBatches.OfColoredPositions(new[] { new double3(at, at, 1) }, new[] { Green });
            var image = Draw(batch, FromAbove(16), 16, 16, size, round);
            Assert.That(Covered(image), Is.EqualTo(covered));
            Assert.That(image[8, 7], Is.EqualTo(Green));
        }

        [Test]
        public void Draw_SplatAcrossTheEdge_IsCut()
        {
            using var batch = TestBatches.OfColoredPositions(new[] { new double3(0, 16, 1) }, new[] { Green });
            var image = Draw(batch, FromAbove(16), 16, 16, 4);
            Assert.That(Covered(image), Is.EqualTo(4));
            Assert.That(image[1, 1], Is.EqualTo(Green));
        }

        [Test]
        public void Project_Perspective_DividesByDepth()
        {
            // A field of view of 90 degrees: at depth d the picture is 2 d high.
            var camera = Camera.Perspective(new double3(0, 0, 0), new double3(0, 1, 0), new double3(0, 0, 1), 90);
            var projection = new PointProjection(camera, PositionTransform.Identity, 200, 100);
            Assert.That(projection.Project(1, 10, 2, out double x, out double y, out float depth), Is.True);
            Assert.That(x, Is.EqualTo(100 + 50 * 0.1).Within(1e-9));
            Assert.That(y, Is.EqualTo(50 - 50 * 0.2).Within(1e-9));
            Assert.That(depth, Is.EqualTo(10f).Within(1e-6f));
            Assert.That(projection.Project(1, -10, 2, out _, out _, out _), Is.False);
            Assert.That(projection.Project(0, 0, 0, out _, out _, out _), Is.False);
        }

        [Test]
        public void Draw_NearAndFarAMillionTimesApart_KeepTheirOrder()
        {
            // Pairs 1e-6 of their distance apart, from a millimetre to a thousand kilometres, each in its own pixel.
            var camera = Camera.Perspective(new double3(0, 0, 0), new double3(0, 1, 0), new double3(0, 0, 1), 90);
            double[] distances = { 1e-3, 1, 1e3, 1e6 };
            foreach (double distance in distances)
            {
                var near = new double3(0, distance, 0);
                var far = new double3(0, distance * (1 + 1e-6), 0);
                using var batch = TestBatches.OfColoredPositions(new[] { far, near, far }, new[] { Red, Green, Red });
                Assert.That(Draw(batch, camera, 1, 1)[0, 0], Is.EqualTo(Green), "at " + distance);
            }
        }

        [Test]
        public void Draw_UtmCoordinates_KeepAMillimetre()
        {
            // 1 mm grid at UTM-sized offsets, seen from 2 m: points 1 mm apart are pixels apart, and 1 mm of depth is resolved.
            var corner = new double3(691_000.123, 5_335_000.456, 517.789);
            var transform = new PositionTransform { Scale = new double3(0.001, 0.001, 0.001), Offset = corner };
            using var batch = TestBatches.New(3, AttributeType.Int32, TestBatches.Colors(AttributeType.UInt16));
            int[][] grid = { new[] { 0, 0, 0 }, new[] { 1, 0, 0 }, new[] { 0, 0, 1 } };
            uint[] colors = { Red, Green, Blue };
            for (int i = 0; i < 3; i++)
            {
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, grid[i][axis]);
                for (int channel = 0; channel < 3; channel++)
                    TestBatches.Set(batch, 3 + channel, i, colors[i] >> (8 * channel) & 255);
            }
            var camera = Camera.Perspective(corner + new double3(0, 0, 2), corner, new double3(0, 1, 0), 0.5);
            using var canvas = new PictureCanvas(101, 101, Allocator.Persistent);
            var drawing = DrawingOf(batch, camera, transform, 101);
            canvas.ScheduleResolve(new ResolvePictureJob { Projection = drawing.Projection },
                canvas.ScheduleDraw(batch, 0, 3, drawing, default)).Complete();
            var image = canvas.ToImage();
            // 2 m * tan(0.5 degrees) / 101 pixels = 0.1728 mm a pixel: 1 mm is 5.79 pixels.
            Assert.That(image[50, 50], Is.EqualTo(Blue));
            Assert.That(image[56, 50], Is.EqualTo(Green));
            Assert.That(Covered(image), Is.EqualTo(2));
        }

        [Test]
        public void DepthBits_AnyDepths_KeepTheOrderAndRoundTrip()
        {
            float[] depths = { -1e30f, -1, -1e-40f, 0, 1e-40f, 1e-3f, 1, 1.0000001f, 1e30f };
            for (int i = 0; i < depths.Length; i++)
            {
                uint bits = PointProjection.DepthToBits(depths[i]);
                Assert.That(PointProjection.DepthFromBits(bits), Is.EqualTo(depths[i]));
                if (i > 0)
                    Assert.That(bits, Is.GreaterThan(PointProjection.DepthToBits(depths[i - 1])));
            }
        }

        [Test]
        public void Draw_AnyNumberOfWorkers_GivesTheSamePicture()
        {
            using var batch = TestBatches.Scan(40_000, 9);
            var transform = new PositionTransform { Scale = new double3(0.001, 0.001, 0.001), Offset = new double3(5e5, 5e6, 0) };
            var bounds = PositionBounds.RunImmediate(batch, transform).Bounds;
            var camera = CameraFramingTests.Frame(ViewDirection.Iso, bounds, null, 160, 120, UpAxis.Z);
            byte[] first = null;
            foreach (int workers in new[] { 1, 2, 7 })
            {
                using var count = new WorkerCount(workers);
                using var canvas = new PictureCanvas(160, 120, Allocator.Persistent);
                canvas.UseSize(2.5f);
                var drawing = DrawingOf(batch, camera, transform, new int2(160, 120), 2.5f);
                drawing.Colors.Scale = 1 / 256.0;
                JobHandle drawn = default;
                for (int start = 0; start < batch.Count; start += 10_000)
                    drawn = JobHandle.CombineDependencies(drawn, canvas.ScheduleDraw(batch, start, 10_000, drawing, default));
                canvas.ScheduleResolve(new ResolvePictureJob { Projection = drawing.Projection, EdlStrength = 0.3f },
                    drawn).Complete();
                var image = canvas.ToImage();
                first ??= image.Rgba;
                Assert.That(image.Rgba, Is.EqualTo(first), workers + " workers");
                Assert.That(Covered(image), Is.GreaterThan(3000));
            }
        }
    }
}
