using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using FastPoints.Drawing;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Tests.Sources;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Tests.Drawing
{
    [Category("Smoke")]
    public sealed class CloudFeedTests
    {
        static readonly TimeSpan s_maxTime = TimeSpan.FromMinutes(1);

        [TearDown]
        public void ForgetReaders() => CloudFeeds.Register(null);

        static void Updates(CloudFeed feed, Func<bool> isDone, Action more = null)
        {
            for (var watch = Stopwatch.StartNew(); watch.Elapsed < s_maxTime && !isDone();)
            {
                feed.Update(1);
                more?.Invoke();
                Thread.Yield();
            }
            Assert.That(isDone(), Is.True, "nothing came of it");
        }

        static CloudStage TakeAndDrop(CloudFeed feed)
        {
            var stage = feed.Newest.Stage;
            feed.Take().Dispose();
            return stage;
        }

        [Test]
        public void Update_FinishedCloud_MakesNoGarbage()
        {
            using var cloud = new GrowingCloud();
            while (!cloud.IsBuilt)
                cloud.Build();
            using var feed = CloudFeeds.Open(cloud.Folder);
            Updates(feed, () => feed.Newest != null);
            TakeAndDrop(feed);
            feed.Update(1);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int frame = 0; frame < 200; frame++)
                feed.Update(1);
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        }

        [Test]
        public void Update_FileThenBuildThenResult_ReportsPreviewsGenerationsAndResultInOrder()
        {
            UnsafeUtility.ForgiveLeaks();
            using var cloud = new GrowingCloud();
            var stages = new List<CloudStage>();
            using (var feed = CloudFeeds.Open(cloud.Folder, new[] { cloud.Source }))
            {
                void Take()
                {
                    if (feed.Newest != null)
                        stages.Add(TakeAndDrop(feed));
                }
                Updates(feed, () => stages.Count > 1, Take);
                Assert.That(stages, Is.All.EqualTo(CloudStage.Preview));
                // A build of this size is done before anybody looks: between its steps others pass.
                Updates(feed, () => cloud.IsBuilt, () =>
                {
                    Take();
                    if (stages.Contains(CloudStage.Building) || !File.Exists(cloud.Manifest))
                        cloud.Build();
                });
                Updates(feed, () => stages[stages.Count - 1] == CloudStage.Whole, Take);
                Assert.That(stages.Distinct(), Has.Member(CloudStage.Building));
                Assert.That(stages.Count(s => s == CloudStage.Whole), Is.EqualTo(1));
                Assert.That(feed.IsEnded, Is.True);
            }
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        [Test]
        public void Update_BuildAborted_IsReportedAndTheFileShowsAgain()
        {
            using var cloud = new GrowingCloud();
            while (!File.Exists(cloud.Manifest))
                cloud.Build();
            using var feed = CloudFeeds.Open(cloud.Folder, new[] { cloud.Source });
            Assert.That(TakeAndDrop(feed), Is.EqualTo(CloudStage.Building));
            cloud.Cancel();
            Updates(feed, () => feed.IsBuildAborted);
            Updates(feed, () => feed.Newest != null);
            Assert.That(TakeAndDrop(feed), Is.EqualTo(CloudStage.Preview));
        }

        /// <summary>Its files are about to have other paths: what is opened of it now cannot be read in a moment.</summary>
        [Test]
        public void Update_ResultNotRenamedYet_IsStillABuild()
        {
            using var cloud = new StreamedTestCloud(20_000, 8000);
            Directory.Move(cloud.Path, cloud.Path + ".part");
            using var feed = CloudFeeds.Open(cloud.Path);
            Assert.That(TakeAndDrop(feed), Is.EqualTo(CloudStage.Building));
            for (var watch = Stopwatch.StartNew(); watch.Elapsed < 2.5 * GenerationPoller.PollInterval;)
            {
                feed.Update(1);
                // Looks go on on another thread: without time for them nothing could be found that must not be.
                Thread.Sleep(1);
                Assert.That(feed.Newest, Is.Null);
            }
            Assert.That(feed.IsBuildAborted, Is.False);
            Directory.Move(cloud.Path + ".part", cloud.Path);
            Updates(feed, () => feed.Newest != null);
            Assert.That(TakeAndDrop(feed), Is.EqualTo(CloudStage.Whole));
            Assert.That(feed.IsEnded, Is.True);
        }

        [Test]
        public void Refresh_FolderReplacedOrDeleted_IsReported()
        {
            using var cloud = new StreamedTestCloud(20_000, 8000);
            using var other = new StreamedTestCloud(30_000, 8000);
            using var feed = CloudFeeds.Open(cloud.Path);
            TakeAndDrop(feed);
            Updates(feed, () => feed.IsEnded);
            Directory.Delete(cloud.Path, true);
            Directory.Move(other.Path, cloud.Path);
            feed.Refresh();
            Updates(feed, () => feed.Newest != null);
            using (var taken = (FolderSource)feed.Take())
                Assert.That(taken.Folder.Manifest.Points, Is.EqualTo(30_000));

            Directory.Delete(cloud.Path, true);
            feed.Refresh();
            Updates(feed, () => feed.IsBuildAborted);
        }

        [Test]
        public void Open_OctreeOfAnotherFormat_IsCompleteWithoutConversion(
            [ValueSource(typeof(TreeTestCloud), nameof(TreeTestCloud.Kinds))] string kind)
        {
            UnsafeUtility.ForgiveLeaks();
            PointFileReaders.Register();
            using (var cloud = new TreeTestCloud(kind))
            {
                int files = FilesIn(cloud.Path);
                using (var feed = CloudFeeds.Open(cloud.Path))
                {
                    Updates(feed, () => feed.Newest != null);
                    Assert.That(feed.Newest.Stage, Is.EqualTo(CloudStage.Whole));
                    Assert.That(feed.Newest.Ranges.Full.IsEmpty, Is.False);
                    Assert.That(feed.Newest.BoundsGeo.IsFinite, Is.True);
                    using (var source = feed.Take())
                        Assert.That(source, Is.TypeOf<TreeSource>());
                    Assert.That(feed.IsEnded, Is.True);
                }
                Assert.That(FilesIn(cloud.Path), Is.EqualTo(files));
            }
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        // For a file, only siblings with its name: others change.
        static int FilesIn(string path) => Directory.Exists(path) ? Directory.GetFiles(path).Length
            : Directory.GetFiles(Path.GetDirectoryName(path), Path.GetFileName(path) + "*").Length;

        [Test]
        public void Dispose_InTheMiddleOfAPreview_FreesAll()
        {
            UnsafeUtility.ForgiveLeaks();
            using (var cloud = new GrowingCloud())
                for (int updates = 0; updates < 60; updates += 3)
                    using (var feed = CloudFeeds.Open(cloud.Folder, new[] { cloud.Source }))
                        for (int i = 0; i < updates; i++)
                            feed.Update(0.05);
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        [Test]
        public void Open_WithoutReaders_SaysWhatIsMissing()
        {
            string path = Path.GetTempFileName();
            try
            {
                Assert.That(() => CloudFeeds.Open(path), Throws.TypeOf<PointCloudException>()
                    .With.Message.StartsWith(path).And.Message.Contains("FastPoints.Import"));
            }
            finally
            {
                File.Delete(path);
            }
        }

        [Test]
        public void Open_MissingPath_NamesThePath()
        {
            PointFileReaders.Register();
            string path = Path.Combine(Path.GetTempPath(), "fastpoints-none.las");
            Assert.That(() => CloudFeeds.Open(path), Throws.TypeOf<PointCloudException>().With.Message.StartsWith(path));
            string folder = Path.Combine(Path.GetTempPath(), "fastpoints-none.fastpoints");
            Assert.That(() => CloudFeeds.Open(folder, new[] { path }),
                Throws.TypeOf<PointCloudException>().With.Message.StartsWith(path));
        }
    }
}
