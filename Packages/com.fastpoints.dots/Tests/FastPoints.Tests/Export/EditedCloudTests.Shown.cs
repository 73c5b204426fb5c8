using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using FastPoints.Drawing;
using FastPoints.Export;
using FastPoints.Picture;
using FastPoints.Queries;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Surface;
using FastPoints.Tests.Queries;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using Random = System.Random;

namespace FastPoints.Tests.Export
{
    // What scenes and queries show of an edited cloud.
    public unsafe partial class EditedCloudTests
    {
        FolderSource OpenShown()
        {
            var source = FolderSource.OpenWhole(Cloud);
            source.Edits = EditPlan.Of(Cloud, source.Folder.Manifest);
            return source;
        }

        /// <summary>Unpacked from where the last frame would be drawn from.</summary>
        static List<Point> Drawn(StreamContext stream, int number)
        {
            var all = new List<Point>();
            var cloud = stream.Clouds[number];
            var layout = cloud.Source.Layout;
            foreach (var drawn in stream.Drawn.AsArray().ToArray().Where(d => d.Cloud == number))
            {
                int blocks = cloud.Pages[drawn.Page].Nodes[drawn.Node].BlockCount;
                var corner = cloud.Source.Root.Corner + cloud.Pages[drawn.Page].Addresses[drawn.Node].Corner;
                byte* at = ((MemoryNodePool)stream.Pool).AddressOf(drawn.Range);
                int first = all.Count;
                for (int p = 0; p < cloud.Source.Planes.Length; p++)
                {
                    var view = new PlaneView(at, cloud.ShapeOf(drawn.Page, drawn.Node, p), blocks);
                    long bytes = cloud.RangeOf(drawn.Page, drawn.Node, p).LengthBytes;
                    Assert.That(PlaneView.IsValid(at, bytes, view.Shape, blocks));
                    at += bytes;
                    for (int block = 0, point = first; block < blocks; block++)
                        for (int i = 0; i < view.PointsOf(block); i++, point++)
                            if (p == 0)
                                all.Add(new Point
                                {
                                    At = corner + new Grid3((long)view.ValueAt(block, 0, i), (long)view.ValueAt(block, 1, i),
                                        (long)view.ValueAt(block, 2, i)),
                                    Values = new double[s_names.Length],
                                });
                            else
                                Take(all[point], layout, layout.Planes[cloud.Source.Planes[p]], view, block, i);
                }
            }
            return all;
        }

        static void Take(Point point, StoreLayout layout, StoreLayout.Plane plane, PlaneView view, int block, int i)
        {
            byte* value = stackalloc byte[8];
            for (int c = 0; c < plane.ColumnCount; c++)
            {
                int column = plane.FirstColumn + c, name = Array.IndexOf(s_names, layout.NameOfColumn(plane, column));
                var stored = layout.Columns[column];
                OrderedBits.Store(view.ValueAt(block, c, i) * (ulong)stored.Divisor, stored.Type, value);
                if (name >= 0)
                    point.Values[name] = ColumnValues.ToDouble(value, stored.Type, 0);
            }
        }

        static string[] Shown(IEnumerable<Point> points) => Sorted(points.Where(p => !p.IsHidden));

        static long ReadFailures(StreamContext stream)
        {
            int failures = 0;
            for (; stream.TryTakeFailure(out _); failures++) { }
            return failures;
        }

        [TestCase(1, 0.01), TestCase(2, 0.01), TestCase(3, 0.1), TestCase(4, 0.1), TestCase(5, 0.01)]
        public void Stream_OfAnEditedCloud_ShowsWhatBruteForceLeaves(int seed, double zScale)
        {
            UnsafeUtility.ForgiveLeaks();
            ConvertSeeded(zScale: zScale);
            var points = Edit(seed, 12);
            using (var stream = new QueryTestStream(OpenShown()))
            {
                stream.Settle();
                Assert.That(Shown(Drawn(stream.Stream, stream.Cloud)), Is.EqualTo(Shown(points)));
                Assert.That(ReadFailures(stream.Stream), Is.Zero);
            }
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        // Most nodes are made again and again.
        [Test]
        public void Stream_WithoutRoomForAll_ShowsPointsThatAreLeft()
        {
            ConvertSeeded();
            var left = new HashSet<string>(Shown(Edit(2, 12)));
            using var stream = new QueryTestStream(OpenShown());
            var random = new Random(3);
            for (int turn = 0; turn < 12; turn++)
            {
                stream.PointBudget = random.Next(500, 9000);
                for (int frame = 0; frame < 50; frame++)
                    stream.Frame();
                for (int slot = 0; slot < stream.Stream.Cache.SlotCount; slot++)
                    if (stream.Stream.Cache[slot].Phase == CachePhase.Resident && random.Next(3) == 0)
                        stream.Stream.Release(slot);
            }
            stream.PointBudget = long.MaxValue;
            stream.Settle();
            Assert.That(Shown(Drawn(stream.Stream, stream.Cloud)), Is.EquivalentTo(left));
        }

        [Test]
        public void Stream_OfACloudThatWasDeleted_RestsAndDrawsNothing([Values(false, true)] bool isHidden)
        {
            ConvertSeeded(3000);
            var action = isHidden ? EditAction.Hide : EditAction.Delete;
            JobCoroutine.RunToEnd(EditCloud.Run(Cloud, new EditOperation { Action = action }, null));
            using var stream = new QueryTestStream(OpenShown());
            stream.Settle();
            Assert.That(stream.Stream.Drawn.Length, Is.Zero);
            stream.Frame();
            Assert.That(stream.Stream.Reads.InFlightCount, Is.Zero, "nothing is tried again");
            Assert.That(stream.CountInFullDetail(PointQuery.Nearest(default)), Is.Zero);
            Assert.That(ReadFailures(stream.Stream), Is.Zero);
        }

        [Test]
        public void Stream_OfADamagedNode_ReportsIt()
        {
            ConvertSeeded(3000);
            var operation = new EditOperation { Action = EditAction.Classify, Value = new byte[] { 3 } };
            JobCoroutine.RunToEnd(EditCloud.Run(Cloud, operation, null));
            using var stream = new QueryTestStream(OpenShown());
            string path = null;
            long offset = 0;
            using (var reader = ConvertedReader.Open(Cloud))
                path = reader.FileOfBlock(0, out offset);
            byte[] bytes = System.IO.File.ReadAllBytes(path);
            bytes[offset] ^= 1;
            System.IO.File.WriteAllBytes(path, bytes);
            stream.Settle();
            Assert.That(ReadFailures(stream.Stream), Is.EqualTo(1));
        }

        // As scenes do, one state after the other.
        static FolderSource TakeNext(CloudFeed feed)
        {
            for (var watch = Stopwatch.StartNew(); watch.Elapsed.TotalSeconds < 10 && feed.Newest == null; Thread.Yield())
                feed.Update(1);
            Assert.That(feed.Newest, Is.Not.Null, "nothing came of it");
            return (FolderSource)feed.Take(StoreLayout.ColorName, AttributeNames.Classification);
        }

        [Test]
        public void Feed_OfACloudThatIsEditedWhileItStreams_GivesEachState()
        {
            ConvertSeeded(4000);
            List<Point> points;
            using (var stored = ConvertedReader.Open(Cloud))
                points = Read(stored);
            using var feed = CloudFeeds.Open(Cloud);
            var source = TakeNext(feed);
            Assert.That(source.Edits, Is.Null);
            ulong id = source.Folder.Manifest.CloudId;
            using var stream = new QueryTestStream(source);
            var placement = stream.Stream.Clouds[stream.Cloud].Placement;
            for (int step = 0; step < 4; step++)
            {
                // In the middle of what streaming does.
                stream.Frame();
                var operation = new EditOperation { Action = step == 1 ? EditAction.Hide : EditAction.Delete };
                operation.Conditions.Add(FilterExpression.Parse(s_conditions[step % 2].Text));
                if (step < 2)
                {
                    JobCoroutine.RunToEnd(EditCloud.Run(Cloud, operation, null));
                    Apply(operation, points);
                }
                else
                {
                    EditCloud.GoTo(Cloud, 3 - step);
                }
                var next = TakeNext(feed);
                Assert.That(next.Edits?.Operations.Count ?? 0, Is.EqualTo(step < 2 ? step + 1 : 3 - step));
                int number = stream.Stream.Add(next, placement);
                stream.Settle();
                int wanted = step == 1 ? points.Count(p => !p.IsDeleted && !p.IsHidden)
                    : step < 3 ? points.Count(p => !p.IsDeleted) : points.Count;
                Assert.That(Drawn(stream.Stream, number).Count, Is.EqualTo(wanted), "step " + step);
                stream.Stream.Remove(number);
            }
            Assert.That(feed.Newest, Is.Null);
        }

        // While the edited state loads, what is shown stays as fine as it is; where memory does not hold both, it changes all the
        // same.
        [Test]
        public void Versions_OfACloudThatIsEdited_NeverThinOut([Values(false, true)] bool isMemoryScarce)
        {
            ConvertSeeded(cellsLog2: 4);
            Edit(2, 12);
            long limit = 64 << 20;
            for (int pass = isMemoryScarce ? 0 : 1; pass < 2; pass++)
            {
                using var stream = new StreamContext(new MemoryNodePool(limit, 1 << 17));
                using var views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1e9) };
                stream.Settings.Selection = new LodSettings { PointBudget = 4000, Hysteresis = 1 };
                var versions = new CloudVersions(stream);
                versions.Add(FolderSource.OpenWhole(Cloud));
                Frames(() => FrameStep.Run(stream, views).IsSettled);
                int before = versions.ShownNumber, drawn = Drawn(stream, before).Count;
                limit = (stream.Pool.AllocatedBytes * 3 / 2) & ~((1L << 17) - 1);
                Assert.That(drawn, Is.InRange(3000, 4000));
                if (pass == 0)
                    continue;
                versions.Add(OpenShown());
                Frames(() =>
                {
                    FrameStep.Run(stream, views);
                    if (!isMemoryScarce)
                        Assert.That(Drawn(stream, before).Count, Is.EqualTo(drawn));
                    return versions.Update();
                });
                Assert.That(versions.ShownNumber, Is.Not.EqualTo(before));
                Frames(() => FrameStep.Run(stream, views).IsSettled);
                Assert.That(Drawn(stream, versions.ShownNumber).Count, Is.InRange(500, 4000));
            }
        }

        static void Frames(Func<bool> isDone)
        {
            for (var watch = Stopwatch.StartNew(); watch.Elapsed.TotalSeconds < 10; Thread.Yield())
                if (isDone())
                    return;
            Assert.Fail("it did not come to rest");
        }

        [Test]
        public void Feed_WithEditsOfAnotherCloud_ShowsItAsStoredAndSaysSo()
        {
            ConvertSeeded(3000);
            Edit(1, 3);
            System.IO.Directory.Delete(Cloud, true);
            ConvertSeeded(3001);
            using var feed = CloudFeeds.Open(Cloud);
            using var stream = new QueryTestStream(TakeNext(feed));
            stream.Settle();
            Assert.That(Drawn(stream.Stream, stream.Cloud).Count, Is.EqualTo(3001));
            Assert.That(stream.Stream.TryTakeFailure(out var failure), Is.True);
            Assert.That(failure.ToString(), Does.Contain("another cloud"));
            Assert.That(stream.Stream.TryTakeFailure(out _), Is.False);
        }

        [Test]
        public void Queries_OfAnEditedCloud_EqualBruteForce()
        {
            const int seed = 3;
            ConvertSeeded(zScale: 0.1);
            var left = Edit(seed, 12).Where(p => !p.IsDeleted && !p.IsHidden).ToList();
            using var stream = new QueryTestStream(OpenShown());
            var resident = stream.Settle();
            var source = stream.Stream.Clouds[stream.Cloud].Source;
            var worlds = left.Select(p => source.Grid.ToGeo(p.At)).ToArray();
            var texts = new HashSet<string>(left.Select(p => p.ToString()));
            var random = new Unity.Mathematics.Random(seed);
            using var picker = new PointPicker(OpenShown());
            int found = 0;
            for (int i = 0; i < 6; i++)
            {
                var target = worlds[random.NextInt(worlds.Length)];
                var eye = target + math.normalize(random.NextDouble3(-1, 1)) * 20000;
                foreach (var query in new[] { PointQuery.Ray(eye, target - eye, 300), PointQuery.Sphere(target, 3000) })
                {
                    var wanted = QueryTestStream.Distances(query, worlds);
                    Assert.That(resident.Count(query), Is.EqualTo(wanted.Length));
                    Assert.That(stream.CountInFullDetail(query), Is.EqualTo(wanted.Length));
                    QueryTestStream.Check(QueryTestStream.Find(resident, query, 5), wanted, 5, 1e-6, "resident");
                    QueryTestStream.Check(stream.FindInFullDetail(query, 5), wanted, 5, 1e-6, "stored");
                    var pick = PickTestCloud.Find(picker, query, stream.Stream.Clouds[stream.Cloud].Placement,
                        new PickOptions { FinestSpacingShare = 0 }).Point;
                    Assert.That(pick?.Distance ?? -1, Is.EqualTo(wanted.Length > 0 ? wanted[0] : -1).Within(1e-6));
                    if (pick == null)
                        continue;
                    found++;
                    var text = new Point
                    {
                        At = pick.Position,
                        Values = s_names.Select(n => pick.Attributes.First(a => a.Attribute.Name == n).Value).ToArray(),
                    }.ToString();
                    Assert.That(texts.Contains(text), Is.True, "its attributes are as edited: " + text);
                }
            }
            Assert.That(found, Is.GreaterThan(5));
        }

        [Test]
        public void StoredCellsAndPictures_OfAnEditedCloud_ReadWhatIsLeft([Values(1, 3)] int seed)
        {
            ConvertSeeded(zScale: seed == 3 ? 0.1 : 0.01, cellsLog2: 4);
            var points = Edit(seed, 12);
            using var folder = CloudFolder.Open(Cloud);
            var edits = EditPlan.Of(Cloud, folder.Manifest);
            var (read, pictured) = (new List<Point>(), new List<Point>());
            using (var cells = new SurfacePointReader(folder, new SurfaceGrid(1, 40, 0), default, null, s_names)
            {
                PointsPerBatch = 500,
                Edits = edits,
            })
            {
                var root = folder.Manifest.Root;
                JobCoroutine.RunToEnd(cells.Read(root.Corner, root.Corner + new Grid3(root.Side, root.Side, root.Side),
                    batch => TakeBatch(batch, root.Corner, read)));
            }
            Assert.That(Shown(read), Is.EqualTo(Shown(points)));

            using var selection = new NodeSelection(folder) { Edits = edits };
            selection.ChooseEvenly(long.MaxValue);
            using var chosen = new PointBatch(LoadNodes.SchemaFor(folder, s_names), selection.PointCountOrThrow,
                Allocator.Persistent);
            JobCoroutine.RunToEnd(selection.Load(chosen, null));
            AddBatch(chosen, folder.Manifest.Root.Corner, pictured);
            Assert.That(Shown(pictured), Is.EqualTo(Shown(points)));
        }

        static IEnumerator<JobStep> TakeBatch(PointBatch batch, Grid3 corner, List<Point> read)
        {
            AddBatch(batch, corner, read);
            yield break;
        }

        static void AddBatch(PointBatch batch, Grid3 corner, List<Point> read)
        {
            var bytes = (byte*)batch.Bytes.GetUnsafeReadOnlyPtr();
            double ValueOf(string name, int i) => ColumnValues.ToDouble(bytes +
                batch.Column(batch.Schema.IndexOf(name)).OffsetBytes, batch.Schema[batch.Schema.IndexOf(name)].Type, i);
            for (int i = 0; i < batch.Count; i++)
                read.Add(new Point
                {
                    At = corner + new Grid3((long)ValueOf("X", i), (long)ValueOf("Y", i), (long)ValueOf("Z", i)),
                    Values = s_names.Select(n => ValueOf(n, i)).ToArray(),
                });
        }

        [Test]
        public void Pick_OfADeletedPoint_FindsTheOneBehindIt()
        {
            ConvertSeeded(5000);
            using var before = new PointPicker(OpenShown());
            var grid = before.Source.Grid;
            var placement = CloudPlacement.Geo(grid, before.Source.Root);
            var center = grid.ToGeo(before.Source.Root.Corner) + grid.Step * before.Source.Root.Side * 0.5;
            var ray = PointQuery.Ray(center + new double3(0, 0, 1e6), new double3(0, 0, -1), 2000);
            var first = PickTestCloud.Find(before, ray, placement).Point;
            var operation = new EditOperation { Action = EditAction.Delete };
            operation.Boxes.Add(new EditShape { A = first.Position, B = first.Position });
            JobCoroutine.RunToEnd(EditCloud.Run(Cloud, operation, null));
            using var after = new PointPicker(OpenShown());
            var second = PickTestCloud.Find(after, ray, placement).Point;
            Assert.That(second.Distance, Is.GreaterThan(first.Distance));
            // The point itself is gone, and nothing else.
            var hits = PickTestCloud.Find(before, PointQuery.Sphere(grid.ToGeo(second.Position), 1e-6), placement).Point;
            Assert.That(hits.Position, Is.EqualTo(second.Position));
        }
    }
}
