using System.IO;
using System.Linq;
using FastPoints.Store;
using FastPoints.Streaming;
using NUnit.Framework;

namespace FastPoints.Tests.Streaming
{
    public sealed class StreamFilesTests
    {
        StreamedTestCloud m_cloud;
        StreamContext m_stream;

        [SetUp]
        public void MakeCloud()
        {
            m_cloud = new StreamedTestCloud(60_000, 1000);
            m_stream = StreamedTestCloud.Stream();
        }

        [TearDown]
        public void DeleteCloud()
        {
            m_stream.Dispose();
            m_cloud.Dispose();
        }

        int Add()
        {
            var source = m_cloud.Open();
            return m_stream.Add(source, StreamedTestCloud.Geo(source));
        }

        int MaxOpenWhileItSettles()
        {
            int max = 0;
            while (!StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Overview()).IsSettled)
                max = System.Math.Max(max, m_stream.Files.OpenPaths.Count);
            return max;
        }

        [Test]
        public void Run_MoreFilesThanMayBeOpen_ClosesTheOldest()
        {
            Add();
            m_stream.Files.MaxOpenFiles = 7;
            Assert.That(MaxOpenWhileItSettles(), Is.EqualTo(7));
        }

        [Test]
        public void Run_NothingToRead_ClosesAll()
        {
            Add();
            MaxOpenWhileItSettles();
            for (int i = 0; i <= m_stream.Files.FramesToClose; i++)
                StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Overview());
            Assert.That(m_stream.Files.OpenPaths.Count, Is.Zero);
        }

        [Test]
        public void Remove_FilesOpen_ClosesThoseOfTheCloudAlone()
        {
            int first = Add(), second = Add();
            // A busy machine takes more frames than an idle file stays open.
            m_stream.Files.FramesToClose = int.MaxValue;
            MaxOpenWhileItSettles();
            int open = m_stream.Files.OpenPaths.Count;
            m_stream.Remove(first);
            StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Overview());
            Assert.That(m_stream.Files.OpenPaths.Count, Is.LessThan(open).And.GreaterThan(0));
            m_stream.Remove(second);
            StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Overview());
            Assert.That(m_stream.Files.OpenPaths.Count, Is.Zero);
        }

        /// <summary>Windows neither renames nor deletes a folder with an open file.</summary>
        [Test]
        public void Release_FolderInUse_ClosesItsFilesOnly()
        {
            using var other = new StreamedTestCloud(30_000, 4000);
            var source = other.Open();
            m_stream.Add(source, StreamedTestCloud.Geo(source));
            Add();
            int Of(StreamedTestCloud cloud) => OpenFilesBelow(cloud.Path);
            while (Of(m_cloud) == 0 || Of(other) == 0)
                StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Overview());
            int kept = Of(other);
            FolderReleases.Release(m_cloud.Path + Path.DirectorySeparatorChar);
            Assert.That(Of(m_cloud), Is.Zero);
            Assert.That(Of(other), Is.EqualTo(kept));
            try
            {
                while (!FolderReleases.HasReleased)
                    StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Overview());
                // One that has nothing loaded yet.
                Add();
                for (int i = 0; i < 10; i++)
                {
                    StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Overview());
                    Assert.That(Of(m_cloud), Is.Zero, "nothing is read of it");
                }
            }
            finally
            {
                FolderReleases.Reacquire(m_cloud.Path);
            }
            StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Overview());
            Assert.That(m_stream.TryTakeFailure(out _), Is.False);
            Assert.That(m_stream.Drawn.AsArray().ToArray().Select(d => d.Cloud).Distinct().Count(), Is.EqualTo(3));
        }

        [Test]
        public void Convert_FolderIsShown_ClosesItsFilesBeforeItIsReplaced()
        {
            Add();
            while (m_stream.Files.OpenPaths.Count == 0)
                StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Overview());
            m_cloud.ConvertAgain(20_000);
            Assert.That(m_stream.Files.OpenPaths, Is.Empty);
        }

        int OpenFilesBelow(string folder) =>
            m_stream.Files.OpenPaths.Count(p => p.StartsWith(folder, System.StringComparison.Ordinal));

        /// <summary>A file that is still open would be read on after another has its name. One file is fewer than stay open by
        /// themselves.</summary>
        [TestCase(false), TestCase(true)]
        public void Run_FileReplacedAfterItWasDamaged_IsOpenedAgain(bool isInTheMaking)
        {
            using var cloud = new StreamedTestCloud(2000);
            string folder = cloud.Path;
            if (isInTheMaking)
                Directory.Move(cloud.Path, folder += StoreFormat.UnfinishedSuffix);
            string path;
            byte[] sound;
            using (var opened = CloudFolder.Open(folder))
            {
                path = opened.PlanesPathOf(0);
                sound = File.ReadAllBytes(path);
                byte[] damaged = (byte[])sound.Clone();
                damaged[opened.Root.PlaneRanges[0].OffsetBytes + opened.Root.PlaneRanges[0].LengthBytes / 2] ^= 1;
                File.WriteAllBytes(path, damaged);
            }
            m_stream.Settings.MaxTries = 1000;
            var source = new FolderSource(CloudFolder.Open(folder), StoreLayout.ColorName);
            m_stream.Add(source, StreamedTestCloud.Geo(source));
            long read = 0;
            while (read == 0)
                read += StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Overview()).ReadBytes;
            string other = path + ".new";
            File.WriteAllBytes(other, sound);
            File.Delete(path);
            File.Move(other, path);
            StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Overview());
            Assert.That(m_stream.Drawn.AsArray().ToArray().Select(d => (d.Page, d.Node)), Has.Some.EqualTo((0, 0)));
        }

        [Test]
        public void Run_UnfinishedFolder_KeepsNothingOpen()
        {
            string part = m_cloud.Path + StoreFormat.UnfinishedSuffix;
            Directory.Move(m_cloud.Path, part);
            var source = new FolderSource(CloudFolder.Open(part), StoreLayout.ColorName);
            m_stream.Add(source, StreamedTestCloud.Geo(source));
            Assert.That(MaxOpenWhileItSettles(), Is.Zero);
        }
    }
}
