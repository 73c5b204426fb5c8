using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Drawing;
using FastPoints.Picture;
using FastPoints.Sampling;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Picture
{
    [Category("Smoke")]
    public class PreviewPictureTests
    {
        [Test]
        public void WaveReady_BlocksReadDeeper_IsCalledForEachWave()
        {
            var batch = TestBatches.New(600_000, PositionColumns.Attributes(AttributeType.Int32));
            for (int i = 0; i < batch.Count; i++)
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, axis == 2 ? 0 : axis == 1 ? i / 800 : i % 800);
            using var reader = new MemoryPointReader(batch, 10_000, fixedStride: false);
            using var preview = new PreviewPicture(reader, new PreviewOptions { Points = 200_000 });
            var waves = new List<PreviewSample.Wave>();
            preview.WaveReady += (sample, wave) =>
            {
                waves.Add(wave);
                Assert.That(sample.Count, Is.EqualTo(wave.Points));
                // Reported properties hold for all of the cloud.
                var places = sample.Points.Column<int>(AttributeNames.Y);
                Assert.That(places.ToArray().Take(sample.Count).Max() - places.ToArray().Take(sample.Count).Min(),
                    Is.GreaterThan(700));
            };
            JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()));
            // 2,000 and 20,000 of prefixes, a fifth, a half, all.
            Assert.That(waves, Has.Count.EqualTo(5));
            Assert.That(waves, Is.EqualTo(preview.Waves));
            Assert.That(waves.Select(w => w.Seconds), Is.Ordered);
            Assert.That(waves.Select(w => w.BytesRead), Is.Ordered);
            Assert.That(waves[waves.Count - 1].Points, Is.EqualTo(preview.Sample.Count));
        }

        /// <summary>A wavy square of 100 x 100 around a place.</summary>
        static double3[] Square(double3 position, double3 lengths)
        {
            var positions = new double3[10_000];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = position + new double3(i % 100, i / 100, 5 * Math.Sin(i % 100 * 0.1)) * lengths;
            return positions;
        }

        static PreviewPicture Draw(PointBatch batch, double metresPerUnit = 0)
        {
            using var reader = new MemoryPointReader(batch, 1000, fixedStride: false);
            reader.Info.Crs.MetresPerUnit = metresPerUnit;
            var preview = new PreviewPicture(reader, new PreviewOptions { Points = 10_000 });
            JobCoroutine.RunToEnd(preview.Run(new StageProgress()));
            return preview;
        }

        /// <summary>Pixels that can be told from the background, of 1280 x 720.</summary>
        static int LitPx(PreviewPicture preview)
        {
            uint background = new PictureOptions().Background;
            int lit = 0;
            for (int y = 0; y < preview.Image.Height; y++)
                for (int x = 0; x < preview.Image.Width; x++)
                {
                    int difference = 0;
                    for (int channel = 0; channel < 24; channel += 8)
                        difference = Math.Max(difference, Math.Abs((int)(preview.Image[x, y] >> channel & 255)
                            - (int)(background >> channel & 255)));
                    lit += difference > 12 ? 1 : 0;
                }
            return lit;
        }

        const int AFifthOfThePicture = 1280 * 720 / 5;

        [Test]
        public void Picture_OfPointsWithoutAttributes_IsColouredByHeight()
        {
            using var batch = TestBatches.OfPositions(Square(new double3(4e5, 5e6, 100), 1));
            using var preview = Draw(batch);
            Assert.That(LitPx(preview), Is.GreaterThan(AFifthOfThePicture));
            Assert.That(preview.Plan.Assumptions, Has.Some.EqualTo("coloured by elevation"));
        }

        [Test]
        public void Picture_OfAFlatCloud_IsSeen()
        {
            using var batch = TestBatches.OfPositions(Square(new double3(4e5, 5e6, 100), new double3(1, 1, 0)));
            using var preview = Draw(batch);
            Assert.That(LitPx(preview), Is.GreaterThan(AFifthOfThePicture));
        }

        [TestCase(1), TestCase(1000)]
        public void Picture_WithPointsAsFarAs1e9_FramesTheOthersAndReportsIt(int farPoints)
        {
            var positions = Square(new double3(4e5, 5e6, 100), 1);
            for (int i = 0; i < farPoints; i++)
                positions[i * 10] = new double3(1e9, -1e9, 1e9);
            using var batch = TestBatches.OfPositions(positions);
            using var preview = Draw(batch);
            Assert.That(LitPx(preview), Is.GreaterThan(AFifthOfThePicture));
            Assert.That(preview.Plan.Assumptions, Has.Some.Contains("these are framed"));
        }

        [TestCase(2, 5, 100, "50 %"), TestCase(2, 5, 1e6, "50 %"), TestCase(2, 3, 40, "70 %")]
        [TestCase(2, 9, 40, "most"), TestCase(3, 4, 300, "40 %")]
        public void Picture_OfPartsFarApart_FramesTheLargestAndReportsIt(int parts, int ofLast, double edges, string share)
        {
            var positions = Square(new double3(4e5, 5e6, 100), 1);
            double edge = positions.Max(p => p.x) - positions.Min(p => p.x);
            for (int i = 0; i < positions.Length; i++)
            {
                int part = i % 10 >= 10 - ofLast ? parts - 1 : i % 10 % (parts - 1);
                positions[i] += new double3(part, part % 2, 0) * edges * edge;
            }
            using var batch = TestBatches.OfPositions(positions);
            using var preview = Draw(batch);
            // Each part lacks columns of the square. All parts together would be a few hundred pixels.
            Assert.That(LitPx(preview), Is.GreaterThan(AFifthOfThePicture / 4));
            Assert.That(preview.Plan.Assumptions, Has.Some.Contains(share + " within").And.Contains("these are framed"));
        }

        [Test]
        public void Picture_OfPartsThatAreNotSoFarApart_FramesAll()
        {
            var positions = Square(new double3(4e5, 5e6, 100), 1);
            double edge = positions.Max(p => p.x) - positions.Min(p => p.x);
            for (int i = 0; i < positions.Length; i += 2)
                positions[i].x += 5 * edge;
            using var batch = TestBatches.OfPositions(positions);
            using var preview = Draw(batch);
            Assert.That(preview.Ranges.Robust.Size.x, Is.GreaterThan(5 * edge));
        }

        [TestCase(0u, "black")]
        [TestCase(0x060504u, "black or nearly so")]
        public void Picture_OfBlackColours_IsColouredByHeightAndReportsIt(uint color, string expected)
        {
            var positions = Square(default, 1);
            using var batch = TestBatches.OfColoredPositions(positions, Enumerable.Repeat(color, positions.Length).ToArray());
            using var preview = Draw(batch);
            Assert.That(LitPx(preview), Is.GreaterThan(AFifthOfThePicture));
            Assert.That(preview.Plan.Assumptions, Has.Some.Contains(expected));
            Assert.That(preview.Plan.Mode, Is.EqualTo(ColorMode.Elevation));
        }

        [Test]
        public void Picture_OfBlackColoursButForOne_IsColouredByHeight()
        {
            var positions = Square(default, 1);
            var colors = new uint[positions.Length];
            colors[77] = 0xFFFFFF;
            using var batch = TestBatches.OfColoredPositions(positions, colors);
            using var preview = Draw(batch);
            Assert.That(LitPx(preview), Is.GreaterThan(AFifthOfThePicture));
        }

        [Test]
        public void Picture_OfEqualPoints_ShowsThem()
        {
            using var batch = TestBatches.OfPositions(Enumerable.Repeat(new double3(4e5, 5e6, 100), 1000).ToArray());
            using var preview = Draw(batch);
            Assert.That(LitPx(preview), Is.GreaterThan(0));
        }

        [TestCase(double.NaN, "the CRS says so"), TestCase(0, "by their size")]
        public void Picture_InDegrees_HasTheAspectInMetresAndReportsIt(double metresPerUnit, string expected)
        {
            using var metres = TestBatches.OfPositions(Square(new double3(4e5, 5e6, 100), 1));
            using var wanted = Draw(metres);
            double degree = 1 / 111_320.0;
            using var batch = TestBatches.OfPositions(Square(new double3(13.4, 52, 100),
                new double3(degree / Math.Cos(52 * Math.PI / 180), degree, 1)));
            using var preview = Draw(batch, metresPerUnit);
            Assert.That(LitPx(preview), Is.EqualTo(LitPx(wanted)).Within(2).Percent);
            Assert.That(preview.Plan.Assumptions, Has.Some.Contains(expected));
        }

        [Test]
        public void Picture_OfATowerNearTheOrigin_IsNotInDegrees()
        {
            using var batch = TestBatches.OfPositions(Square(default, new double3(0.01, 0.01, 4)));
            using var preview = Draw(batch);
            Assert.That(preview.Ranges.LengthsPerUnit, Is.EqualTo(new double3(1, 1, 1)));
        }
    }
}
