using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using FastPoints.Drawing;
using FastPoints.Picture;
using FastPoints.Queries;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Sources;
using FastPoints.Streaming;
using FastPoints.Tests.Reading;
using FastPoints.Tests.Sources;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Queries
{
    public sealed class TreePickTests
    {
        const int MaxFrames = 10_000_000;

        static PickOptions EveryPoint => new PickOptions { FinestSpacingShare = 0 };

        [Test]
        public void Find_AnyRay_MatchesTheConvertedCloud(
            [ValueSource(typeof(TreeTestCloud), nameof(TreeTestCloud.Kinds))] string kind)
        {
            using var cloud = new TreeTestCloud(kind);
            Compare(cloud.Path, 60, EveryPoint);
        }

        [TestCase("copc/ellipsoid.copc.laz")]
        [TestCase("copc/simple_with_page.copc.laz")]
        [TestCase("ept/lion_takanawa_ept_bin/ept.json")]
        [TestCase("ept/1.2-with-color/ept.json")]
        [TestCase("potree/lion_takanawa/cloud.js")]
        [TestCase("potree/lion_takanawa_laz/cloud.js")]
        [TestCase("potree/v2-mixedconifer-default/metadata.json")]
        public void Find_Sample_MatchesTheConvertedCloud(string sample) =>
            Compare(TestData.SampleOrIgnore(sample), 12, EveryPoint);

        [Test]
        public void Find_HiddenClassesAndClipBoxes_AreNotHit()
        {
            using var cloud = new TreeTestCloud(TreeTestCloud.Copc);
            var options = EveryPoint;
            var geo = PositionsOf(cloud.Path).Where(p => math.all(math.abs(p) < 1e6)).ToList();
            double middle = geo.Select(p => p.x).OrderBy(x => x).ElementAt(geo.Count / 2);
            options.ClipBoxes.Add(new ClipBox(new double3(-1e9, -1e9, -1e9), new double3(middle, 1e9, 1e9), true));
            options.HiddenClasses = ClassMask.Of(0, 1, 2, 3);
            foreach (var found in Compare(cloud.Path, 60, options))
            {
                Assert.That(found.PositionGeo.x, Is.GreaterThan(middle));
                Assert.That(found.Attributes.Single(a => a.Attribute.Name == AttributeNames.Classification).Value,
                    Is.GreaterThan(3));
            }
        }

        static List<PickedPoint> Compare(string path, int rays, PickOptions options)
        {
            var all = PositionsOf(path);
            var found = new List<PickedPoint>();
            using (var streamed = TreeTestCloud.Open(path))
            using (var reader = PointReaders.Open(path))
            using (var converted = new StreamedTestCloud(6000, reader))
            using (var expected = new PointPicker(FolderSource.OpenWhole(converted.Path)))
            using (var picker = PickerOf(streamed))
            {
                var random = new Unity.Mathematics.Random(3);
                double size = math.cmax(all.Aggregate(math.max) - all.Aggregate(math.min)) * 0.01;
                for (int trial = 0; trial < rays; trial++)
                {
                    var target = all[random.NextInt(all.Count)];
                    var eye = target + math.normalize(random.NextDouble3(-1, 1)) * size * random.NextDouble(0.1, 30);
                    var ray = PointQuery.FromEye(eye, target - eye, 800, random.NextDouble(0.5, 8));
                    ray.OriginWorld += trial % 3 == 0 ? size : 0;
                    var want = PickTestCloud.Find(expected, ray, Geo(expected), options).Point;
                    var got = PickTestCloud.Find(picker, ray, Geo(picker), options).Point;
                    Assert.That(got == null, Is.EqualTo(want == null), "trial " + trial);
                    if (got == null)
                        continue;
                    found.Add(got);
                    Assert.That(got.Distance, Is.EqualTo(want.Distance).Within(1e-12 * (want.Distance + math.length(eye))));
                    Assert.That(got.PositionGeo, Is.EqualTo(want.PositionGeo), "not a digit is lost");
                    Assert.That(got.Attributes.Select(a => a.Attribute), Is.EqualTo(want.Attributes.Select(a => a.Attribute)));
                    // Any of several points at one position may be found.
                    if (all.Count(p => p.Equals(got.PositionGeo)) == 1)
                        Assert.That(got.Attributes.Select(a => a.ToString()),
                            Is.EqualTo(want.Attributes.Select(a => a.ToString())));
                }
            }
            Assert.That(found.Count, Is.GreaterThan(rays / 4));
            return found;
        }

        static unsafe List<double3> PositionsOf(string path)
        {
            var positions = new List<double3>();
            using var reader = PointReaders.Open(path);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            ReadPoints.EachBlock(reader, reader.Info.Schema.Select("X", "Y", "Z"), read =>
            {
                var columns = PositionColumns.Of(read.Points);
                for (int i = 0; i < read.Points.Count; i++)
                    positions.Add(columns.GeoAt((byte*)read.Points.Bytes.GetUnsafeReadOnlyPtr(), reader.Info.Transform, i));
            });
            return positions;
        }

        static PointPicker PickerOf(NodeSource streamed)
        {
            NodeSource source = null;
            JobCoroutine.RunToEnd(streamed.OpenForPicking(opened => source = opened));
            return new PointPicker(source);
        }

        static CloudPlacement Geo(PointPicker picker) => CloudPlacement.Geo(picker.Source.Grid, picker.Source.Root);

        [Test]
        public void Find_FewBytesAllowed_ReturnsTheBestSoFar()
        {
            using var cloud = new TreeTestCloud(TreeTestCloud.Copc);
            using var streamed = cloud.Open();
            using var picker = PickerOf(streamed);
            var at = PositionsOf(cloud.Path)[2000];
            var ray = PointQuery.FromEye(at + new double3(0, 0, 1), new double3(0, 0, -1), 800, 3);
            var options = EveryPoint;
            var whole = PickTestCloud.Find(picker, ray, Geo(picker), options);
            Assert.That(whole.NodesRead, Is.GreaterThan(3));
            Assert.That(whole.IsPartial, Is.False);
            options.MaxBytes = 1;
            var found = PickTestCloud.Find(picker, ray, Geo(picker), options);
            Assert.That(found.IsPartial, Is.True);
            Assert.That(found.NodesRead, Is.InRange(1, 2));
            Assert.That(found.BytesRead, Is.InRange(2, whole.BytesRead - 1));
        }

        [Test]
        public void Find_DamagedNode_NamesFileAndByte()
        {
            var writer = new CopcFileWriter { MaxNodePoints = 4000 };
            var bytes = writer.Write(LazRecords.Make(7, 0, 3000, 7));
            var (offset, _) = writer.Pages.Last();
            long begin = (long)CopcEntry.Read(new ByteReader(bytes, "", 0), (int)offset).Offset;
            double3 at;
            using (var whole = new TemporaryFile(bytes, ".copc.laz"))
                at = PositionsOf(whole.Path)[0];
            for (int i = 60; i < 200; i++)
                bytes[begin + i] = 0xFF;
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var streamed = TreeTestCloud.Open(file.Path);
            using var picker = PickerOf(streamed);
            var ray = PointQuery.FromEye(at + new double3(0, 0, 1), new double3(0, 0, -1), 800, 3);
            for (int again = 0; again < 2; again++)
            {
                var failure = Assert.Throws<PointCloudException>(() => PickTestCloud.Find(picker, ray, Geo(picker), EveryPoint));
                Assert.That(failure.Path, Is.EqualTo(file.Path));
                Assert.That(failure.ByteOffset, Is.GreaterThanOrEqualTo(begin).And.LessThan(bytes.Length));
            }
        }

        [Test]
        public void Find_Aborted_LeavesNothingAndCanBeginAgain(
            [Values(TreeTestCloud.Copc, TreeTestCloud.EptLaz, TreeTestCloud.Potree2)] string kind)
        {
            using var cloud = new TreeTestCloud(kind);
            using var streamed = cloud.Open();
            var at = PositionsOf(cloud.Path)[700];
            var ray = PointQuery.FromEye(at + new double3(0, 0, 0.01), new double3(0, 0, -1), 800, 3);
            UnsafeUtility.ForgiveLeaks();
            for (int steps = 0; steps < 30; steps++)
            {
                using var picker = PickerOf(streamed);
                using (var work = new CoroutineStack(picker.Find(ray, Geo(picker), EveryPoint, new PickResult())))
                    for (int step = 0; step < steps && work.MoveNext(); step++)
                        if (step + 1 < steps)
                            work.Current.Complete();
                if (steps % 10 == 0)
                    Assert.That(PickTestCloud.Find(picker, ray, Geo(picker), EveryPoint).Point.PositionGeo, Is.EqualTo(at));
            }
            for (int steps = 0; steps < 4; steps++)
                using (var opening = new CoroutineStack(streamed.OpenForPicking(opened => opened.Dispose())))
                    for (int step = 0; step < steps && opening.MoveNext(); step++)
                        opening.Current.Complete();
            Assert.That(() => UnsafeUtility.CheckForLeaks(), Is.Zero.After(10_000, 10), "what opens is disposed when it has");
        }

        static StreamPick Find(StreamPicker picker, StreamContext stream, PointQuery ray)
        {
            picker.Begin(stream, ray);
            for (int frame = 0; frame < MaxFrames && !picker.Update(); frame++)
                Thread.Yield();
            Assert.That(picker.IsSearching, Is.False);
            return picker.Pick;
        }

        [Test]
        public void StreamPicker_CloudsOfAnyKind_FindsTheNearestOfAll()
        {
            using var folder = new StreamedTestCloud(20_000, 4000);
            using var copc = new TreeTestCloud(TreeTestCloud.Copc);
            using var stream = StreamedTestCloud.Stream();
            using var picker = new StreamPicker();
            var converted = folder.Open();
            var tree = copc.Open();
            var at = PositionsOf(copc.Path)[1000];
            stream.Add(converted, StreamedTestCloud.Geo(converted));
            int number = stream.Add(tree, StreamedTestCloud.Geo(tree));
            var ray = PointQuery.FromEye(at + new double3(0, 0, 0.001), new double3(0, 0, -1), 800, 1);

            var pick = Find(picker, stream, ray);

            Assert.That(pick.Failure, Is.Null);
            Assert.That(pick.Cloud, Is.EqualTo(number));
            Assert.That(pick.Point.PositionGeo, Is.EqualTo(at));
            Assert.That(pick.Path, Is.EqualTo(copc.Path));
            Assert.That(pick.IsPreview, Is.False);
            // Removed while it is searched: the search goes on with files of its own.
            picker.Begin(stream, ray);
            stream.Remove(number);
            stream.Trim();
            for (int frame = 0; frame < MaxFrames && !picker.Update(); frame++)
                Thread.Yield();
            Assert.That(picker.Pick.Point.PositionGeo, Is.EqualTo(at));
            Assert.That(Find(picker, stream, ray).Point, Is.Null, "it is gone");
        }

        [Test]
        public void StreamPicker_MissingFile_ReportsItAndSearchesTheOthers()
        {
            using var folder = new StreamedTestCloud(20_000, 4000);
            using var copc = new TreeTestCloud(TreeTestCloud.Copc);
            using var stream = StreamedTestCloud.Stream();
            using var picker = new StreamPicker();
            var tree = copc.Open();
            var converted = folder.Open();
            stream.Add(tree, StreamedTestCloud.Geo(tree));
            int number = stream.Add(converted, StreamedTestCloud.Geo(converted));
            File.Delete(copc.Path);
            var eye = StreamedTestCloud.OriginGeo + new double3(100, 100, 100);
            var pick = Find(picker, stream, PointQuery.FromEye(eye, new double3(0, 0, -1), 100, 30));
            Assert.That(pick.Failure, Does.Contain(copc.Path));
            Assert.That(pick.Point, Is.Not.Null);
            Assert.That(pick.Cloud, Is.EqualTo(number));
        }

        [TestCase(40_000, false), TestCase(500, true)]
        public void StreamPicker_Preview_FindsPointsOfTheSample(int taken, bool isPreview)
        {
            var batch = TestBatches.New(40_000, PositionColumns.Attributes(AttributeType.Int32));
            for (int i = 0; i < batch.Count; i++)
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, axis == 2 ? i % 7 : axis == 1 ? i / 200 : i % 200);
            using var reader = new MemoryPointReader(batch, 10_000, fixedStride: false);
            using var preview = new PreviewPicture(reader, new PreviewOptions { Points = taken });
            using var stream = StreamedTestCloud.Stream();
            using var picker = new StreamPicker();
            JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()));
            var source = new TreeSource(SampleStreamingTests.CopyOf(preview.Sample));
            int number = stream.Add(source, StreamedTestCloud.Geo(source));
            var middle = preview.Sample.Bounds.Center;
            var ray = PointQuery.FromEye(middle + new double3(0, 0, 500), new double3(0, 0, -1), 100, 10);

            var pick = Find(picker, stream, ray);

            Assert.That(pick.Point, Is.Not.Null);
            Assert.That(pick.IsPreview, Is.EqualTo(isPreview));
            Assert.That(isPreview || pick.Point.PositionGeo.z == 6, Is.True, "the highest within the ray's width");
            stream.Remove(number);
            stream.Trim();
            Assert.That(stream.Clouds[number], Is.Null);
            Assert.That(Find(picker, stream, ray).Point, Is.Null);
        }
    }
}
