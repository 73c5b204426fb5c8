using System;
using System.Diagnostics;
using System.IO;
using FastPoints.Drawing;
using FastPoints.Entities;
using FastPoints.Sources;
using FastPoints.Streaming;
using FastPoints.Tests.Drawing;
using FastPoints.Tests.Sources;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Entities;
using Unity.Mathematics;

namespace FastPoints.Tests.Entities
{
    public sealed class CloudStatesTests : CloudWorldFixture
    {
        static readonly TimeSpan s_maxTime = TimeSpan.FromMinutes(1);

        Entity m_cloud;

        StreamedPointCloud Streamed => Entities.GetComponentData<StreamedPointCloud>(m_cloud);

        [SetUp]
        public void Begin()
        {
            MakeWorld(typeof(TrackNodesSystem));
            Group.Begin(new MemoryNodePool(64 << 20, 1 << 20));
            Group.Stream.Settings.Selection = StreamedTestCloud.Selection;
        }

        [TearDown]
        public void ForgetFeeds() => CloudFeeds.Register(null);

        void Add(PointCloudPaths paths) => m_cloud = AddFile(paths, float4x4.identity);

        static PointCloudPaths PathsOf(GrowingCloud cloud) =>
            new PointCloudPaths { Path = cloud.Folder, PlayerSource = cloud.Source };

        string Error => Group.ErrorOf(m_cloud);

        bool IsStreamed => Entities.HasComponent<StreamedPointCloud>(m_cloud);

        [Test]
        public void File_NotConvertedYet_IsRefinedWithoutMovingOrLosingPoints()
        {
            using var cloud = new GrowingCloud();
            Add(PathsOf(cloud));
            Frames(() => Group.Stats.DrawnPoints > 0);
            var space = Entities.GetComponentData<PointCloudSpace>(m_cloud).Value;
            Assert.That(cloud.IsBuilt, Is.False);
            // Beside a build all of the preview has room.
            Group.Stream.Settings.Selection.PointBudget = 10_000_000;
            Group.Stream.Settings.Selection.MinScreenErrorPx = 0;
            Group.Stream.Settings.Selection.MinNodePx = 0;
            Frames(() => Group.Stats.DrawnPoints == GrowingCloud.PreviewPoints);
            void Look() => Assert.That(Group.Stats.DrawnPoints, Is.GreaterThanOrEqualTo(GrowingCloud.PreviewPoints));
            Frames(() => Streamed.Preview != CloudVersions.None, () =>
            {
                if (!File.Exists(cloud.Manifest))
                    cloud.Build();
                Look();
            });
            Frames(() => cloud.IsBuilt, () =>
            {
                cloud.Build();
                Look();
            });
            Frames(() => Streamed.Preview == CloudVersions.None && Streamed.Next == CloudVersions.None, Look);
            Frames(() => Group.Stats.IsSettled && !Group.Stream.IsRemovingAny);
            Assert.That(Group.Stats.DrawnPoints, Is.EqualTo(GrowingCloud.Points));
            Assert.That(Streamed.Preview, Is.EqualTo(CloudVersions.None));
            Assert.That(Streamed.Next, Is.EqualTo(CloudVersions.None));
            Assert.That(Entities.GetComponentData<PointCloudSpace>(m_cloud).Value, Is.EqualTo(space));
            Assert.That(Group.Stream.TryTakeFailure(out var failure), Is.False, failure.ToString());
            var shown = Group.Stream.Clouds[Streamed.Number];
            Assert.That(shown.Placement, Is.EqualTo(space.Place(shown.Source.Grid, shown.Source.Root, double4x4.identity)));
        }

        [Test]
        public void File_UnexpectedExceptionOnOpening_IsReportedOnce()
        {
            string path = Path.GetTempFileName();
            try
            {
                CloudFeeds.Register(_ => throw new InvalidOperationException("planted"));
                Add(new PointCloudPaths { Path = path });
                Frames(() => Error != null);
                Assert.That(Error, Is.EqualTo(path + ": InvalidOperationException: planted"));
                Assert.That(Group.Stream.TryTakeFailure(out var failure), Is.True);
                Assert.That(failure.What, Does.Contain(Error).And.Contains(nameof(CloudStatesTests)),
                    "and where it was thrown");
                for (int frame = 0; frame < 5; frame++)
                    Frame();
                Assert.That(Group.Stream.TryTakeFailure(out _), Is.False);
                Assert.That(World.GetExistingSystemManaged<PointCloudSystemGroup>().IsOpening, Is.False);
            }
            finally
            {
                File.Delete(path);
            }
        }

        [Test]
        public void File_BuildAborted_KeepsShowingThePreview()
        {
            using var cloud = new GrowingCloud();
            Add(PathsOf(cloud));
            Frames(() => Group.Stats.DrawnPoints > 0);
            while (!File.Exists(cloud.Manifest))
                cloud.Build();
            Frames(() => Streamed.Preview != CloudVersions.None);
            cloud.Cancel();
            Frames(() => Group.Stream.Clouds[Streamed.Number].Source is TreeSource);
            Assert.That(Streamed.Preview, Is.EqualTo(CloudVersions.None));
            Frames(() => Group.Stats.IsSettled && !Group.Stream.IsRemovingAny);
            Assert.That(Group.Stats.DrawnPoints, Is.GreaterThan(0));
        }

        [Test]
        public void File_OctreeOfAnotherFormat_IsStreamedDirectly()
        {
            PointFileReaders.Register();
            using var cloud = new TreeTestCloud(TreeTestCloud.Copc);
            Add(new PointCloudPaths { Path = cloud.Path });
            Frames(() => Group.Stats.DrawnPoints > 0);
            Assert.That(Group.Stream.Clouds[Streamed.Number].Source, Is.TypeOf<TreeSource>());
            Assert.That(Error, Is.Null);
            World.Dispose();
        }

        [Test]
        public void NeedsFrame_HierarchyReadByPages_IsTrueUntilAllIsShown()
        {
            PointFileReaders.Register();
            using var cloud = new TreeTestCloud(TreeTestCloud.EptBinary, 20_000);
            Add(new PointCloudPaths { Path = cloud.Path });
            Group.Stream.Settings.Selection.PointBudget = long.MaxValue;
            Group.Stream.Settings.Selection.MinScreenErrorPx = 0;
            Group.Stream.Settings.Selection.MinNodePx = 0;
            for (var watch = Stopwatch.StartNew(); watch.Elapsed < s_maxTime && Group.NeedsFrame;)
            {
                Group.Views.Add(StreamView.Everything(1e6));
                World.Update();
            }
            Assert.That(Group.Stats.DrawnPoints, Is.EqualTo(20_000));
            Assert.That(Group.NeedsFrame, Is.False);
        }

        /// <summary>Mono on Windows throws for quotes, which are pasted with a path.</summary>
        [Test]
        public void File_InvalidPath_IsAnErrorAndOthersAreShown()
        {
            var before = PointCloudPaths.PathOfAsset;
            PointCloudPaths.PathOfAsset = _ => throw new ArgumentException("Illegal characters in path.");
            try
            {
                Add(new PointCloudPaths { Path = "quoted", ProjectPath = PointCloudPaths.AssetPrefix + "7" });
                var refused = m_cloud;
                using var cloud = new StreamedTestCloud(20_000, 8000);
                Add(new PointCloudPaths { Path = cloud.Path });
                Frames(() => Group.Stats.DrawnPoints > 0);
                Assert.That(Group.ErrorOf(refused), Does.Contain("Illegal characters"));
                Assert.That(Error, Is.Null);
                World.Dispose();
            }
            finally
            {
                PointCloudPaths.PathOfAsset = before;
            }
        }

        [Test]
        public void NeedsRefresh_CloudMissingBefore_IsShownOnceItExists()
        {
            using var cloud = new StreamedTestCloud(20_000, 8000);
            string away = cloud.Path + ".away";
            Directory.Move(cloud.Path, away);
            Add(new PointCloudPaths { Path = cloud.Path });
            Frames(() => Error != null);
            Directory.Move(away, cloud.Path);
            Entities.SetComponentData(m_cloud, new PointCloudFile { NeedsRefresh = true });
            Frames(() => IsStreamed);
            Assert.That(Error, Is.Null);
            Assert.That(Entities.GetComponentData<PointCloudFile>(m_cloud).NeedsRefresh, Is.False);
            World.Dispose();
        }

        [Test]
        public void DestroyEntity_InTheMiddleOfAPreview_ReleasesAll()
        {
            UnsafeUtility.ForgiveLeaks();
            using (var cloud = new GrowingCloud())
            {
                for (int frames = 1; frames < 60; frames += 7)
                {
                    Add(PathsOf(cloud));
                    for (int i = 0; i < frames; i++)
                        Frame();
                    Entities.DestroyEntity(m_cloud);
                    Frame();
                }
                Frames(() => Group.Stats.IsSettled && !Group.Stream.IsRemovingAny);
                Assert.That(Group.Stream.Pool.UsedBytes, Is.Zero);
                World.Dispose();
            }
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        [Test]
        public void Dispose_OfTheWorldInTheMiddleOfAPreview_FreesAll()
        {
            World.Dispose();
            UnsafeUtility.ForgiveLeaks();
            using var cloud = new GrowingCloud();
            for (int frames = 0; frames < 60; frames += 7)
            {
                Begin();
                Add(PathsOf(cloud));
                for (int i = 0; i < frames; i++)
                    Frame();
                World.Dispose();
                Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
            }
        }
    }
}
