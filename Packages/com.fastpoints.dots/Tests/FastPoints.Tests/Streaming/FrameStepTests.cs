using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Store;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Tests.Streaming
{
    [Category("Smoke")]
    public unsafe class FrameStepTests
    {
        StreamedTestCloud m_cloud;
        StreamContext m_stream;
        FolderSource m_source;

        [OneTimeSetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud();

        [OneTimeTearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        [SetUp]
        public void OpenCloud() => Open(StreamedTestCloud.Stream());

        void Open(StreamContext stream)
        {
            m_stream?.Dispose();
            m_stream = stream;
            m_source = m_cloud.Open();
            stream.Add(m_source, StreamedTestCloud.Geo(m_source));
        }

        [TearDown]
        public void CloseCloud()
        {
            m_stream.Dispose();
            m_stream = null;
        }

        List<string> Failures() => StreamedTestCloud.Failures(m_stream);

        static HashSet<(int, int, int)> Drawn(StreamContext stream) =>
            new HashSet<(int, int, int)>(stream.Drawn.AsArray().ToArray().Select(d => (d.Cloud, d.Page, d.Node)));

        [Test]
        public void Run_WithoutWorkers_DrawsTheSelection()
        {
            using (new WorkerCount(0))
            {
                var stats = StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Near(20, 30, 0.6));
                Assert.That(stats.DrawnNodes, Is.GreaterThan(1));
            }
            Assert.That(Failures(), Is.Empty);
        }

        [TestCase(StoreLayout.ColorName, 32 << 10)]
        [TestCase(AttributeNames.Intensity, 0)]
        [TestCase(AttributeNames.Intensity, 1 << 20)]
        public void Run_StillCamera_DrawsTheSelectionByteForByte(string plane, int gapBytes)
        {
            m_stream.Dispose();
            m_stream = StreamedTestCloud.Stream();
            m_stream.Settings.MaxGapBytes = gapBytes;
            m_source = m_cloud.Open(plane);
            m_stream.Add(m_source, StreamedTestCloud.Geo(m_source));
            var stats = StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Near(20, 30, 0.6));
            Assert.That(Drawn(m_stream), Is.EquivalentTo(m_stream.Selector.Selected.ToArray()
                .Select(n => (n.Cloud, n.Page, n.Node))));
            Assert.That(stats.DrawnPoints, Is.EqualTo(stats.SelectedPoints).And.GreaterThan(20_000));
            Assert.That(m_stream.Drawn.AsArray().ToArray().Select(d => d.Page).Distinct().Count(), Is.GreaterThan(5));
            foreach (var drawn in m_stream.Drawn.AsArray())
            {
                byte* at = ((MemoryNodePool)m_stream.Pool).AddressOf(drawn.Range);
                byte[] file = File.ReadAllBytes(m_source.PlanesPathOf(drawn.Page));
                for (int p = 0; p < m_source.Planes.Length; p++)
                {
                    var range = m_stream.Clouds[0].RangeOf(drawn.Page, drawn.Node, p);
                    var got = new byte[range.LengthBytes];
                    fixed (byte* to = got)
                        UnsafeUtility.MemCpy(to, at, got.Length);
                    Assert.That(got.SequenceEqual(file.Skip((int)range.OffsetBytes).Take(got.Length)), Is.True);
                    at += range.LengthBytes;
                }
            }
            Assert.That(Failures(), Is.Empty);
        }

        [Test]
        public void Run_DistantPlanes_ReadsNoLargerGapsThanAllowed()
        {
            long BytesRead(int gapBytes, out long requested)
            {
                using var stream = StreamedTestCloud.Stream();
                var source = m_cloud.Open(AttributeNames.Intensity);
                stream.Add(source, StreamedTestCloud.Geo(source));
                stream.Settings.MaxGapBytes = gapBytes;
                long read = requested = 0;
                for (int frame = 0; frame < 1_000_000; frame++)
                {
                    var stats = StreamedTestCloud.Frame(stream, StreamedTestCloud.Overview());
                    read += stats.ReadBytes;
                    requested += stats.RequestedBytes;
                    if (stats.IsSettled)
                        break;
                }
                for (int page = 1; page < source.PageCount; page++)
                    read -= stream.Clouds[0].Pages[page].IsLoaded ? source.TableOf(page).LengthBytes : 0;
                return read;
            }
            Assert.That(BytesRead(0, out long wanted), Is.EqualTo(wanted));
            Assert.That(BytesRead(1 << 20, out long same), Is.GreaterThan(1.2 * same));
            Assert.That(same, Is.EqualTo(wanted));
        }

        [Test]
        public void Run_PositionsAlone_ReadsNothingElse()
        {
            StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Overview());
            long withColor = m_stream.Pool.UsedBytes;
            var bare = new FolderSource(CloudFolder.Open(m_cloud.Path));
            using var stream = StreamedTestCloud.Stream();
            stream.Add(bare, StreamedTestCloud.Geo(bare));
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(stream.Pool.UsedBytes, Is.LessThan(0.8 * withColor));
        }

        [Test]
        public void Run_WhileLoading_DrawsOnlyNodesWithAllAncestors()
        {
            m_stream.Settings.MaxUploadNodesPerFrame = 20;
            m_stream.Settings.MaxBytesPerRead = 50_000;
            var camera = StreamedTestCloud.Near(20, 30, 0.6);
            long max = 0;
            for (int frame = 0; frame < 100_000; frame++)
            {
                var stats = StreamedTestCloud.Frame(m_stream, camera);
                Assert.That(stats.UploadedNodes, Is.LessThanOrEqualTo(20));
                if (stats.DrawnPoints == max && !stats.IsSettled)
                    continue;
                var drawn = Drawn(m_stream);
                foreach (var node in m_stream.Selector.Selected)
                {
                    if (!drawn.Contains((node.Cloud, node.Page, node.Node)) || node.Parent < 0)
                        continue;
                    var parent = m_stream.Selector.Selected[node.Parent];
                    Assert.That(drawn, Has.Member((parent.Cloud, parent.Page, parent.Node)));
                }
                Assert.That(stats.DrawnPoints, Is.GreaterThanOrEqualTo(max));
                max = stats.DrawnPoints;
                if (stats.IsSettled)
                    break;
            }
            Assert.That(max, Is.EqualTo(m_stream.Selector.Points));
        }

        [Test]
        public void Run_PoolTooSmall_KeepsTheMostImportantAndSettles()
        {
            Open(StreamedTestCloud.Stream(256 << 10, 64 << 10));
            var camera = StreamedTestCloud.Near(100, 100, 2);
            StreamedTestCloud.Rest(m_stream, camera);
            var selected = m_stream.Selector.Selected.ToArray();
            var drawn = Drawn(m_stream);
            Assert.That(drawn.Count, Is.InRange(4, selected.Length - 10));
            // The first that has no room is about where what is drawn ends: rooms are cut into pages and banks.
            int first = Array.FindIndex(selected, n => !drawn.Contains((n.Cloud, n.Page, n.Node)));
            Assert.That(first, Is.GreaterThan(drawn.Count * 2 / 3));
            for (int i = 0; i < 50; i++)
            {
                var stats = StreamedTestCloud.Frame(m_stream, camera);
                Assert.That(stats.RequestedNodes + stats.EvictedNodes, Is.Zero);
                Assert.That(stats.PoolBytes, Is.LessThanOrEqualTo(256 << 10));
            }
            Assert.That(m_stream.Pool.FindProblem(), Is.Null);
        }

        [Test]
        public void Run_LimitChanged_IsNeverExceeded()
        {
            var camera = StreamedTestCloud.Overview();
            StreamedTestCloud.Settle(m_stream, camera);
            int all = m_stream.Drawn.Length;
            m_stream.Pool.LimitBytes = 1 << 20;
            var stats = StreamedTestCloud.Frame(m_stream, camera);
            Assert.That(stats.PoolBytes, Is.LessThanOrEqualTo(1 << 20));
            stats = StreamedTestCloud.Rest(m_stream, camera);
            Assert.That(stats.PoolBytes, Is.LessThanOrEqualTo(1 << 20));
            Assert.That(m_stream.Drawn.Length, Is.InRange(1, all - 1));
            m_stream.Pool.LimitBytes = 64 << 20;
            StreamedTestCloud.Settle(m_stream, camera);
            Assert.That(m_stream.Drawn.Length, Is.EqualTo(all));
        }

        [Test]
        public void Run_IdleAndAmongResidentNodes_MakesNoGarbage()
        {
            var camera = StreamedTestCloud.Near(60, 60, 0.6);
            using var views = new NativeArray<StreamView>(1, Allocator.Persistent);
            using var wanted = new NativeList<SelectedNode>(64, Allocator.Persistent);
            var settable = views;
            // The safety checks of the headless host's test build remember each job; nothing else may allocate.
            long OfChecks()
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < 50; i++)
                {
                    m_stream.Selector.Select(settable, m_stream.Settings.Selection);
                    StreamedTestCloud.RunJobsOfAFrame(m_stream, wanted);
                }
                return GC.GetAllocatedBytesForCurrentThread() - before;
            }
            long Garbage(double step)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < 50; i++)
                {
                    var moved = camera;
                    moved.EyeGeo.x += i * step;
                    settable[0] = moved.ToStreamView(StreamedTestCloud.WidthPx, StreamedTestCloud.HeightPx);
                    FrameStep.Run(m_stream, settable);
                }
                return GC.GetAllocatedBytesForCurrentThread() - before;
            }
            m_stream.Settings.PrefetchFrames = 0;
            StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Overview());
            StreamedTestCloud.Settle(m_stream, camera);
            Garbage(1e-6);
            OfChecks();
            StreamedTestCloud.Settle(m_stream, camera);
            Assert.That(Garbage(0), Is.EqualTo(OfChecks()));
            Assert.That(Garbage(1e-6), Is.EqualTo(OfChecks()));
        }

        [Test]
        public void Run_CameraTeleports_CancelsUnneededReads()
        {
            m_stream.Settings.MaxReads = 1;
            m_stream.Settings.MaxBytesPerRead = 1;
            m_stream.Settings.FramesToCancel = 0;
            var random = new Unity.Mathematics.Random(3);
            for (int i = 0; i < 300; i++)
            {
                var position = random.NextFloat2(200);
                StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Near(position.x, position.y, random.NextFloat(6)));
            }
            var camera = StreamedTestCloud.Near(20, 30, 0.6);
            StreamedTestCloud.Settle(m_stream, camera);
            var wanted = Drawn(m_stream);
            Open(StreamedTestCloud.Stream());
            StreamedTestCloud.Settle(m_stream, camera);
            Assert.That(Drawn(m_stream), Is.EquivalentTo(wanted));
            Assert.That(Failures(), Is.Empty);
        }

        [Test]
        public void Run_MovingCamera_Prefetches()
        {
            m_stream.Settings.Selection.PointBudget = 20_000;
            m_stream.Settings.PrefetchFrames = 40;
            StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Overview());
            StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Near(20, 100, 0));
            for (int i = 1; i <= 10; i++)
                StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Near(20 + i * 0.5, 100, 0));
            var limit = m_stream.Selector.Prefetched.ToArray().Select(n => (n.Cloud, n.Page, n.Node)).ToList();
            Assert.That(limit, Is.Not.Empty);
            for (int i = 0; i < 5; i++)
                Assert.That(StreamedTestCloud.Rest(m_stream, StreamedTestCloud.Near(25, 100, 0)).DrawnPoints, Is.GreaterThan(0));
            // They are there before the camera is.
            Assert.That(limit.Count(n => m_stream.Clouds[0].Pages[n.Page].States[n.Node].Slot != NodeState.NoSlot),
                Is.GreaterThan(limit.Count / 2));
            Assert.That(StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Near(25, 100, 0)).DrawnNodes,
                Is.EqualTo(m_stream.Selector.Selected.Length));
        }
    }
}
