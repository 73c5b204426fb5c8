using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Store;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    public unsafe class StreamContextTests
    {
        StreamedTestCloud m_cloud;

        [SetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud(60_000, 4000);

        [TearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        static int[] CloudsDrawn(StreamContext stream) =>
            stream.Drawn.AsArray().ToArray().Select(d => d.Cloud).Distinct().ToArray();

        [Test]
        public void Dispose_WhileItStreams_FreesAll()
        {
            UnsafeUtility.ForgiveLeaks();
            for (int frames = 0; frames < 40; frames++)
            {
                var stream = StreamedTestCloud.Stream();
                m_cloud.Add(stream);
                for (int i = 0; i < frames; i++)
                    StreamedTestCloud.Frame(stream, StreamedTestCloud.Overview());
                stream.Dispose();
                stream.Dispose();
                Assert.That(stream.IsDisposed, Is.True);
            }
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        [Test]
        public void Remove_WhileStreaming_KeepsTheOthersAndFreesItsNumber()
        {
            using var stream = StreamedTestCloud.Stream();
            int first = m_cloud.Add(stream);
            int second = m_cloud.Add(stream, new double3(0, 150, 0));
            for (int frames = 1; frames < 30; frames++)
            {
                for (int i = 0; i < frames; i++)
                    StreamedTestCloud.Frame(stream, StreamedTestCloud.Overview());
                stream.Remove(second);
                stream.Remove(second);
                StreamedTestCloud.Frame(stream, StreamedTestCloud.Overview());
                Assert.That(CloudsDrawn(stream), Has.None.EqualTo(second));
                StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
                Assert.That(stream.Clouds[second], Is.Null);
                Assert.That(m_cloud.Add(stream, new double3(0, 150, 0)), Is.EqualTo(second));
            }
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(CloudsDrawn(stream), Is.EquivalentTo(new[] { first, second }));
            stream.Remove(first);
            stream.Remove(second);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(stream.Pool.AllocatedBytes, Is.Zero);
            Assert.That(stream.Pool.FindProblem(), Is.Null);
        }

        [Test]
        public void Run_MissingChunkFiles_AreReportedOnceAndTheRestIsShown()
        {
            var gone = m_cloud.ChunkFiles.OrderBy(f => f).Take(3).ToArray();
            foreach (string file in gone)
                File.Delete(file);
            using var stream = StreamedTestCloud.Stream();
            m_cloud.Add(stream);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            var failures = StreamedTestCloud.Failures(stream);
            Assert.That(failures.Count, Is.EqualTo(3));
            foreach (string file in gone)
                Assert.That(failures, Has.Some.Contains(Path.GetFileName(file)));
            Assert.That(stream.Drawn.AsArray().ToArray().Select(d => d.Page).Distinct().Count(),
                Is.EqualTo(1 + m_cloud.ChunkFiles.Length));
            for (int i = 0; i < 100; i++)
                Assert.That(StreamedTestCloud.Frame(stream, StreamedTestCloud.Overview()).RequestedNodes, Is.Zero);
        }

        [Test]
        public void Run_ChunkFileDeletedWhileShown_KeepsResidentNodes()
        {
            using var stream = StreamedTestCloud.Stream();
            m_cloud.Add(stream);
            stream.Settings.Selection.PointBudget = 10_000;
            int before = StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview()).DrawnNodes;
            foreach (string file in m_cloud.ChunkFiles)
                File.Delete(file);
            stream.Settings.Selection.PointBudget = 60_000;
            var stats = StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(stats.DrawnNodes, Is.GreaterThanOrEqualTo(before));
            Assert.That(StreamedTestCloud.Failures(stream), Is.Not.Empty.And.All.Contains("cannot be read"));
        }

        [Test]
        public void Run_DamagedPlane_IsAHoleAndNodesBelowAreShown()
        {
            string path;
            using (var folder = CloudFolder.Open(m_cloud.Path))
            {
                path = folder.PlanesPathOf(0);
                var range = folder.Root.PlaneRanges[0];
                byte[] bytes = File.ReadAllBytes(path);
                bytes[range.OffsetBytes + range.LengthBytes / 2] ^= 1;
                File.WriteAllBytes(path, bytes);
            }
            using var stream = StreamedTestCloud.Stream();
            m_cloud.Add(stream);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(StreamedTestCloud.Failures(stream), Is.EqualTo(new[] { path + " at " +
                stream.Clouds[0].RangeOf(0, 0, 0).OffsetBytes + ": node 0 is damaged" }));
            Assert.That(stream.Drawn.Length, Is.GreaterThan(10));
            Assert.That(stream.Drawn.AsArray().ToArray().Select(d => (d.Page, d.Node)), Has.None.EqualTo((0, 0)));
        }

        [Test]
        public void Run_OpenedAgain_ChecksFilesThatChanged()
        {
            List<string> Show()
            {
                using var stream = StreamedTestCloud.Stream();
                m_cloud.Add(stream);
                StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
                Assert.That(stream.Drawn.Length, Is.GreaterThan(10));
                return StreamedTestCloud.Failures(stream);
            }
            string path;
            using (var folder = CloudFolder.Open(m_cloud.Path))
            {
                path = folder.PlanesPathOf(0);
                var written = new DateTime(2026, 1, 2, 3, 4, 5, DateTimeKind.Utc);
                File.SetLastWriteTimeUtc(path, written);
                Assert.That(Show(), Is.Empty);
                byte[] bytes = File.ReadAllBytes(path);
                bytes[folder.Root.PlaneRanges[0].OffsetBytes + folder.Root.PlaneRanges[0].LengthBytes / 2] ^= 1;
                File.WriteAllBytes(path, bytes);
                File.SetLastWriteTimeUtc(path, written);
                Assert.That(Show(), Is.Empty, "not written to, by its time");
                File.SetLastWriteTimeUtc(path, DateTime.UtcNow.AddSeconds(1));
                Assert.That(Show(), Has.Count.EqualTo(1).And.All.Contains("node 0 is damaged"));
            }
            using var again = StreamedTestCloud.Stream();
            var shown = (FolderSource)again.Clouds[m_cloud.Add(again)].Source;
            StreamedTestCloud.Settle(again, StreamedTestCloud.Overview());
            Assert.That(shown.IsVerified(0, 0, 0), Is.False);
            Assert.That(shown.IsVerified(1, 0, 0), Is.True, "in another file");
        }

        /// <summary>What lies outside of a plane is never read, even if the file changed after its hash was right.</summary>
        [Test]
        public void Run_DescriptorChangedAfterItsHashWasRight_IsNotShown()
        {
            using var stream = StreamedTestCloud.Stream();
            m_cloud.Add(stream);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(stream.Clouds[0].Source.IsVerified(0, 0, 0), Is.True);
            string path = stream.Clouds[0].Source.PlanesPathOf(0);
            byte[] bytes = File.ReadAllBytes(path);
            bytes[stream.Clouds[0].RangeOf(0, 0, 0).OffsetBytes + 5] ^= 1;
            File.WriteAllBytes(path, bytes);
            stream.Release(stream.Clouds[0].Pages[0].States[0].Slot);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(StreamedTestCloud.Failures(stream), Has.Count.EqualTo(1).And.All.Contains("node 0 is damaged"));
            Assert.That(stream.Clouds[0].Source.IsVerified(0, 0, 0), Is.False);
            Assert.That(stream.Clouds[0].Source.IsVerified(0, 1, 0), Is.False, "all of the file is checked again");
        }

        [Test]
        public void Run_DamagedTable_IsReportedWithFileAndByte()
        {
            string file = Path.Combine(m_cloud.Path, StoreFormat.HierarchyName);
            byte[] bytes = File.ReadAllBytes(file);
            bytes[FileHeader.SizeBytes + PageHeader.SizeBytes + 5] ^= 1;
            File.WriteAllBytes(file, bytes);
            using var stream = StreamedTestCloud.Stream();
            m_cloud.Add(stream);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(StreamedTestCloud.Failures(stream),
                Has.Count.EqualTo(1).And.All.Contains(Path.GetFileName(file)).And.All.Contains("hash"));
            Assert.That(stream.Drawn.Length, Is.GreaterThan(10));
        }

        [Test]
        public void Run_HierarchyTooLarge_UnloadsPagesOutOfView()
        {
            using var stream = StreamedTestCloud.Stream();
            m_cloud.Add(stream);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            long all = stream.Clouds[0].HierarchyBytes;
            stream.Settings.MaxHierarchyBytes = 0;
            stream.Pool.LimitBytes = 0;
            var away = StreamedTestCloud.Near(-500, -500, 4);
            for (int i = 0; i < 1000; i++)
                StreamedTestCloud.Frame(stream, away);
            Assert.That(stream.Clouds[0].HierarchyBytes, Is.LessThan(all / 2));
            stream.Pool.LimitBytes = 64 << 20;
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(stream.Clouds[0].HierarchyBytes, Is.EqualTo(all));
        }
    }
}
