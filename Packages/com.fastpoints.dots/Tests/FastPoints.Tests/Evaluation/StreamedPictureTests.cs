using FastPoints.Drawing;
using FastPoints.Evaluation;
using FastPoints.Picture;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Evaluation
{
    public class StreamedPictureTests
    {
        StreamedTestCloud m_cloud;

        [OneTimeSetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud(60_000, 4000);

        [OneTimeTearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        static PictureOptions Options(Camera camera) => new PictureOptions
        {
            WidthPx = StreamedTestCloud.WidthPx,
            HeightPx = StreamedTestCloud.HeightPx,
            Camera = camera,
            PointSizePx = 2,
        };

        RgbaImage DrawStreamed(Camera camera, CloudPlacement? placement) => DrawStreamed(Options(camera), placement);

        RgbaImage DrawStreamed(PictureOptions options, CloudPlacement? placement)
        {
            var camera = options.Camera.Value;
            using var stream = StreamedTestCloud.Stream();
            var source = m_cloud.Open();
            int cloud = stream.Add(source, placement ?? StreamedTestCloud.Geo(source));
            StreamedTestCloud.Settle(stream, camera);
            var ranges = new DisplayRanges { Color = ColorDepth.Bits16 };
            var plan = new PicturePlan(options, ranges, source.Grid.TransformFromCorner(source.Root.Corner));
            using var picture = new StreamedPicture(options);
            picture.Add(new StreamedBlocks(stream, cloud, plan), ColorMode.Rgb);
            return picture.Draw(camera);
        }

        [Test]
        public void Draw_AllResident_MatchesTheStoredCloud()
        {
            var camera = StreamedTestCloud.Near(40, 60, 0.8);
            DrawConvertedCloud stored;
            using (var folder = CloudFolder.Open(m_cloud.Path))
            {
                stored = new DrawConvertedCloud(folder, Options(camera), 1_000_000);
                JobCoroutine.RunToEnd(stored.Run(null));
            }
            var streamed = DrawStreamed(camera, null);
            int differ = 0;
            for (int y = 0; y < streamed.Height; y++)
                for (int x = 0; x < streamed.Width; x++)
                    differ += streamed[x, y] != stored.Image[x, y] ? 1 : 0;
            // Nodes finer than the other way draws lie between its points.
            Assert.That(differ, Is.LessThan(0.02 * streamed.Width * streamed.Height));
            Assert.That(ImageError.Compare(streamed, stored.Image, Options(camera).Background).Psnr, Is.GreaterThan(30));
        }

        [Test]
        public void Draw_CloudAndCameraMovedTogether_IsTheSamePicture()
        {
            var camera = StreamedTestCloud.Near(40, 60, 0.8);
            var wanted = DrawStreamed(camera, null);
            CloudPlacement placement;
            using (var source = m_cloud.Open())
                placement = StreamedTestCloud.Geo(source);

            // A thousand times smaller, turned by a right angle about the vertical, and at another position.
            var linear = new double3x3(new double3(0, 0.001, 0), new double3(-0.001, 0, 0), new double3(0, 0, 0.001));
            var origin = new double3(1000, -2000, 30);
            placement.OriginWorld = math.mul(linear, placement.OriginWorld) + origin;
            placement.Linear = linear;
            var moved = camera;
            moved.EyeGeo = math.mul(linear, camera.EyeGeo) + origin;
            moved.Right = math.mul(linear, camera.Right) * 1000;
            moved.Up = math.mul(linear, camera.Up) * 1000;
            moved.Forward = math.mul(linear, camera.Forward) * 1000;
            var got = DrawStreamed(moved, placement);
            int differ = 0;
            for (int y = 0; y < got.Height; y++)
                for (int x = 0; x < got.Width; x++)
                    differ += got[x, y] != wanted[x, y] ? 1 : 0;
            Assert.That(differ, Is.LessThan(0.002 * got.Width * got.Height));
        }

        [Test]
        public void Draw_SeveralSamplesAPixel_HasAdaptivePointsAsLarge()
        {
            var camera = StreamedTestCloud.Near(100, 100, 0.8);
            double one = Covered(DrawAdaptive(camera, 1)), four = Covered(DrawAdaptive(camera, 4));
            Assert.That(one, Is.InRange(0.02, 0.5));
            Assert.That(four, Is.EqualTo(one).Within(0.02 * one));
        }

        RgbaImage DrawAdaptive(Camera camera, int samplesPerEdge)
        {
            var options = Options(camera);
            // Near points are cut to the largest size.
            var size = PointSize.Adaptive(0.5f);
            size.MaxPx = 4;
            (options.PointSizePx, options.SizeInWorld, options.SamplesPerEdge) = (0, size, samplesPerEdge);
            return DrawStreamed(options, null);
        }

        // Of light: with several samples a pixel may be covered in part.
        static double Covered(RgbaImage image)
        {
            using var light = Palettes.CreateSrgbToLinear(Allocator.Persistent);
            double sum = 0;
            for (int i = 1; i < image.Rgba.Length; i += 4)
                sum += light[image.Rgba[i]];
            return sum / (image.Rgba.Length / 4);
        }

        [Test]
        public void DrawKept_OtherNodesSince_IsWhatWasDrawn()
        {
            var near = StreamedTestCloud.Near(40, 60, 0.8);
            var options = Options(near);
            (options.PointSizePx, options.SizeInWorld) = (0, PointSize.Adaptive());
            // Too small for both views: what the first one needs leaves the pool.
            using var stream = StreamedTestCloud.Stream(256 << 10, 64 << 10);
            var source = m_cloud.Open();
            int cloud = stream.Add(source, StreamedTestCloud.Geo(source));
            var plan = new PicturePlan(options, new DisplayRanges { Color = ColorDepth.Bits16 },
                source.Grid.TransformFromCorner(source.Root.Corner));
            using var picture = new StreamedPicture(options);
            picture.Add(new StreamedBlocks(stream, cloud, plan), ColorMode.Rgb);
            StreamedTestCloud.Rest(stream, near);
            var wanted = picture.Draw(near);
            picture.Keep();
            StreamedTestCloud.Rest(stream, StreamedTestCloud.Near(140, 140, 3.9));
            Assert.That(picture.Draw(near).Rgba, Is.Not.EqualTo(wanted.Rgba), "other nodes are drawn");
            Assert.That(picture.DrawKept(near).Rgba, Is.EqualTo(wanted.Rgba));
        }
    }
}
