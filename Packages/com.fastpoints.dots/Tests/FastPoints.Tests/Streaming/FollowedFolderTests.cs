using System;
using System.Diagnostics;
using System.Threading;
using FastPoints.Build;
using FastPoints.Store;
using FastPoints.Tests.Nodes;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    public class FollowedFolderTests : FolderTests
    {
        const int Points = 120_000, MaxFrames = 1_000_000;

        [Test]
        public void Update_UnfinishedCloud_ShowsMoreWithEachGeneration()
        {
            var random = new Unity.Mathematics.Random(11);
            var positions = new int3[Points];
            for (int i = 0; i < Points; i++)
                positions[i] = new int3(random.NextInt2(20000), random.NextInt(100));
            var centimetres = new PositionTransform
            {
                Scale = new double3(0.01, 0.01, 0.01),
                Offset = StreamedTestCloud.OriginGeo,
            };
            string path = Folder.File("cloud" + StoreFormat.FolderExtension);
            var settings = new ConvertSettings
            {
                PointsPerChunk = 8000,
                CellsLog2 = 4,
                TargetPointsPerLeaf = 500,
                SecondsToFirstGeneration = 0,
                SecondsPerGeneration = 0,
            };
            var camera = StreamedTestCloud.Overview();
            FollowedFolder followed = null;
            using var stream = StreamedTestCloud.Stream();
            int generations = 0;
            long seen = 0, max = 0;
            var readers = new[] { MemoryReader.Of(positions, centimetres, 5000) };
            using (var work = new CoroutineStack(ConvertCloud.Run(readers, path, settings, r => { }, null)))
                while (work.MoveNext())
                {
                    work.Current.Complete();
                    if (followed == null && CloudFolder.IsCloud(path))
                        followed = new FollowedFolder(stream, path, null, StoreLayout.ColorName);
                    if (followed == null)
                        continue;
                    StreamedTestCloud.Frame(stream, camera);
                    followed.Update();
                    if (followed.Generation == seen || !followed.IsCurrent)
                        continue;
                    seen = followed.Generation;
                    generations++;
                }
            Assert.That(followed, Is.Not.Null);
            Assert.That(generations, Is.GreaterThan(0));
            for (int frame = 0; frame < MaxFrames && (followed.IsBuilding || !followed.IsCurrent); frame++)
            {
                max = Math.Max(max, StreamedTestCloud.Frame(stream, camera).DrawnPoints);
                followed.Update();
                Thread.Yield();
            }
            Assert.That(followed.IsBuilding, Is.False);
            stream.Settings.Selection.PointBudget = long.MaxValue;
            stream.Settings.Selection.MinScreenErrorPx = 0;
            stream.Settings.Selection.MinNodePx = 0;
            Assert.That(StreamedTestCloud.Settle(stream, camera).DrawnPoints, Is.EqualTo(Points));
            Assert.That(max, Is.GreaterThan(0));
            followed.Dispose();
        }

        [Test]
        public void Update_FinishedCloud_StopsPolling()
        {
            using var cloud = new StreamedTestCloud(20_000, 8000);
            using var stream = StreamedTestCloud.Stream();
            using var followed = new FollowedFolder(stream, cloud.Path + StoreFormat.UnfinishedSuffix, null);
            for (var watch = Stopwatch.StartNew(); watch.Elapsed < 1.5 * GenerationPoller.PollInterval;)
            {
                StreamedTestCloud.Frame(stream, StreamedTestCloud.Overview());
                followed.Update();
                Assert.That(followed.IsCurrent, Is.True);
            }
            Assert.That(followed.IsBuilding, Is.False);
        }
    }
}
