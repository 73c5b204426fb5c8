using System;
using FastPoints.Picture;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Picture
{
    public class CameraFramingTests
    {
        static readonly BoundsGeo[] s_boxes =
        {
            new BoundsGeo(new double3(691_000, 5_335_000, 500), new double3(691_400, 5_335_100, 540)),
            new BoundsGeo(new double3(0, 0, 0), new double3(0, 0, 0)),
            new BoundsGeo(new double3(5e5, 5e6, 1), new double3(5e5, 5e6, 1)),
            new BoundsGeo(new double3(-1, -1, -1), new double3(1, -1, 300)),
            new BoundsGeo(new double3(-1e300, -1e300, -1e300), new double3(1e300, 1e300, 1e300)),
            BoundsGeo.Empty,
        };

        internal static Camera Frame(ViewDirection view, BoundsGeo bounds, double3[] sample, int widthPx, int heightPx,
            UpAxis upAxis) => CameraFraming.Frame(new PictureOptions
            {
                View = view,
                WidthPx = widthPx,
                HeightPx = heightPx,
                UpAxis = upAxis,
            }, bounds, sample, null, new double3(1, 1, 1));

        [Test]
        public void Frame_AnyBox_ShowsAllCornersAndFillsThePicture()
        {
            foreach (var box in s_boxes)
                foreach (ViewDirection view in Enum.GetValues(typeof(ViewDirection)))
                    foreach (UpAxis up in Enum.GetValues(typeof(UpAxis)))
                    {
                        var camera = Frame(view, box, null, 400, 300, up);
                        var bounds = box.IsEmpty ? new BoundsGeo(new double3(0, 0, 0), new double3(0, 0, 0)) : box;
                        var projection = new PointProjection(camera, PositionTransform.Identity, 400, 300);
                        double widest = 0;
                        for (int corner = 0; corner < 8; corner++)
                        {
                            Assert.That(projection.Project((corner & 1) == 0 ? bounds.Min.x : bounds.Max.x,
                                (corner & 2) == 0 ? bounds.Min.y : bounds.Max.y, (corner & 4) == 0 ? bounds.Min.z : bounds.Max.z,
                                out double x, out double y, out float depth) || depth - depth != 0, Is.True, view + " " + up);
                            Assert.That(x, Is.InRange(-0.01, 400.01), view + " " + up);
                            Assert.That(y, Is.InRange(-0.01, 300.01), view + " " + up);
                            widest = Math.Max(widest, Math.Max(Math.Abs(x - 200) / 200, Math.Abs(y - 150) / 150));
                        }
                        if (math.cmax(bounds.Size) > 0)
                            Assert.That(widest, Is.GreaterThan(0.6), view + " " + up);
                    }
        }

        [Test]
        public void Frame_FewFarPoints_DoNotShrinkTheOthers()
        {
            // A ball of points in a long box: all of it, as large as it gets, or with four of a thousand points far away.
            var random = new Unity.Mathematics.Random(5);
            var outline = new double3[1000];
            for (int i = 0; i < outline.Length; i++)
                outline[i] = math.normalize(random.NextDouble3(new double3(-1, -1, -1), new double3(1, 1, 1)));
            var box = new BoundsGeo(new double3(-50, -50, -50), new double3(50, 50, 50));
            foreach (int outliers in new[] { 0, 4 })
            {
                for (int i = 0; i < outliers; i++)
                    outline[i] = new double3(i < 2 ? 50 : -50, 40, 30);
                foreach (ViewDirection view in Enum.GetValues(typeof(ViewDirection)))
                {
                    var camera = Frame(view, box, outline, 300, 300, UpAxis.Z);
                    var projection = new PointProjection(camera, PositionTransform.Identity, 300, 300);
                    double lowest = 0, highest = 300;
                    for (int i = 4; i < outline.Length; i++)
                    {
                        var at = outline[i];
                        Assert.That(projection.Project(at.x, at.y, at.z, out double x, out double y, out _), Is.True);
                        Assert.That(x, Is.InRange(0, 300));
                        Assert.That(y, Is.InRange(0, 300));
                        lowest = Math.Max(lowest, y);
                        highest = Math.Min(highest, y);
                    }
                    Assert.That(lowest - highest, Is.GreaterThan(250), view + ", " + outliers + " strays");
                    Assert.That((lowest + highest) / 2, Is.EqualTo(150).Within(8));
                }
            }
        }

        [Test]
        public void Frame_OnePositionFarOut_IsAtLeastAUnitAway([Values(0, 1e-7)] double size)
        {
            var position = new double3(500_000, 5_400_000, 100);
            var outline = new double3[20];
            for (int i = 0; i < outline.Length; i++)
                outline[i] = position;
            var camera = Frame(ViewDirection.Auto, new BoundsGeo(position - size, position + size), outline, 300,
                300, UpAxis.Z);
            Assert.That(math.length(camera.EyeGeo - position), Is.InRange(1, 10));
        }

        [Test]
        public void Frame_Top_HasNorthAtTheTopAndEastAtTheRight()
        {
            var box = new BoundsGeo(new double3(0, 0, 0), new double3(10, 10, 10));
            var camera = Frame(ViewDirection.Top, box, null, 100, 100, UpAxis.Z);
            var projection = new PointProjection(camera, PositionTransform.Identity, 100, 100);
            projection.Project(0, 0, 5, out double westX, out double southY, out float low);
            projection.Project(10, 10, 10, out double eastX, out double northY, out float high);
            Assert.That(eastX, Is.GreaterThan(westX));
            Assert.That(northY, Is.LessThan(southY));
            Assert.That(high, Is.LessThan(low));
        }

        [Test]
        public void Frame_Front_HasUpAtTheTopAndEastAtTheRight()
        {
            var box = new BoundsGeo(new double3(0, 0, 0), new double3(10, 10, 10));
            foreach (UpAxis up in new[] { UpAxis.Z, UpAxis.Y })
            {
                var camera = Frame(ViewDirection.Front, box, null, 100, 100, up);
                var projection = new PointProjection(camera, PositionTransform.Identity, 100, 100);
                projection.Project(0, 0, 0, out double westX, out double lowY, out _);
                projection.Project(10, up == UpAxis.Y ? 10 : 0, up == UpAxis.Z ? 10 : 0, out double eastX, out double highY,
                    out _);
                Assert.That(eastX, Is.GreaterThan(westX));
                Assert.That(highY, Is.LessThan(lowY));
            }
        }

        [Test]
        public void Perspective_DegenerateDirections_StillHaveThreeAxes()
        {
            var eye = new double3(1, 2, 3);
            var up = new double3(0, 0, 1);
            double3[] targets = { eye, eye + up, eye - up, eye + new double3(1e300, 0, 1e300) };
            foreach (var target in targets)
            {
                var camera = Camera.Perspective(eye, target, up, 60);
                Assert.That(math.length(camera.Right), Is.EqualTo(1).Within(1e-12));
                Assert.That(math.length(camera.Up), Is.EqualTo(1).Within(1e-12));
                Assert.That(math.dot(camera.Right, camera.Forward), Is.EqualTo(0).Within(1e-12));
                Assert.That(math.dot(camera.Up, camera.Forward), Is.EqualTo(0).Within(1e-12));
                Assert.That(math.dot(math.cross(camera.Right, camera.Forward), camera.Up), Is.EqualTo(1).Within(1e-12));
            }
        }

        [TestCase(0), TestCase(180), TestCase(double.NaN)]
        public void Perspective_FieldOfViewOutOfRange_Throws(double fov) =>
            Assert.That(() => Camera.Perspective(new double3(0, 0, 0), new double3(1, 0, 0), new double3(0, 0, 1), fov),
                Throws.TypeOf<ArgumentOutOfRangeException>());
    }
}
