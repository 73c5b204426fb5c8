using System;
using System.IO;
using System.Linq;
using FastPoints.Drawing;
using FastPoints.Queries;
using FastPoints.Store;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Queries
{
    [Category("Smoke")]
    public sealed class PointPickerTests
    {
        PickTestCloud m_cloud;
        PointPicker m_picker;
        CloudPlacement m_geo;

        static PickOptions EveryPoint => new PickOptions { FinestSpacingShare = 0 };

        [OneTimeSetUp]
        public void Convert()
        {
            m_cloud = new PickTestCloud();
            m_picker = m_cloud.Picker();
            m_geo = CloudPlacement.Geo(m_picker.Source.Grid, m_picker.Source.Root);
            Assert.That(m_cloud.ChunkFiles.Length, Is.GreaterThan(4));
        }

        [OneTimeTearDown]
        public void Delete()
        {
            m_picker.Dispose();
            m_cloud.Dispose();
        }

        static readonly CloudPlacement[] s_placements =
        {
            new CloudPlacement(double3x3.identity, new double3(-20, 3, 7)),
            new CloudPlacement(new double3x3(new double3(0, 2, 0), new double3(-3, 0, 0), new double3(0, 0, 0.5)),
                new double3(691_000, 5_334_000, 520)),
            // Mirrored, sheared, a thousandth of its size.
            new CloudPlacement(new double3x3(new double3(0.001, 0.0002, 0), new double3(0.0003, -0.001, 0.0001),
                new double3(0, 0, 0.0011)), new double3(1, 2, 3)),
        };

        [Test]
        public void Find_AnyRayAndPlacement_IsTheNearestPointOfAll([Range(0, 2)] int placed)
        {
            var placement = s_placements[placed];
            var root = m_picker.Source.Grid.ToGeo(m_picker.Source.Root.Corner);
            double3 ToWorld(double3 geo) => math.mul(placement.Linear, geo - root) + placement.OriginWorld;
            double unit = math.length(placement.Linear.c0);
            var random = new Unity.Mathematics.Random(9);
            int hits = 0;
            for (int trial = 0; trial < 40; trial++)
            {
                var target = ToWorld(m_cloud.Geo(random.NextInt(m_cloud.Positions.Length)));
                var eye = target + math.normalize(random.NextDouble3(-1, 1)) * unit * random.NextDouble(0.01, 80);
                var aim = target + random.NextDouble3(-1, 1) * unit * 0.1;
                var ray = trial % 3 == 0 ? PointQuery.Parallel(eye, aim - eye, 50 / unit, random.NextDouble(0.5, 10))
                    : PointQuery.FromEye(eye, aim - eye, 800, random.NextDouble(0.5, 8));
                ray.From = trial % 4 == 0 ? unit * 5 : 0;
                ray.To = trial % 5 == 0 ? unit * 30 : double.PositiveInfinity;

                var found = PickTestCloud.Find(m_picker, ray, placement, EveryPoint);

                int first = m_cloud.First(ray, ToWorld, null, out double distance, out double next);
                Assert.That(found.Point != null, Is.EqualTo(first >= 0), "trial " + trial);
                if (first < 0)
                    continue;
                hits++;
                Assert.That(found.Point.Distance, Is.EqualTo(distance).Within(1e-8 * unit + 1e-9));
                if (next - distance > 1e-7 * unit)
                    Assert.That(PickTestCloud.StoredOf(found.Point), Is.EqualTo(m_cloud.Positions[first]));
                Assert.That(math.distance(found.Point.PositionWorld, ToWorld(found.Point.PositionGeo)), Is.LessThan(1e-8));
            }
            Assert.That(hits, Is.InRange(15, 39), "some hit and some miss");
        }

        [Test]
        public void Find_CameraOneCentimetreFromAPoint_IsExact()
        {
            var random = new Unity.Mathematics.Random(4);
            for (int trial = 0; trial < 20; trial++)
            {
                int point = random.NextInt(m_cloud.Positions.Length);
                var direction = math.normalize(random.NextDouble3(-1, 1));
                var ray = PointQuery.FromEye(m_cloud.Geo(point) - 0.01 * direction, direction, 1000, 3);
                var found = PickTestCloud.Find(m_picker, ray, m_geo).Point;
                Assert.That(PickTestCloud.StoredOf(found), Is.EqualTo(m_cloud.Positions[point]));
                Assert.That(found.PositionGeo, Is.EqualTo(m_cloud.Geo(point)), "not a digit is lost");
                Assert.That(found.Distance, Is.EqualTo(0.01).Within(2e-9));
            }
        }

        [Test]
        public void Find_Attributes_AreTheSourcesOwn()
        {
            for (int point = 0; point < 2000; point += 97)
            {
                var ray = PointQuery.FromEye(m_cloud.Geo(point) + new double3(0, 0, 0.002), new double3(0, 0, -1), 1000, 1);
                var found = PickTestCloud.Find(m_picker, ray, m_geo, EveryPoint).Point;
                Assert.That(PickTestCloud.StoredOf(found), Is.EqualTo(m_cloud.Positions[point]));
                Assert.That(found.Attributes.Select(a => a.Attribute.Name), Is.EqualTo(new[] { "Classification", "GpsTime",
                    "ScanAngle", "roughness", "Red", "Green", "Blue" }));
                Assert.That(found.Attributes[0].Value, Is.EqualTo(m_cloud.Classes[point]));
                Assert.That(found.Attributes[1].Value, Is.EqualTo(m_cloud.Times[point]));
                Assert.That(found.Attributes[2].Value, Is.EqualTo(m_cloud.Angles[point] * 0.006));
                Assert.That(found.Attributes[3].Value, Is.EqualTo(m_cloud.Extras[point]));
                Assert.That(found.Attributes[3].ToString(), Is.EqualTo(NumberText.Of(m_cloud.Extras[point])));
                Assert.That(found.Attributes[4].ToString(), Is.EqualTo(m_cloud.Reds[point].ToString()));
            }
        }

        [Test]
        public void Find_HiddenClassesAndClipBoxes_AreNotHit()
        {
            var random = new Unity.Mathematics.Random(2);
            var box = new ClipBox(PickTestCloud.OriginGeo + new double3(0, 0, 3),
                PickTestCloud.OriginGeo + new double3(100, 100, 40), true);
            var options = EveryPoint;
            options.HiddenClasses = ClassMask.Of(2, 3, 4, 5);
            options.ClipBoxes.Add(box);
            bool IsShown(int i) => m_cloud.Classes[i] != 2 && (m_cloud.Classes[i] < 3 || m_cloud.Classes[i] > 5) &&
                m_cloud.Positions[i].z < 3000;
            int hits = 0;
            for (int trial = 0; trial < 30; trial++)
            {
                var target = m_cloud.Geo(random.NextInt(m_cloud.Positions.Length));
                var eye = target + new double3(random.NextDouble2(-20, 20), 30);
                var ray = PointQuery.FromEye(eye, target - eye, 800, 12);
                var found = PickTestCloud.Find(m_picker, ray, m_geo, options).Point;
                int first = m_cloud.First(ray, geo => geo, IsShown, out double distance, out _);
                Assert.That(found != null, Is.EqualTo(first >= 0), "trial " + trial);
                if (found != null)
                    Assert.That(found.Distance, Is.EqualTo(distance).Within(1e-8));
                hits += found != null ? 1 : 0;
            }
            Assert.That(hits, Is.GreaterThan(10));
        }

        [Test]
        public void Find_FromFarAway_ReadsNoMoreThanIsVisible()
        {
            var eye = PickTestCloud.OriginGeo + new double3(50, -3000, 3000);
            long all = 0, shown = 0;
            for (int x = 10; x < 90; x += 10)
            {
                var aim = PickTestCloud.OriginGeo + new double3(x, 30, 0) - eye;
                // Beyond points that rise above the ground, of which each level has some.
                var ray = PointQuery.FromEye(eye, aim, 800, 2);
                ray.From = math.length(aim) - 3;
                all += PickTestCloud.Find(m_picker, ray, m_geo, EveryPoint).BytesRead;
                var found = PickTestCloud.Find(m_picker, ray, m_geo);
                shown += found.BytesRead;
                Assert.That(found.Point, Is.Not.Null);
                Assert.That(found.IsPartial, Is.False);
            }
            Assert.That(shown, Is.LessThan(all * 3 / 4));
        }

        [Test]
        public void Find_ByteLimitExceeded_ReturnsTheBestSoFar()
        {
            var ray = PointQuery.FromEye(m_cloud.Geo(5) + new double3(0, 0, 0.01), new double3(0, 0, -1), 800, 1);
            var options = EveryPoint;
            Assert.That(PickTestCloud.Find(m_picker, ray, m_geo, options).NodesRead, Is.GreaterThan(2));
            options.MaxBytes = 1;
            var found = PickTestCloud.Find(m_picker, ray, m_geo, options);
            Assert.That(found.IsPartial, Is.True);
            Assert.That(found.NodesRead, Is.EqualTo(1));
        }

        [Test]
        public void Find_CloudWithoutVolumeOrRayWithoutWidth_HitsNothing()
        {
            var eye = m_cloud.Geo(0) + new double3(0, 0, 1);
            var flat = new CloudPlacement(default, new double3(0, 0, 0));
            var wide = PointQuery.FromEye(eye, new double3(0, 0, -1), 800, 5);
            Assert.That(PickTestCloud.Find(m_picker, wide, flat).Point, Is.Null);
            var thin = PointQuery.FromEye(eye + new double3(0.0003, 0.0003, 0), new double3(0, 0, -1), 800, 0);
            Assert.That(PickTestCloud.Find(m_picker, thin, m_geo).Point, Is.Null);
        }

        [Test]
        public void Find_Aborted_LeavesNothingAndCanBeginAgain()
        {
            var ray = PointQuery.FromEye(m_cloud.Geo(7) + new double3(0, 0, 0.01), new double3(0, 0, -1), 800, 2);
            Find(m_cloud, ray, steps: -1);
            UnsafeUtility.ForgiveLeaks();
            for (int steps = 0; steps < 8; steps++)
                Find(m_cloud, ray, steps);
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);

            void Find(PickTestCloud cloud, PointQuery of, int steps)
            {
                using var picker = cloud.Picker();
                using (var work = new CoroutineStack(picker.Find(of, m_geo, EveryPoint, new PickResult())))
                    for (int step = 0; step < steps && work.MoveNext(); step++)
                        if (step + 1 < steps)
                            work.Current.Complete();
                Assert.That(PickTestCloud.StoredOf(PickTestCloud.Find(picker, of, m_geo, EveryPoint).Point),
                    Is.EqualTo(m_cloud.Positions[7]));
            }
        }

        [Test]
        public void Find_DamagedChunk_NamesFileAndByte()
        {
            using var cloud = new PickTestCloud(20_000);
            foreach (string file in cloud.ChunkFiles)
            {
                var bytes = File.ReadAllBytes(file);
                for (long at = FileHeader.SizeBytes; at < bytes.Length; at += 16)
                    bytes[at] ^= 1;
                File.WriteAllBytes(file, bytes);
            }
            using var picker = cloud.Picker();
            var ray = PointQuery.FromEye(cloud.Geo(3) + new double3(0, 0, 0.01), new double3(0, 0, -1), 800, 2);
            var placement = CloudPlacement.Geo(picker.Source.Grid, picker.Source.Root);
            Assert.That(() => PickTestCloud.Find(picker, ray, placement, EveryPoint), Throws.TypeOf<PointCloudException>()
                .With.Message.Match("chunks.*\\.bin: at byte \\d+: node \\d+ is damaged"));
            var up = PointQuery.FromEye(cloud.Geo(3) + new double3(0, 0, 50), new double3(0, 0, 1), 80, 8);
            Assert.That(PickTestCloud.Find(picker, up, placement).Point, Is.Null, "it goes on");
        }
    }
}
