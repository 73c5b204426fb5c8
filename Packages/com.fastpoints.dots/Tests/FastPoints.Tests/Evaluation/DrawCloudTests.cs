using System;
using System.Linq;
using FastPoints.Drawing;
using FastPoints.Evaluation;
using FastPoints.Picture;
using FastPoints.Tests.Picture;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Evaluation
{
    public class DrawCloudTests
    {
        static PictureOptions Small() => new PictureOptions { WidthPx = 160, HeightPx = 120 };

        static MemoryPointReader Scan(int points, int pointsPerBlock, bool fixedStride = true) =>
            new MemoryPointReader(TestBatches.Scan(points, 8), pointsPerBlock, fixedStride);

        static DrawCloud Draw(MemoryPointReader reader, PictureOptions options, long budget = 0)
        {
            var draw = new DrawCloud(reader, options, budget);
            JobCoroutine.RunToEnd(draw.Run(new StageProgress()));
            return draw;
        }

        static PreviewPicture Preview(MemoryPointReader reader, PreviewOptions options)
        {
            var preview = new PreviewPicture(reader, options);
            JobCoroutine.RunToEnd(preview.Run(new StageProgress()));
            return preview;
        }

        [Test]
        public void Draw_WholeSourceAsSampleOrByBlocks_IsTheSamePicture()
        {
            // 600,000 points are more than the pictures are planned with: drawn block by block. The budget is met by a sample of
            // all.
            using var reader = Scan(600_000, 50_000);
            var options = Small();
            options.PointSizePx = 1;
            options.Camera = CameraFramingTests.Frame(ViewDirection.Iso, PositionBounds.RunImmediate(reader.Points,
                PositionTransform.Identity).Bounds, null, 160, 120, UpAxis.Z);
            var blocks = Draw(reader, options);
            using var preview = Preview(reader, new PreviewOptions { Points = 600_000, Exact = true, Picture = options });
            Assert.That(blocks.PointsDrawn, Is.EqualTo(600_000));
            Assert.That(preview.Sample.HasAllPoints, Is.True);
            Assert.That(blocks.Image.Rgba, Is.EqualTo(preview.Image.Rgba));
        }

        [Test]
        public void Draw_AnyWorkersAndBlocks_IsTheSamePicture()
        {
            byte[] first = null;
            foreach (int workers in new[] { 1, 2, 7 })
            {
                using var count = new WorkerCount(workers);
                using var reader = Scan(30_000, 1000 + 777 * workers);
                var image = Draw(reader, Small(), 20_000).Image;
                first ??= image.Rgba;
                Assert.That(image.Rgba, Is.EqualTo(first));
            }
        }

        [Test]
        public void Draw_Budget_DrawsExactlyAsMany()
        {
            using var reader = Scan(30_000, 5000);
            Assert.That(Draw(reader, Small(), 1000).PointsDrawn, Is.EqualTo(1000));
            Assert.That(Draw(reader, Small(), 100_000).PointsDrawn, Is.EqualTo(30_000));
        }

        [Test]
        public void Draw_ModeThatTheSourceLacks_FallsBackAndReportsIt()
        {
            using var reader = new MemoryPointReader(TestBatches.OfPositions(new double3(0, 0, 0), new double3(1, 1, 1)), 10);
            var options = Small();
            options.Color = ColorMode.Classification;
            var draw = Draw(reader, options);
            Assert.That(draw.Plan.Mode, Is.EqualTo(ColorMode.Elevation));
            Assert.That(draw.Plan.Assumptions, Has.Some.Contains("no classification"));
        }

        [Test]
        public void Draw_EachMode_ShowsThePoints()
        {
            using var reader = Scan(20_000, 5000);
            foreach (ColorMode mode in Enum.GetValues(typeof(ColorMode)))
            {
                var options = Small();
                options.Color = mode;
                var image = Draw(reader, options).Image;
                int covered = Enumerable.Range(0, 160 * 120).Count(i => image[i % 160, i / 160] != options.Background);
                Assert.That(covered, Is.GreaterThan(160 * 120 / 4), mode.ToString());
            }
        }

        [Test]
        public void Draw_NothingToDraw_IsAnEmptyPicture()
        {
            using var none = new MemoryPointReader(TestBatches.OfPositions(), 10);
            using var lost = new MemoryPointReader(TestBatches.OfPositions(new double3(double.NaN, 0, 0)), 10);
            foreach (var reader in new[] { none, lost })
            {
                var options = Small();
                var image = Draw(reader, options).Image;
                Assert.That(image[80, 60], Is.EqualTo(options.Background));
            }
        }

        [Test]
        public void Preview_FewPointsOfMany_LooksLikeAllOfThem()
        {
            using var reader = Scan(400_000, 20_000);
            var options = Small();
            options.Color = ColorMode.Elevation;
            options.Camera = CameraFramingTests.Frame(ViewDirection.Iso, PositionBounds.RunImmediate(reader.Points,
                PositionTransform.Identity).Bounds, null, 160, 120, UpAxis.Z);
            using var preview = Preview(reader, new PreviewOptions { Points = 40_000, Picture = options });
            var all = Draw(reader, options).Image;
            var error = ImageError.Compare(preview.Image, all, options.Background);
            Assert.That(preview.Sample.Count, Is.EqualTo(40_000));
            Assert.That(error.Uncovered, Is.LessThan(0.05));
            Assert.That(error.Psnr, Is.GreaterThan(20));
        }

        [Test]
        public void Preview_Stages_AreReported()
        {
            using var reader = Scan(5000, 1000);
            var progress = new StageProgress();
            using var preview = new PreviewPicture(reader, new PreviewOptions { Picture = Small() });
            JobCoroutine.RunToEnd(preview.Run(progress));
            Assert.That(progress.Finished.Select(stage => stage.Name), Is.EqualTo(new[] { "sample", "draw" }));
        }
    }
}
