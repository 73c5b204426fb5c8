using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Sources
{
    [Category("Smoke")]
    public unsafe class TreeSourceTests
    {
        const int MaxFrames = 1_000_000;

        static readonly string[] s_color = { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue };

        static readonly ManualResetEventSlim s_gate = new ManualResetEventSlim(), s_gateBegun = new ManualResetEventSlim();

        static StreamContext Stream(int bankBytes = 1 << 20) => StreamedTestCloud.Stream(64 << 20, bankBytes);

        static int Add(StreamContext stream, TreeSource source) =>
            stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));

        static FrameStats Frame(StreamContext stream, double scalePx) =>
            StreamedTestCloud.Frame(stream, StreamView.Everything(scalePx));

        static FrameStats Settle(StreamContext stream, double scalePx = 1e12) =>
            StreamedTestCloud.Settle(stream, StreamView.Everything(scalePx));

        [Test]
        public void Run_AllSelected_DrawsEveryPointExactly(
            [ValueSource(typeof(TreeTestCloud), nameof(TreeTestCloud.Kinds))] string kind)
        {
            using var cloud = new TreeTestCloud(kind);
            using var stream = Stream();
            var source = cloud.Open(StoreLayout.ColorName, AttributeNames.Intensity);
            int number = Add(stream, source);
            var stats = Settle(stream);
            Assert.That(StreamedTestCloud.Failures(stream), Is.Empty);
            Assert.That(stats.DrawnPoints, Is.EqualTo(3000));
            Assert.That(source.PageCount, Is.GreaterThan(1), "pages of the hierarchy");
            var drawn = StreamedPoints.Drawn(stream, number);
            Assert.That(drawn.SequenceEqual(StreamedPoints.Of(cloud.Path, source.Grid,
                s_color.Append(AttributeNames.Intensity).ToArray())), Is.True);
            Assert.That(stream.Pool.FindProblem(), Is.Null);
        }

        [TestCaseSource(typeof(TreeTestCloud), nameof(TreeTestCloud.Kinds))]
        public void Run_WithoutWorkers_DrawsEveryPoint(string kind)
        {
            using var workers = new WorkerCount(0);
            using var cloud = new TreeTestCloud(kind);
            using var stream = Stream();
            Add(stream, cloud.Open());
            Assert.That(Settle(stream).DrawnPoints, Is.EqualTo(3000));
            Assert.That(StreamedTestCloud.Failures(stream), Is.Empty);
        }

        [Test]
        public void Run_FewLevelsInView_ReadsOnlyTheirHierarchy()
        {
            using var cloud = new TreeTestCloud(TreeTestCloud.Copc, 20_000);
            using var stream = Stream();
            var source = cloud.Open();
            Add(stream, source);
            // The root alone is coarse enough to be seen.
            Settle(stream, 1e-12);
            Assert.That(stream.Drawn.Length, Is.EqualTo(1));
            Assert.That(source.Reader.Tree.LevelCount, Is.EqualTo(5));
            Assert.That(source.PageCount, Is.GreaterThan(1));
            Assert.That(stream.Clouds[0].Pages[1].IsLoaded, Is.False);
            Assert.That(Settle(stream).DrawnPoints, Is.EqualTo(20_000));
            Assert.That(source.Reader.Tree.LevelCount, Is.GreaterThan(7));
        }

        [TestCase(TreeTestCloud.EptBinary), TestCase(TreeTestCloud.Potree1), TestCase(TreeTestCloud.Potree2)]
        public void Run_DeepInOneCorner_ReadsThePagesThere(string kind)
        {
            using var cloud = new TreeTestCloud(kind, 20_000);
            LookIntoACorner(cloud.Path, 20_000, 4);
        }

        [Test]
        public void Run_DeepInOneCornerOfACopc_ReadsThePagesThere()
        {
            var random = new System.Random(3);
            var records = LazRecords.Make(7, 0, 5000, 7);
            foreach (var record in records)
                for (int axis = 0; axis < 3; axis++)
                    BitConverter.GetBytes(random.Next(axis == 2 ? 100 : 1 << 20)).CopyTo(record, 4 * axis);
            var writer = new CopcFileWriter { LevelsPerPage = 1, MaxNodePoints = 4 };
            using var file = new TemporaryFile(writer.Write(records), ".copc.laz");
            LookIntoACorner(file.Path, 5000, 40);
        }

        static void LookIntoACorner(string path, int points, int share)
        {
            using var stream = Stream();
            var source = TreeTestCloud.Open(path);
            var tree = source.Reader.Tree;
            int top = tree.PageCount;
            Add(stream, source);
            var (corner, edge) = DeepestNode(path, out int levels, out int pages);
            stream.ClipBoxes.Add(new ClipBox(corner, corner + edge, false));
            Settle(stream);
            Assert.That(tree.LevelCount, Is.EqualTo(levels), "it is looked at down to its leaf");
            Assert.That(tree.PageCount - top, Is.InRange(1, (pages - top) / share), "of " + (pages - top));
            Assert.That(tree.IsHierarchyRead, Is.False);
            int read = tree.PageCount;
            Settle(stream);
            Assert.That(tree.PageCount, Is.EqualTo(read));
            stream.ClipBoxes.Clear();
            Assert.That(Settle(stream).DrawnPoints, Is.EqualTo(points));
            Assert.That(tree.PageCount, Is.EqualTo(pages));
            Assert.That(StreamedTestCloud.Failures(stream), Is.Empty);
        }

        static (double3 Corner, double3 Edge) DeepestNode(string path, out int levels, out int pages)
        {
            using var reader = PointReaders.Open(path);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            var deepest = reader.Tree[0];
            for (int i = 0; i < reader.Tree.NodeCount; i++)
                if (reader.Tree[i].Level > deepest.Level)
                    deepest = reader.Tree[i];
            levels = reader.Tree.LevelCount;
            pages = reader.Tree.PageCount;
            var edge = reader.Tree.Cube.Size / math.pow(2.0, deepest.Level);
            return (reader.Tree.Cube.Min + edge * (double3)deepest.Cell, edge);
        }

        [Test]
        public void Dispose_WhileItStreams_FreesAll([ValueSource(typeof(TreeTestCloud), nameof(TreeTestCloud.Kinds))] string kind)
        {
            using var cloud = new TreeTestCloud(kind);
            UnsafeUtility.ForgiveLeaks();
            for (int frames = 0; frames < 60; frames += frames < 10 ? 1 : 10)
            {
                var stream = Stream();
                Add(stream, cloud.Open(StoreLayout.ColorName));
                for (int i = 0; i < frames; i++)
                    Frame(stream, 1e12);
                stream.Dispose();
                stream.Dispose();
            }
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        [Test]
        public void Run_WantedThenUnwanted_EndsLikeAFreshLoad(
            [Values(TreeTestCloud.Copc, TreeTestCloud.EptZstandard, TreeTestCloud.Potree2Brotli)] string kind)
        {
            using var cloud = new TreeTestCloud(kind);
            using var stream = Stream();
            int number = Add(stream, cloud.Open(StoreLayout.ColorName));
            stream.Settings.FramesToCancel = 0;
            var random = new Unity.Mathematics.Random(5);
            for (int i = 0; i < 500; i++)
            {
                stream.Settings.Selection.PointBudget = random.NextInt(1, 3000);
                Frame(stream, 1e12);
            }
            stream.Settings.Selection.PointBudget = 10_000;
            Settle(stream);
            Assert.That(StreamedPoints.Drawn(stream, number), Is.EqualTo(
                StreamedPoints.Of(cloud.Path, stream.Clouds[number].Source.Grid, s_color)));
            Assert.That(StreamedTestCloud.Failures(stream), Is.Empty);
            stream.Remove(number);
            Settle(stream);
            Assert.That(stream.Pool.UsedBytes, Is.Zero);
        }

        [Test]
        public void Run_PoolTooSmall_KeepsMostImportantAndSettles([Values(TreeTestCloud.Copc,
            TreeTestCloud.EptBinary)] string kind)
        {
            using var cloud = new TreeTestCloud(kind, 20_000);
            using var stream = StreamedTestCloud.Stream(64 << 10, 32 << 10);
            Add(stream, cloud.Open(StoreLayout.ColorName));
            int quiet = 0;
            for (int frame = 0; frame < MaxFrames && quiet < 20; frame++)
            {
                var stats = Frame(stream, 1e12);
                Assert.That(stats.PoolBytes, Is.LessThanOrEqualTo(64 << 10));
                quiet = stats.ReadsInFlight + stats.RequestedNodes + stats.UploadedNodes == 0 ? quiet + 1 : 0;
                Thread.Yield();
            }
            Assert.That(quiet, Is.EqualTo(20), "it came to rest");
            Assert.That(stream.Drawn.Length, Is.InRange(10, stream.Selector.Selected.Length - 10));
            Assert.That(stream.Pool.FindProblem(), Is.Null);
            Assert.That(StreamedTestCloud.Failures(stream), Is.Empty);
        }

        [Test]
        public void Run_DamagedNode_ReportsAHole()
        {
            var writer = new CopcFileWriter { MaxNodePoints = 60 };
            var bytes = writer.Write(LazRecords.Make(7, 0, 3000, 7));
            // The first record stays, the streams behind it are noise.
            long begin = ChunkOf(bytes, writer, 1);
            for (int i = 60; i < 200; i++)
                bytes[begin + i] = 0xFF;
            using (var file = new TemporaryFile(bytes, ".copc.laz"))
            using (var stream = Stream())
            {
                Add(stream, TreeTestCloud.Open(file.Path, StoreLayout.ColorName));
                var stats = Settle(stream);
                var failures = StreamedTestCloud.Failures(stream);
                Assert.That(failures.Count, Is.EqualTo(1));
                Assert.That(failures[0], Does.Contain(file.Path).And.Contain("damaged"));
                Assert.That(stats.DrawnPoints, Is.EqualTo(3000 - writer.Nodes[1].Records.Count));
                for (int i = 0; i < 50; i++)
                    Assert.That(Frame(stream, 1e12).RequestedNodes, Is.Zero);
            }
        }

        static long ChunkOf(byte[] file, CopcFileWriter writer, int node)
        {
            var of = writer.Nodes[node];
            var (offset, length) = writer.Pages.Last();
            for (long at = offset; at < offset + length; at += CopcEntry.Bytes)
            {
                var entry = CopcEntry.Read(new ByteReader(file, "", 0), (int)at);
                if (entry.Level == of.Level && entry.Cell.Equals(of.Cell))
                    return (long)entry.Offset;
            }
            throw new InvalidOperationException("the node is in no page");
        }

        [Test]
        public void Run_MissingNodeFiles_ReportsHoles()
        {
            using var cloud = new TreeTestCloud(TreeTestCloud.EptLaz);
            using var stream = Stream();
            var source = cloud.Open();
            var gone = Directory.GetFiles(Path.Combine(cloud.Path, "ept-data"), "3-*").OrderBy(f => f).Take(3).ToArray();
            long left = 3000;
            for (int i = 0; i < source.Reader.Tree.NodeCount; i++)
                if (gone.Contains(Path.Combine(cloud.Path, "ept-data", EptEntry.NameOf(source.Reader.Tree[i].Level,
                    source.Reader.Tree[i].Cell) + ".laz")))
                    left -= source.Reader.Tree[i].PointCount;
            foreach (string file in gone)
                File.Delete(file);
            Add(stream, source);
            var stats = Settle(stream);
            var failures = StreamedTestCloud.Failures(stream);
            Assert.That(failures.Count, Is.EqualTo(3));
            foreach (string file in gone)
                Assert.That(failures, Has.Some.Contains(Path.GetFileName(file)));
            Assert.That(stats.DrawnPoints, Is.EqualTo(left).And.LessThan(3000));
        }

        [Test]
        public void Run_FileTruncatedWhileStreamed_ReportsHoles()
        {
            var writer = new CopcFileWriter { MaxNodePoints = 60 };
            var bytes = writer.Write(LazRecords.Make(7, 0, 20_000, 7));
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var stream = Stream();
            Add(stream, TreeTestCloud.Open(file.Path, StoreLayout.ColorName));
            stream.Settings.Selection.PointBudget = 2000;
            long before = Settle(stream).DrawnPoints;
            var share = FileShare.ReadWrite | FileShare.Delete;
            using (var cut = new FileStream(file.Path, FileMode.Open, FileAccess.Write, share))
                cut.SetLength(ChunkOf(bytes, writer, 1));
            stream.Settings.Selection.PointBudget = 20_000;
            var stats = Settle(stream);
            Assert.That(stats.DrawnPoints, Is.GreaterThanOrEqualTo(before / 2).And.LessThan(20_000));
            Assert.That(StreamedTestCloud.Failures(stream).Count, Is.InRange(1, stream.Clouds[0].PageCount));
            for (int i = 0; i < 50; i++)
                Assert.That(Frame(stream, 1e12).RequestedNodes, Is.Zero);
        }

        [Test]
        public void Run_NodesLargerThanABank_ReportHoles()
        {
            var writer = new CopcFileWriter { MaxNodePoints = 4000 };
            using var file = new TemporaryFile(writer.Write(LazRecords.Make(7, 0, 20_000, 7)), ".copc.laz");
            using var stream = StreamedTestCloud.Stream(64 << 20, 16 << 10);
            Add(stream, TreeTestCloud.Open(file.Path, StoreLayout.ColorName));
            var stats = Settle(stream);
            var failures = StreamedTestCloud.Failures(stream);
            Assert.That(failures, Is.Not.Empty.And.All.Contains("a bank of the pool has"));
            Assert.That(stats.DrawnNodes, Is.EqualTo(writer.Nodes.Count(n => n.Records.Count > 0) - failures.Count));
        }

        [Test]
        public void Run_PointsOutsideTheirCubes_AreAllDrawn()
        {
            const int HalfSizeAt = 375 + 54 + 24;
            var bytes = new CopcFileWriter { MaxNodePoints = 600 }.Write(LazRecords.Make(7, 0, 20_000, 7));
            BitConverter.GetBytes(BitConverter.ToDouble(bytes, HalfSizeAt) / (1 << 28)).CopyTo(bytes, HalfSizeAt);
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var stream = Stream();
            var source = TreeTestCloud.Open(file.Path, StoreLayout.ColorName);
            int number = Add(stream, source);
            Assert.That(Settle(stream).DrawnPoints, Is.EqualTo(20_000));
            Assert.That(StreamedPoints.Drawn(stream, number), Is.EqualTo(StreamedPoints.Of(file.Path, source.Grid, s_color)));
            Assert.That(StreamedTestCloud.Failures(stream), Is.Empty);
            Assert.That(stream.Pool.FindProblem(), Is.Null);
        }

        [Test]
        public void Run_CloudsOfDifferentKinds_AreDrawnTogether()
        {
            using var folder = new StreamedTestCloud(20_000, 4000);
            using var copc = new TreeTestCloud(TreeTestCloud.Copc);
            using var potree = new TreeTestCloud(TreeTestCloud.Potree2);
            using var stream = Stream();
            var converted = folder.Open();
            stream.Add(converted, StreamedTestCloud.Geo(converted));
            Add(stream, copc.Open(StoreLayout.ColorName));
            Add(stream, potree.Open(AttributeNames.Intensity));
            Assert.That(Settle(stream).DrawnPoints, Is.EqualTo(26_000));
            stream.Remove(1);
            Assert.That(Settle(stream).DrawnPoints, Is.EqualTo(23_000));
            Assert.That(StreamedTestCloud.Failures(stream), Is.Empty);
        }

        [Test]
        public void TryRentTranscoder_NodesOfSeveralFrames_BeginTogether()
        {
            using var workers = new WorkerCount(1);
            using var cloud = new TreeTestCloud(TreeTestCloud.Copc);
            using var source = cloud.Open();
            var transcoders = new List<NodeTranscoder>();
            for (NodeTranscoder transcoder; (transcoder = source.TryRentTranscoder(1 << 16)) != null;)
                transcoders.Add(transcoder);
            Assert.That(transcoders.Count, Is.EqualTo(4));
            foreach (var transcoder in transcoders)
                source.ReturnTranscoder(transcoder);
            for (int i = 0; i < 2; i++)
                Assert.That(source.TryRentTranscoder(1 << 20), Is.Not.Null);
            Assert.That(source.TryRentTranscoder(1), Is.Null);
        }

        [Test]
        public void Begin_InAChain_IsDecodedAfterTheOthers()
        {
            s_gateBegun.Reset();
            s_gate.Reset();
            using var workers = new WorkerCount(1);
            using var cloud = new TreeTestCloud(TreeTestCloud.Copc);
            using var stream = Stream();
            var source = cloud.Open();
            int number = Add(stream, source);
            Settle(stream);
            var page = stream.Clouds[number].Pages[0];
            var transcoder = (TreeNodeTranscoder)source.TryRentTranscoder(page.Nodes[0].PointCount);
            transcoder.LeaveChain();
            var chain = new TranscoderChain { End = default(GateJob).Schedule() };
            JobHandle.ScheduleBatchedJobs();
            try
            {
                s_gateBegun.Wait();
                transcoder.Join(chain, page.Nodes[0].PointCount);
                transcoder.Begin(page, 0);
                using (var other = source.CreateFullTranscoder())
                {
                    other.Begin(page, 0);
                    Assert.That(other.End(out _), Is.EqualTo(TranscodeResult.Done));
                }
                Assert.That(transcoder.Done.IsCompleted, Is.False);
                Assert.That(chain.End, Is.EqualTo(transcoder.Done));
                Assert.That(chain.Points, Is.EqualTo(page.Nodes[0].PointCount));
            }
            finally
            {
                s_gate.Set();
            }
            Assert.That(transcoder.End(out _), Is.EqualTo(TranscodeResult.Done));
            source.ReturnTranscoder(transcoder);
            Assert.That(chain.Points, Is.EqualTo(0));
        }

        struct GateJob : IJob
        {
            public void Execute()
            {
                s_gateBegun.Set();
                s_gate.Wait();
            }
        }

        [Test]
        public void Run_Idle_MakesNoGarbage()
        {
            using var cloud = new TreeTestCloud(TreeTestCloud.Copc);
            using var stream = Stream();
            using var views = new NativeArray<StreamView>(1, Allocator.Persistent);
            var settable = views;
            settable[0] = StreamView.Everything(1e12);
            Add(stream, cloud.Open());
            Settle(stream);
            // The safety checks of the headless host's test build remember each job; nothing else may allocate.
            long Garbage(Action frame)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < 50; i++)
                    frame();
                return GC.GetAllocatedBytesForCurrentThread() - before;
            }
            using var wanted = new NativeList<SelectedNode>(64, Allocator.Persistent);
            Action select = () =>
            {
                stream.Selector.Select(settable, stream.Settings.Selection);
                StreamedTestCloud.RunJobsOfAFrame(stream, wanted);
            };
            Action run = () => FrameStep.Run(stream, settable);
            Garbage(select);
            Garbage(run);
            Assert.That(Garbage(run), Is.EqualTo(Garbage(select)));
        }

        [TestCase("copc/lone-star.copc.laz", 518_862)]
        [TestCase("copc/ellipsoid.copc.laz", 100_000)]
        [TestCase("copc/simple_with_page.copc.laz", 1065)]
        [TestCase("ept/lion_takanawa_ept_bin/ept.json", 0)]
        [TestCase("ept/lone-star-laszip/ept.json", 518_862)]
        [TestCase("ept/bcbf/ept.json", 0)]
        [TestCase("potree/lion_takanawa/cloud.js", 272_768)]
        [TestCase("potree/v2-autzen-brotli/metadata.json", 110_000)]
        [TestCase("potree/v2-mixedconifer-default/metadata.json", 37_657)]
        public void Run_Sample_DrawsEveryPointExactly(string sample, int points)
        {
            string path = TestData.SampleOrIgnore(sample);
            using var stream = Stream(16 << 20);
            var source = TreeTestCloud.Open(path, StoreLayout.ColorName);
            int number = Add(stream, source);
            Settle(stream);
            Assert.That(StreamedTestCloud.Failures(stream), Is.Empty);
            var expected = StreamedPoints.Of(path, source.Grid, source.Layout.PlaneOf(StoreLayout.ColorName) > 0 ? s_color
                : new string[0]);
            Assert.That(StreamedPoints.Drawn(stream, number).SequenceEqual(expected), Is.True);
            Assert.That(expected.Length, points > 0 ? Is.EqualTo(points) : Is.GreaterThan(0));
        }
    }
}
