using System;
using System.Diagnostics;
using System.IO;
using System.Threading;
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
using Unity.Transforms;
using Camera = FastPoints.Picture.Camera;

namespace FastPoints.Tests.Entities
{
    public sealed class CloudStatesTests
    {
        static readonly TimeSpan s_maxTime = TimeSpan.FromMinutes(1);

        World m_world;
        PointCloudSystemGroup m_group;
        Entity m_cloud;

        EntityManager Entities => m_world.EntityManager;

        StreamedPointCloud Streamed => Entities.GetComponentData<StreamedPointCloud>(m_cloud);

        [SetUp]
        public void MakeWorld()
        {
            m_world = new World("clouds");
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(PointCloudSystemGroup),
                typeof(OpenCloudsSystem), typeof(PlaceCloudsSystem), typeof(AddCloudsSystem), typeof(ReceiveNodesSystem),
                typeof(SelectNodesSystem), typeof(UploadNodesSystem), typeof(RequestNodesSystem), typeof(ListNodesSystem),
                typeof(TrackNodesSystem));
            m_group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
            m_group.Begin(new MemoryNodePool(64 << 20, 1 << 20));
            m_group.Stream.Settings.Selection = StreamedTestCloud.Selection;
        }

        [TearDown]
        public void EndWorld()
        {
            if (m_world.IsCreated)
                m_world.Dispose();
            CloudFeeds.Register(null);
        }

        void Add(PointCloudPaths paths)
        {
            m_cloud = Entities.CreateEntity();
            Entities.AddComponentData(m_cloud, new PointCloudFile());
            paths.WriteTo(Entities.AddBuffer<PointCloudPathByte>(m_cloud));
            Entities.AddComponentData(m_cloud, new LocalToWorld { Value = float4x4.identity });
        }

        static PointCloudPaths PathsOf(GrowingCloud cloud) =>
            new PointCloudPaths { Path = cloud.Folder, PlayerSource = cloud.Source };

        FrameStats Frame()
        {
            var camera = Camera.Perspective(new double3(0, 180, -260), new double3(0, 0, 0), new double3(0, 1, 0), 60);
            m_group.Views.Add(camera.ToStreamView(StreamedTestCloud.WidthPx, StreamedTestCloud.HeightPx));
            m_world.Update();
            return m_group.Stats;
        }

        void Frames(Func<bool> isDone, Action more = null)
        {
            for (var watch = Stopwatch.StartNew(); watch.Elapsed < s_maxTime && !isDone();)
            {
                Frame();
                more?.Invoke();
                Thread.Yield();
            }
            Assert.That(isDone(), Is.True, "nothing came of it");
        }

        string Error => m_group.ErrorOf(m_cloud);

        bool IsStreamed => Entities.HasComponent<StreamedPointCloud>(m_cloud);

        [Test]
        public void File_NotConvertedYet_IsRefinedWithoutMovingOrLosingPoints()
        {
            using var cloud = new GrowingCloud();
            Add(PathsOf(cloud));
            Frames(() => m_group.Stats.DrawnPoints > 0);
            var space = Entities.GetComponentData<PointCloudSpace>(m_cloud).Value;
            Assert.That(cloud.IsBuilt, Is.False);
            // Beside a build all of the preview has room.
            m_group.Stream.Settings.Selection.PointBudget = 10_000_000;
            m_group.Stream.Settings.Selection.MinScreenErrorPx = 0;
            m_group.Stream.Settings.Selection.MinNodePx = 0;
            Frames(() => m_group.Stats.DrawnPoints == GrowingCloud.PreviewPoints);
            void Look() => Assert.That(m_group.Stats.DrawnPoints, Is.GreaterThanOrEqualTo(GrowingCloud.PreviewPoints));
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
            Frames(() => m_group.Stats.IsSettled && !m_group.Stream.IsRemovingAny);
            Assert.That(m_group.Stats.DrawnPoints, Is.EqualTo(GrowingCloud.Points));
            Assert.That(Streamed.Preview, Is.EqualTo(CloudVersions.None));
            Assert.That(Streamed.Next, Is.EqualTo(CloudVersions.None));
            Assert.That(Entities.GetComponentData<PointCloudSpace>(m_cloud).Value, Is.EqualTo(space));
            Assert.That(m_group.Stream.TryTakeFailure(out var failure), Is.False, failure.ToString());
            var shown = m_group.Stream.Clouds[Streamed.Number];
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
                Assert.That(m_group.Stream.TryTakeFailure(out var failure), Is.True);
                Assert.That(failure.What, Does.Contain(Error).And.Contains(nameof(CloudStatesTests)),
                    "and where it was thrown");
                for (int frame = 0; frame < 5; frame++)
                    Frame();
                Assert.That(m_group.Stream.TryTakeFailure(out _), Is.False);
                Assert.That(m_world.GetExistingSystemManaged<PointCloudSystemGroup>().IsOpening, Is.False);
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
            Frames(() => m_group.Stats.DrawnPoints > 0);
            while (!File.Exists(cloud.Manifest))
                cloud.Build();
            Frames(() => Streamed.Preview != CloudVersions.None);
            cloud.Cancel();
            Frames(() => m_group.Stream.Clouds[Streamed.Number].Source is TreeSource);
            Assert.That(Streamed.Preview, Is.EqualTo(CloudVersions.None));
            Frames(() => m_group.Stats.IsSettled && !m_group.Stream.IsRemovingAny);
            Assert.That(m_group.Stats.DrawnPoints, Is.GreaterThan(0));
        }

        [Test]
        public void File_OctreeOfAnotherFormat_IsStreamedDirectly()
        {
            PointFileReaders.Register();
            using var cloud = new TreeTestCloud(TreeTestCloud.Copc);
            Add(new PointCloudPaths { Path = cloud.Path });
            Frames(() => m_group.Stats.DrawnPoints > 0);
            Assert.That(m_group.Stream.Clouds[Streamed.Number].Source, Is.TypeOf<TreeSource>());
            Assert.That(Error, Is.Null);
            m_world.Dispose();
        }

        [Test]
        public void NeedsFrame_HierarchyReadByPages_IsTrueUntilAllIsShown()
        {
            PointFileReaders.Register();
            using var cloud = new TreeTestCloud(TreeTestCloud.EptBinary, 20_000);
            Add(new PointCloudPaths { Path = cloud.Path });
            m_group.Stream.Settings.Selection.PointBudget = long.MaxValue;
            m_group.Stream.Settings.Selection.MinScreenErrorPx = 0;
            m_group.Stream.Settings.Selection.MinNodePx = 0;
            for (var watch = Stopwatch.StartNew(); watch.Elapsed < s_maxTime && m_group.NeedsFrame;)
            {
                m_group.Views.Add(StreamView.Everything(1e6));
                m_world.Update();
            }
            Assert.That(m_group.Stats.DrawnPoints, Is.EqualTo(20_000));
            Assert.That(m_group.NeedsFrame, Is.False);
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
                Frames(() => m_group.Stats.DrawnPoints > 0);
                Assert.That(m_group.ErrorOf(refused), Does.Contain("Illegal characters"));
                Assert.That(Error, Is.Null);
                m_world.Dispose();
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
            m_world.Dispose();
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
                Frames(() => m_group.Stats.IsSettled && !m_group.Stream.IsRemovingAny);
                Assert.That(m_group.Stream.Pool.UsedBytes, Is.Zero);
                m_world.Dispose();
            }
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        [Test]
        public void Dispose_OfTheWorldInTheMiddleOfAPreview_FreesAll()
        {
            m_world.Dispose();
            UnsafeUtility.ForgiveLeaks();
            using var cloud = new GrowingCloud();
            for (int frames = 0; frames < 60; frames += 7)
            {
                MakeWorld();
                Add(PathsOf(cloud));
                for (int i = 0; i < frames; i++)
                    Frame();
                m_world.Dispose();
                Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
            }
        }
    }
}
