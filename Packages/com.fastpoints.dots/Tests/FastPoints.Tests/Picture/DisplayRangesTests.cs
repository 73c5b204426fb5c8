using FastPoints.Drawing;
using FastPoints.Picture;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Picture
{
    public class DisplayRangesTests
    {
        static DisplayRanges Measure(PointBatch batch)
        {
            var ranges = new DisplayRanges();
            JobCoroutine.RunToEnd(ranges.Measure(batch, PositionTransform.Identity, UpAxis.Z));
            return ranges;
        }

        static PointBatch Colored(AttributeType type, params double[] values)
        {
            var batch = TestBatches.New(values.Length, AttributeType.Float32, TestBatches.Colors(type));
            for (int i = 0; i < values.Length; i++)
            {
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, i + axis);
                for (int channel = 0; channel < 3; channel++)
                    TestBatches.Set(batch, 3 + channel, i, channel == 1 ? values[i] : 0);
            }
            return batch;
        }

        [TestCase(AttributeType.UInt8, 200, ColorDepth.Bits8)]
        [TestCase(AttributeType.UInt16, 255, ColorDepth.Bits8)]
        [TestCase(AttributeType.UInt16, 256, ColorDepth.None)]
        [TestCase(AttributeType.UInt16, 4096, ColorDepth.Bits16)]
        [TestCase(AttributeType.UInt16, 65535, ColorDepth.Bits16)]
        [TestCase(AttributeType.Float32, 1, ColorDepth.Unit)]
        [TestCase(AttributeType.Float32, 0.25, ColorDepth.Unit)]
        [TestCase(AttributeType.Float32, 254, ColorDepth.Bits8)]
        [TestCase(AttributeType.Float64, double.NaN, ColorDepth.None)]
        [TestCase(AttributeType.UInt16, 0, ColorDepth.None)]
        [TestCase(AttributeType.Float32, 0, ColorDepth.None)]
        public void Measure_Colour_UsesTheMaximumOnce(AttributeType type, double max, ColorDepth depth)
        {
            using var batch = Colored(type, 0, max, 0);
            var ranges = Measure(batch);
            Assert.That(ranges.Color, Is.EqualTo(depth));
            Assert.That(ranges.Resolve(ColorMode.Auto),
                Is.EqualTo(depth == ColorDepth.None ? ColorMode.Elevation : ColorMode.Rgb));
            Assert.That(ranges.Resolve(ColorMode.Rgb), Is.EqualTo(ranges.Resolve(ColorMode.Auto)));
        }

        [Test]
        public void Measure_EightBitsInSixteen_ReportsIt()
        {
            using var batch = Colored(AttributeType.UInt16, 10, 255);
            Assert.That(Measure(batch).Assumptions, Has.Some.Contains("read as 8-bit"));
        }

        [Test]
        public void Measure_BlackColour_ReportsIt()
        {
            using var batch = Colored(AttributeType.UInt16, 0, 0);
            Assert.That(Measure(batch).Assumptions, Has.Some.Contains("black"));
        }

        [Test]
        public void Measure_FewOutliers_DoNotEnlargeTheRobustBounds()
        {
            var positions = new double3[10_000];
            var random = new Unity.Mathematics.Random(21);
            for (int i = 0; i < positions.Length; i++)
                positions[i] = random.NextDouble3(new double3(100, 200, 10), new double3(200, 300, 20));
            positions[17] = new double3(1e9, 250, 1e6);
            positions[5000] = new double3(150, -1e9, -1e6);
            using var batch = TestBatches.OfPositions(positions);
            var ranges = Measure(batch);
            Assert.That(ranges.Full.Max.x, Is.EqualTo(1e9));
            Assert.That(ranges.Robust.Max.x, Is.InRange(200, 215));
            Assert.That(ranges.Robust.Min.y, Is.InRange(185, 200));
            Assert.That(ranges.ElevationLow, Is.InRange(10, 10.2));
            Assert.That(ranges.ElevationHigh, Is.InRange(19.8, 20));
        }

        [Test]
        public void Measure_IntensityThatVaries_HasItsRange()
        {
            using var batch = TestBatches.Scan(5000, 4);
            var ranges = Measure(batch);
            Assert.That(ranges.IntensityVaries, Is.True);
            Assert.That(ranges.IntensityLow, Is.InRange(10, 90));
            Assert.That(ranges.IntensityHigh, Is.InRange(3900, 4000));
            Assert.That(ranges.Color, Is.EqualTo(ColorDepth.Bits16));
        }

        [TestCase(0, 0, ColorMode.Elevation), TestCase(0, 1, ColorMode.Elevation), TestCase(2, 2, ColorMode.Elevation)]
        [TestCase(2, 1, ColorMode.Elevation), TestCase(1, 2, ColorMode.Classification), TestCase(2, 6, ColorMode.Classification)]
        public void Resolve_WithoutColour_IsClassesWhereTheyAreSetElseElevation(int one, int other, ColorMode mode)
        {
            using var batch = TestBatches.Scan(5000, 4);
            for (int i = 0; i < batch.Count; i++)
                TestBatches.Set(batch, 4, i, i % 3 == 0 ? one : other);
            var ranges = Measure(batch);
            Assert.That(ranges.Resolve(ColorMode.Auto), Is.EqualTo(ColorMode.Rgb));
            ranges.Color = ColorDepth.None;
            Assert.That(ranges.Resolve(ColorMode.Auto), Is.EqualTo(mode));
            Assert.That(ranges.Resolve(ColorMode.Intensity), Is.EqualTo(ColorMode.Intensity));
        }

        [Test]
        public void Measure_Classes_AreTheExistingOnes()
        {
            using var batch = TestBatches.Scan(5000, 4);
            for (int i = 0; i < batch.Count; i++)
                TestBatches.Set(batch, 4, i, i % 3 == 0 ? 2 : 6);
            Assert.That(Measure(batch).Classes, Is.EqualTo(new[] { 2, 6 }));
        }

        [TestCase(0), TestCase(1), TestCase(2)]
        public void UpGuess_GroundAcrossAnAxis_IsThatAxis(int axis)
        {
            var random = new Unity.Mathematics.Random(3);
            var positions = new double3[4000];
            for (int i = 0; i < positions.Length; i++)
            {
                positions[i] = random.NextDouble3(new double3(0, 0, 0), new double3(100, 80, 60));
                if (i % 3 == 0)
                    positions[i][axis] = random.NextDouble(0, 1);
            }
            Assert.That(UpAxisGuess.Of(positions, out string reason), Is.EqualTo((UpAxis)axis));
            Assert.That(reason, Does.Match("^[XYZ] is taken for up: [34]. % of the points lie in one plane across it$"));
        }

        [TestCase(0, UpAxis.Y, "model"), TestCase(500_000, UpAxis.Z, "survey")]
        public void UpGuess_NoPlane_IsYOfModelsAndZOfSurveys(double x, UpAxis up, string kind)
        {
            var random = new Unity.Mathematics.Random(3);
            var ball = new double3[4000];
            for (int i = 0; i < ball.Length; i++)
                ball[i] = math.normalize(random.NextDouble3(new double3(-1, -1, -1), new double3(1, 1, 1)))
                    + new double3(x, 0, 0);
            Assert.That(UpAxisGuess.Of(ball, out string reason), Is.EqualTo(up));
            Assert.That(reason, Does.Contain("no plane").And.Contains(kind));
            Assert.That(UpAxisGuess.Of(new double3[0], out _), Is.EqualTo(UpAxis.Z));
        }

        [Test]
        public void Measure_FarthestPoints_AreExtremePointsExceptOutliers()
        {
            var random = new Unity.Mathematics.Random(5);
            var positions = new double3[30_000];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = random.NextDouble3(new double3(0, 0, 0), new double3(100, 50, 1));
            positions[777] = new double3(60, 20, 70);
            positions[778] = new double3(1e5, 20, 0);
            using var batch = TestBatches.OfPositions(positions);
            var ranges = Measure(batch);
            Assert.That(ranges.Robust.Contains(positions[777]), Is.False);
            Assert.That(ranges.ExtremePoints, Has.Member(positions[777]).And.No.Member(positions[778]));
            foreach (ViewDirection view in System.Enum.GetValues(typeof(ViewDirection)))
            {
                // From there the slab is so narrow that the point would make the picture more than three times as large.
                if (view == ViewDirection.Left || view == ViewDirection.Right)
                    continue;
                var options = new PictureOptions { View = view, WidthPx = 640, HeightPx = 360 };
                var projection = new PointProjection(new PicturePlan(options, ranges, PositionTransform.Identity).Camera,
                    PositionTransform.Identity, 640, 360);
                for (int i = 0; i < positions.Length; i++)
                {
                    projection.Project(positions[i].x, positions[i].y, positions[i].z, out double x, out double y, out _);
                    if (i != 778)
                        Assert.That(x >= 8 && x <= 632 && y >= 8 && y <= 352, view + " " + i + ": " + x + ", " + y);
                }
            }
        }

        [Test]
        public void Measure_OnePoint_HasBoundsOfThatPoint()
        {
            using var batch = TestBatches.OfPositions(new double3(1, 2, 3));
            var ranges = Measure(batch);
            Assert.That(ranges.Robust.Min, Is.EqualTo(new double3(1, 2, 3)));
            Assert.That(ranges.Robust.Max, Is.EqualTo(new double3(1, 2, 3)));
            Assert.That(ranges.ElevationLow, Is.EqualTo(ranges.ElevationHigh));
        }

        [Test]
        public void Measure_NoFinitePosition_HasNoBoundsAndReportsIt()
        {
            using var batch = TestBatches.OfPositions(new double3(double.NaN, 0, 0), new double3(0, double.PositiveInfinity, 0));
            var ranges = Measure(batch);
            Assert.That(ranges.Full.IsEmpty, Is.True);
            Assert.That(ranges.Robust.IsEmpty, Is.True);
            Assert.That(ranges.NonFiniteCount, Is.EqualTo(2));
            Assert.That(ranges.Assumptions, Has.Some.Contains("no point has a position"));
        }

        [Test]
        public void Measure_EmptyBatch_HasNoBounds()
        {
            using var batch = TestBatches.OfPositions();
            Assert.That(Measure(batch).Full.IsEmpty, Is.True);
        }
    }
}
