using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using FastPoints.Build;
using FastPoints.Picture;
using FastPoints.Sampling;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Tests.Nodes;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Sources
{
    public class SampleStreamingTests
    {
        const int MaxFrames = 20_000_000;

        static PreviewPicture Take(PointBatch batch, int points)
        {
            using var reader = new MemoryPointReader(batch, 10_000, fixedStride: false);
            var preview = new PreviewPicture(reader, new PreviewOptions { Points = points });
            JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()));
            return preview;
        }

        internal static SampleReader CopyOf(PreviewSample sample)
        {
            SampleReader copy = null;
            JobCoroutine.RunToEnd(SampleReader.Copy(sample, "scan", copied => copy = copied));
            return copy;
        }

        [TestCase(AttributeType.Int32, 100_000), TestCase(AttributeType.Float32, 100_000)]
        [TestCase(AttributeType.Float64, 40_000), TestCase(AttributeType.Int32, 1)]
        public void Run_Sample_DrawsEachOfItsPoints(AttributeType type, int points)
        {
            var batch = TestBatches.New(points, PositionColumns.Attributes(type));
            for (int i = 0; i < points; i++)
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, axis == 2 ? i % 7 : axis == 1 ? i / 300 : i % 300 - 100);
            using var preview = Take(batch, points);
            using var stream = StreamedTestCloud.Stream();
            var source = new TreeSource(CopyOf(preview.Sample));
            int number = stream.Add(source, StreamedTestCloud.Geo(source));
            stream.Settings.Selection.MinScreenErrorPx = 0;
            stream.Settings.Selection.MinNodePx = 0;
            var middle = preview.Sample.Bounds.Center;
            var camera = Camera(middle);
            Assert.That(StreamedTestCloud.Settle(stream, camera).DrawnPoints, Is.EqualTo(points));
            Assert.That(StreamedPoints.Drawn(stream, number), Is.EqualTo(
                StreamedPoints.Of(preview.Sample.Points, preview.Sample.Transform, source.Grid)));
            Assert.That(stream.TryTakeFailure(out _), Is.False);
        }

        static FastPoints.Picture.Camera Camera(double3 middle) => FastPoints.Picture.Camera.Perspective(
            middle + new double3(0, -2000, 1500), middle, new double3(0, 0, 1), 60);

        [Test]
        public void Run_SampleWithoutPoints_DrawsNothing()
        {
            var none = TestBatches.New(0, PositionColumns.Attributes(AttributeType.Int32));
            using var sample = new PreviewSample(none, PositionTransform.Identity);
            using var stream = StreamedTestCloud.Stream();
            var source = new TreeSource(CopyOf(sample));
            stream.Add(source, StreamedTestCloud.Geo(source));
            Assert.That(StreamedTestCloud.Settle(stream, Camera(default)).DrawnPoints, Is.Zero);
        }

        sealed class Watched : IDisposable
        {
            public readonly StreamContext Stream = StreamedTestCloud.Stream();
            public readonly FastPoints.Picture.Camera Camera = StreamedTestCloud.Overview();
            public readonly CloudVersions Succession;
            public FollowedFolder Followed;
            public bool WasSeen;

            public Watched() => Succession = new CloudVersions(Stream);

            public void Frame()
            {
                long drawn = StreamedTestCloud.Frame(Stream, Camera).DrawnPoints;
                if (Followed != null)
                    Followed.Update();
                else
                    Succession.Update();
                if (WasSeen)
                    Assert.That(drawn, Is.GreaterThan(0));
                WasSeen |= drawn > 0;
            }

            public void FramesUntil(Func<bool> isDone)
            {
                for (int i = 0; i < MaxFrames && !isDone(); i++)
                {
                    Frame();
                    Thread.Yield();
                }
            }

            public void Run(IEnumerator<JobStep> steps, Action eachStep = null)
            {
                using var work = new CoroutineStack(steps);
                while (work.MoveNext())
                {
                    work.Current.Complete();
                    eachStep?.Invoke();
                    Frame();
                }
            }

            public void Dispose()
            {
                Followed?.Dispose();
                Stream.Dispose();
            }
        }

        [Test]
        public void Update_WavesThenBuildThenResult_AlwaysShowMore()
        {
            const int Points = 150_000;
            var random = new Unity.Mathematics.Random(3);
            var positions = new int3[Points];
            for (int i = 0; i < Points; i++)
                positions[i] = new int3(random.NextInt2(20000), random.NextInt(100));
            var centimetres = new PositionTransform { Scale = 0.01, Offset = StreamedTestCloud.OriginGeo };
            string scratch = Path.Combine(Path.GetTempPath(), "fastpoints-" + Guid.NewGuid().ToString("N"));
            string path = Path.Combine(scratch, "cloud" + StoreFormat.FolderExtension);
            Directory.CreateDirectory(scratch);
            UnsafeUtility.ForgiveLeaks();
            try
            {
                using (var watched = new Watched())
                {
                    int waves = 0;
                    using (var reader = MemoryReader.Of(positions, centimetres, 5000))
                    using (var preview = new PreviewPicture(reader, new PreviewOptions { Points = 50_000 }))
                    {
                        preview.WaveReady += (sample, wave) =>
                        {
                            waves++;
                            watched.Succession.Add(new TreeSource(CopyOf(sample), StoreLayout.ColorName));
                        };
                        watched.Run(preview.TakeSample(new StageProgress()));
                    }
                    watched.FramesUntil(() => watched.Succession.IsCurrent && watched.WasSeen);
                    Assert.That(waves, Is.GreaterThan(1));
                    Assert.That(watched.WasSeen, Is.True);
                    Assert.That(StreamedTestCloud.Settle(watched.Stream, watched.Camera).DrawnPoints, Is.EqualTo(50_000));

                    var settings = new ConvertSettings
                    {
                        PointsPerChunk = 20_000,
                        SecondsToFirstGeneration = 0,
                        SecondsPerGeneration = 0,
                    };
                    var readers = new[] { MemoryReader.Of(positions, centimetres, 5000) };
                    watched.Run(ConvertCloud.Run(readers, path, settings, r => { }, null), () =>
                    {
                        if (watched.Followed == null && CloudFolder.IsCloud(path))
                            watched.Followed = new FollowedFolder(watched.Succession, path, null, StoreLayout.ColorName);
                    });
                    watched.Followed ??= new FollowedFolder(watched.Succession, path, null, StoreLayout.ColorName);
                    watched.FramesUntil(() => !watched.Followed.IsBuilding && watched.Followed.IsCurrent);
                    Assert.That(watched.Followed.IsCurrent, Is.True);
                    watched.Stream.Settings.Selection.MinScreenErrorPx = 0;
                    watched.Stream.Settings.Selection.MinNodePx = 0;
                    Assert.That(StreamedTestCloud.Settle(watched.Stream, watched.Camera).DrawnPoints, Is.EqualTo(Points));
                    Assert.That(watched.Stream.Drawn.AsArray().ToArray().Select(d => d.Cloud).Distinct(),
                        Is.EqualTo(new[] { watched.Followed.Cloud }));
                    Assert.That(watched.Stream.TryTakeFailure(out _), Is.False);
                }
                Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
            }
            finally
            {
                Directory.Delete(scratch, true);
            }
        }
    }
}
