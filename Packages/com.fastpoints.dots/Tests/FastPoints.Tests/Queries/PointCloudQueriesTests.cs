using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using FastPoints.Build;
using FastPoints.Drawing;
using FastPoints.Queries;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Tests.Build;
using FastPoints.Tests.Nodes;
using FastPoints.Tests.Sources;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Queries
{
    [Category("Smoke")]
    public sealed class PointCloudQueriesTests
    {
        PickTestCloud m_cloud;

        [OneTimeSetUp]
        public void Convert() => m_cloud = new PickTestCloud(30_000);

        [OneTimeTearDown]
        public void Delete() => m_cloud.Dispose();

        static readonly CloudPlacement[] s_placements =
        {
            new CloudPlacement(double3x3.identity, new double3(-20, 3, 7)),
            new CloudPlacement(new double3x3(new double3(0, 2, 0), new double3(-3, 0, 0), new double3(0, 0, 0.5)),
                new double3(691_000, 5_334_000, 520)),
            // Mirrored, sheared, a thousandth of its size.
            new CloudPlacement(new double3x3(new double3(0.001, 0.0002, 0), new double3(0.0003, -0.001, 0.0001),
                new double3(0, 0, 0.0011)), new double3(1, 2, 3)),
        };

        FolderSource Open() => new FolderSource(CloudFolder.Open(m_cloud.Path), StoreLayout.ColorName,
            AttributeNames.Classification);

        // Of every shape, around points of a cloud; unit is the world's length of a metre.
        static IEnumerable<PointQuery> QueriesAround(double3[] worlds, double unit, uint seed, int count)
        {
            var random = new Unity.Mathematics.Random(seed);
            for (int i = 0; i < count; i++)
            {
                var target = worlds[random.NextInt(worlds.Length)];
                var eye = target + math.normalize(random.NextDouble3(-1, 1)) * unit * random.NextDouble(0.01, 80);
                var aim = target + random.NextDouble3(-1, 1) * unit * 0.1;
                yield return PointQuery.FromEye(eye, aim - eye, 800, random.NextDouble(0.5, 8));
                yield return PointQuery.Ray(eye, aim - eye, unit * random.NextDouble(0.01, 1));
                var narrowing = PointQuery.Ray(eye, aim - eye, unit);
                narrowing.RadiusPerUnit = -0.9 * unit / math.distance(eye, target);
                yield return narrowing;
                yield return PointQuery.Sphere(aim, unit * random.NextDouble(0, 9));
                yield return PointQuery.Nearest(eye);
                yield return PointQuery.Below(target + new double3(0, unit, 0), unit);
                var turn = new double3x3(math.normalize(random.NextDouble3(-1, 1)), math.normalize(random.NextDouble3(-1, 1)),
                    math.normalize(random.NextDouble3(-1, 1)));
                yield return PointQuery.Box(aim, turn * (unit * random.NextDouble(1, 30)));
            }
        }

        [Test]
        public void Resident_AnyQueryAndPlacement_IsThatOfEveryPoint([Range(0, 2)] int placed,
            [Values(2_000, 1 << 30)] long budget)
        {
            using var stream = new QueryTestStream(Open(), s_placements[placed], budget);
            var points = stream.Settle();
            var worlds = stream.Resident().Select(point => point.World).ToArray();
            Assert.That(worlds.Length, budget > 30_000 ? Is.EqualTo(30_000) : Is.InRange(100, 2_500));
            double unit = math.length(s_placements[placed].Linear.c0), tolerance = 1e-8 * unit + 1e-9;
            int found = 0;
            foreach (var query in QueriesAround(worlds, unit, 9, 12))
            {
                var wanted = QueryTestStream.Distances(query, worlds);
                foreach (int maxHits in new[] { 1, 5, 100 })
                    QueryTestStream.Check(QueryTestStream.Find(points, query, maxHits), wanted, maxHits, tolerance,
                        query.Shape.ToString());
                Assert.That(points.Count(query), Is.EqualTo(wanted.Length), query.Shape.ToString());
                Assert.That(points.TryFindFirst(query, out var first), Is.EqualTo(wanted.Length > 0));
                found += wanted.Length > 0 ? 1 : 0;
                if (wanted.Length == 0)
                    continue;
                Assert.That(first.Cloud, Is.EqualTo(stream.Cloud));
                Assert.That(first.SpacingWorld, budget > 30_000 ? Is.Zero : Is.GreaterThanOrEqualTo(0));
                Assert.That(worlds.Min(world => math.distance(world, first.PositionWorld)), Is.LessThan(1e-8));
            }
            Assert.That(found, Is.InRange(35, 83), "some find points and some do not");
        }

        [Test]
        public void Resident_CloudThatIsTranscoded_IsThatOfEveryPoint()
        {
            using var cloud = new TreeTestCloud(TreeTestCloud.Copc);
            using var stream = new QueryTestStream(cloud.Open());
            var points = stream.Settle();
            var worlds = stream.Resident().Select(point => point.World).ToArray();
            Assert.That(worlds.Length, Is.GreaterThan(1000));
            foreach (var query in QueriesAround(worlds, 1, 6, 5))
            {
                var wanted = QueryTestStream.Distances(query, worlds);
                QueryTestStream.Check(QueryTestStream.Find(points, query, 9), wanted, 9, 1e-6, query.Shape.ToString());
                Assert.That(points.Count(query), Is.EqualTo(wanted.Length), query.Shape.ToString());
            }
            Assert.That(stream.CountInFullDetail(PointQuery.Nearest(worlds[0])), Is.EqualTo(worlds.Length));
            Assert.That(stream.FindInFullDetail(PointQuery.Nearest(worlds[0]), 3).Select(hit => hit.NormalWorld),
                Is.EqualTo(new float3[3]), "it has no normals");
        }

        [Test]
        public void Stored_CoarseStream_FindsEveryPoint([Range(0, 2)] int placed)
        {
            using var stream = new QueryTestStream(Open(), s_placements[placed], 500);
            double unit = math.length(s_placements[placed].Linear.c0), tolerance = 1e-8 * unit + 1e-9;
            var source = stream.Stream.Clouds[stream.Cloud].Source;
            var root = source.Grid.ToGeo(source.Root.Corner);
            var worlds = Enumerable.Range(0, m_cloud.Positions.Length).Select(i => math.mul(s_placements[placed].Linear,
                m_cloud.Geo(i) - root) + s_placements[placed].OriginWorld).ToArray();
            foreach (var query in QueriesAround(worlds, unit, 4, 2))
            {
                var wanted = QueryTestStream.Distances(query, worlds);
                QueryTestStream.Check(stream.FindInFullDetail(query, 7), wanted, 7, tolerance, query.Shape.ToString());
                Assert.That(stream.CountInFullDetail(query), Is.EqualTo(wanted.Length), query.Shape.ToString());
            }
            Assert.That(stream.Queries.Bytes, Is.Zero, "no copy was asked for");
            var hit = stream.FindInFullDetail(PointQuery.Sphere(worlds[7], tolerance), 1).Single();
            Assert.That(hit.SpacingWorld, Is.Zero);
            Assert.That(stream.Queries.TryRead(hit, AttributeNames.Red, out _), Is.False);
            PickedPoint read = null;
            JobCoroutine.RunToEnd(stream.Queries.ReadAllAttributes(hit, point => read = point));
            Assert.That(PickTestCloud.StoredOf(read), Is.EqualTo(m_cloud.Positions[7]));
            Assert.That(read.Attributes.Single(a => a.Attribute.Name == "GpsTime").Value, Is.EqualTo(m_cloud.Times[7]));
        }

        [Test]
        public void Schedule_ManyQueries_AreThoseOfEach([Values(1, 3)] int maxHits)
        {
            using var stream = new QueryTestStream(Open());
            var points = stream.Settle();
            var worlds = stream.Resident().Select(point => point.World).ToArray();
            using var queries = new NativeArray<PointQuery>(QueriesAround(worlds, 1, 2, 40).ToArray(), Allocator.Persistent);
            using var hits = new NativeArray<PointHit>(queries.Length * maxHits, Allocator.Persistent);
            using var counts = new NativeArray<int>(queries.Length, Allocator.Persistent);
            using var totals = new NativeArray<long>(queries.Length, Allocator.Persistent);
            stream.Queries.ScheduleCounts(queries, totals, stream.Queries.Schedule(queries, maxHits, hits, counts)).Complete();
            for (int i = 0; i < queries.Length; i++)
            {
                var alone = QueryTestStream.Find(points, queries[i], maxHits);
                Assert.That(counts[i], Is.EqualTo(alone.Length));
                for (int h = 0; h < alone.Length; h++)
                    Assert.That(hits[i * maxHits + h].Position, Is.EqualTo(alone[h].Position));
                Assert.That(totals[i], Is.EqualTo(points.Count(queries[i])));
            }
            Assert.That(() => stream.Queries.Schedule(queries, maxHits + 1, hits, counts),
                Throws.ArgumentException.With.Message.Contains("wanted room for " + (maxHits + 1) + " hits of 280 queries"));
        }

        /// <summary>By what a normal is: it stays across what it was across, on the side on which it was.</summary>
        [Test]
        public void Stored_CloudWithNormals_HasThemAsTheCloudStands([Range(1, 2)] int placed, [Values] bool isEdited)
        {
            using var cloud = new PickTestCloud(6000);
            JobCoroutine.RunToEnd(AddNormals.Run(cloud.Path, null, null, null));
            var source = new FolderSource(CloudFolder.Open(cloud.Path));
            var removed = new EditOperation { Action = EditAction.Delete };
            removed.Boxes.Add(EditShape.Box(source.Grid, PickTestCloud.OriginGeo - 1000, PickTestCloud.OriginGeo + 40));
            source.Edits = isEdited ? EditPlan.Of(cloud.Path, source.Folder.Manifest, removed) : null;
            using var stream = new QueryTestStream(source, s_placements[placed], 500);
            var stored = AddNormalsTests.NormalsOf(cloud.Path).ToLookup(point => point.Place, point => point.Normal);
            var linear = s_placements[placed].Linear;
            float3 Placed(ushort code)
            {
                var normal = (double3)OctahedralNormal.Decode(code);
                var other = math.abs(normal.z) < 0.9 ? new double3(0, 0, 1) : new double3(1, 0, 0);
                var along = math.normalize(math.cross(normal, other));
                var across = math.cross(math.mul(linear, along), math.mul(linear, math.cross(normal, along)));
                return (float3)(math.normalize(across) * (math.dot(across, math.mul(linear, normal)) < 0 ? -1 : 1));
            }
            var hits = stream.FindInFullDetail(PointQuery.Nearest(s_placements[placed].OriginWorld), 6000);
            Assert.That(hits.Length, isEdited ? Is.InRange(4000, 5500) : Is.EqualTo(6000));
            Assert.That(hits.Count(hit => !hit.NormalWorld.Equals(0)), Is.GreaterThan(hits.Length / 2));
            foreach (var hit in hits)
                Assert.That(stored[hit.PositionGeo].Any(code => code == OctahedralNormal.None ? hit.NormalWorld.Equals(0)
                    : math.distance(hit.NormalWorld, Placed(code)) < 1e-6f), Is.True, hit.PositionGeo.ToString());
        }

        [Test]
        public void Stored_NormalsCannotBeRead_AreUnknownAndHitsStay([Values("damaged", "cut", "gone")] string how,
            [Values] bool isEdited)
        {
            using var cloud = new PickTestCloud(30000);
            JobCoroutine.RunToEnd(AddNormals.Run(cloud.Path, null, null, null));
            var query = PointQuery.Nearest(PickTestCloud.OriginGeo);
            PointHit[] Found()
            {
                var source = new FolderSource(CloudFolder.Open(cloud.Path));
                var removed = new EditOperation { Action = EditAction.Delete };
                removed.Boxes.Add(EditShape.Box(source.Grid, PickTestCloud.OriginGeo - 9, PickTestCloud.OriginGeo + 40));
                source.Edits = isEdited ? EditPlan.Of(cloud.Path, source.Folder.Manifest, removed) : null;
                using var stream = new QueryTestStream(source, null, 500);
                return stream.FindInFullDetail(query, 30000);
            }
            var whole = Found();
            using (var folder = CloudFolder.Open(cloud.Path))
            {
                string path = folder.PathOfComputed(0);
                byte[] bytes = File.ReadAllBytes(path);
                bytes[bytes.Length / 2] ^= 4;
                if (how == "gone")
                    File.Delete(path);
                else
                    File.WriteAllBytes(path, how == "cut" ? bytes[..(bytes.Length / 2)] : bytes);
            }
            var found = Found();
            Assert.That(found.Select(hit => hit.Position), Is.EqualTo(whole.Select(hit => hit.Position)));
            static bool IsKnown(PointHit hit) => !hit.NormalWorld.Equals(0);
            int known = whole.Count(IsKnown);
            Assert.That(known, Is.GreaterThan(20000));
            Assert.That(found.Count(IsKnown), Is.InRange(1, known - 1), "lost in the nodes of one file of several");
            Assert.That(found.Zip(whole, (a, b) => !IsKnown(a) || a.NormalWorld.Equals(b.NormalWorld)), Is.All.True);
        }

        [Test]
        public void TryRead_PointInMemory_HasTheSourcesValues()
        {
            using var stream = new QueryTestStream(Open());
            var points = stream.Settle();
            for (int point = 0; point < 2000; point += 97)
            {
                Assert.That(points.TryFindFirst(PointQuery.Nearest(m_cloud.Geo(point)), out var hit), Is.True);
                Assert.That(hit.PositionGeo, Is.EqualTo(m_cloud.Geo(point)), "not a digit is lost");
                Assert.That(hit.NormalWorld, Is.EqualTo(new float3(0)), "it has none");
                Assert.That(stream.Queries.TryRead(hit, AttributeNames.Classification, out double value), Is.True);
                Assert.That(value, Is.EqualTo(m_cloud.Classes[point]));
                Assert.That(stream.Queries.TryRead(hit, AttributeNames.Red, out value), Is.True);
                Assert.That(value, Is.EqualTo(m_cloud.Reds[point]));
                Assert.That(stream.Queries.TryRead(hit, AttributeNames.GpsTime, out value), Is.False, "it is not streamed");
            }
        }

        [Test]
        public void Update_Budget_IsKept()
        {
            using var stream = new QueryTestStream(Open());
            stream.Settle();
            long all = stream.Queries.Bytes;
            Assert.That(all, Is.GreaterThan(100_000));
            stream.Queries.BudgetBytes = all / 2;
            for (int frame = 0; frame < 20; frame++)
                stream.Frame();
            Assert.That(stream.Queries.Bytes, Is.InRange(all / 4, all / 2));
            Assert.That(stream.Queries.IsComplete, Is.False);
            Assert.That(stream.Queries.Resident.Count(PointQuery.Nearest(default)), Is.InRange(1, 29_999));
            stream.Queries.BudgetBytes = all;
            Assert.That(stream.Settle().Count(PointQuery.Nearest(default)), Is.EqualTo(30_000));
            Assert.That(stream.Queries.Bytes, Is.EqualTo(all));
        }

        [Test]
        public void Update_AtRest_MakesNoGarbage()
        {
            using var stream = new QueryTestStream(Open());
            stream.Settle();
            var worlds = stream.Resident().Select(point => point.World).ToArray();
            using var queries = new NativeArray<PointQuery>(QueriesAround(worlds, 1, 2, 4).ToArray(), Allocator.Persistent);
            using var hits = new NativeArray<PointHit>(queries.Length, Allocator.Persistent);
            using var counts = new NativeArray<int>(queries.Length, Allocator.Persistent);
            var query = queries[0];
            long Garbage(Action frame)
            {
                frame();
                long before = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < 50; i++)
                    frame();
                return GC.GetAllocatedBytesForCurrentThread() - before;
            }
            // The safety checks of the headless host's test build remember each job; nothing else may allocate.
            long ofJobs = Garbage(() => JobHandle.CombineDependencies(default, new FindPointsJob
            {
                Points = stream.Queries.Resident,
                Queries = queries,
                MaxHits = 1,
                Hits = hits,
                CountOfQuery = counts,
            }.ScheduleParallel(queries.Length, 8, default)).Complete());
            Assert.That(Garbage(() =>
            {
                stream.Queries.Update();
                stream.Queries.Schedule(queries, 1, hits, counts).Complete();
                stream.Queries.Resident.TryFindFirst(query, out _);
            }), Is.EqualTo(ofJobs));
        }

        [Test]
        public unsafe void Update_NodeThatIsDamagedMeanwhile_IsNotInTheCopiesWhichAreNotComplete()
        {
            using var cloud = new PickTestCloud(5_000);
            using var stream = new QueryTestStream(new FolderSource(CloudFolder.Open(cloud.Path), StoreLayout.ColorName));
            while (!stream.Frame())
                Thread.Yield();
            var source = stream.Stream.Clouds[stream.Cloud];
            FolderReleases.Release(cloud.Path);
            while (!FolderReleases.HasReleased)
                stream.Frame();
            string file = source.Source.PlanesPathOf(0);
            byte[] bytes = File.ReadAllBytes(file);
            bytes[source.RangeOf(0, 0, 0).OffsetBytes + 40] ^= 1;
            File.WriteAllBytes(file, bytes);
            FolderReleases.Reacquire(cloud.Path);

            int left = 5_000 - source.Pages[0].Nodes[0].PointCount;
            int frames = 0;
            while (stream.Queries.Resident.Count(PointQuery.Nearest(default)) < left || stream.Queries.IsCopying)
            {
                Assert.That(frames++, Is.LessThan(200_000));
                stream.Frame();
                Thread.Yield();
            }
            Assert.That(stream.Queries.Resident.Count(PointQuery.Nearest(default)), Is.EqualTo(left));
            Assert.That(stream.Queries.IsComplete, Is.False);
        }

        [Test]
        public void Update_CloudIsRemoved_ItsCopiesGo()
        {
            using var stream = new QueryTestStream(Open());
            stream.Settle();
            stream.Stream.Remove(stream.Cloud);
            for (int frame = 0; frame < 10; frame++)
                stream.Frame();
            Assert.That(stream.Queries.Bytes, Is.Zero);
            Assert.That(stream.Queries.Resident.TryFindFirst(PointQuery.Nearest(m_cloud.Geo(0)), out _), Is.False);
            Assert.That(stream.FindInFullDetail(PointQuery.Nearest(m_cloud.Geo(0)), 3), Is.Empty);
        }

        [Test]
        public void Update_WhileAJobReads_TheCopiesStay()
        {
            using var stream = new QueryTestStream(Open());
            using var counted = new NativeReference<long>(Allocator.Persistent);
            s_gate.Reset();
            var job = new CountBehindGateJob { Points = stream.Settle(), Counted = counted }.Schedule();
            try
            {
                stream.Queries.AddReader(job);
                long bytes = stream.Queries.Bytes;
                stream.Stream.Remove(stream.Cloud);
                for (int frame = 0; frame < 10; frame++)
                    stream.Frame();
                Assert.That(stream.Queries.Bytes, Is.EqualTo(bytes));
            }
            finally
            {
                s_gate.Set();
                job.Complete();
            }
            Assert.That(counted.Value, Is.EqualTo(30_000));
            stream.Frame();
            Assert.That(stream.Queries.Bytes, Is.Zero);
        }

        static readonly ManualResetEventSlim s_gate = new ManualResetEventSlim();

        struct CountBehindGateJob : IJob
        {
            [ReadOnly] public ResidentPoints Points;
            public NativeReference<long> Counted;

            public void Execute()
            {
                s_gate.Wait();
                Counted.Value = Points.Count(PointQuery.Nearest(default));
            }
        }

        [Test]
        public void Dispose_AtAnyTime_LeavesNothing()
        {
            UnsafeUtility.ForgiveLeaks();
            for (int frames = 0; frames < 12; frames++)
            {
                using var stream = new QueryTestStream(Open());
                _ = stream.Queries.Resident;
                for (int frame = 0; frame < frames; frame++)
                    stream.Frame();
                var search = new JobCoroutine(stream.Queries.FindInFullDetail(PointQuery.Nearest(m_cloud.Geo(frames)), 50,
                    new List<PointHit>()));
                for (int tick = 0; tick < frames; tick++)
                    search.Tick(0.01);
                // Also after its world has ended.
                if (frames % 2 == 1)
                    stream.Queries.Dispose();
                search.Cancel();
            }
            Assert.That(() => UnsafeUtility.CheckForLeaks(), Is.Zero.After(10_000, 10), "what opens is disposed when it has");
        }

        [Test]
        public void Queries_NothingOrOnePointOrEqualOnes_HaveAnOutcome([Values(0, 1, 3000)] int points)
        {
            var transform = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01), Offset = new double3(10, 20, 30) };
            var positions = Enumerable.Repeat(new int3(5, 5, 5), Math.Max(1, points)).ToArray();
            using var cloud = new StreamedTestCloud(4000, MemoryReader.Of(positions, transform, 5000));
            using var stream = new QueryTestStream(cloud.Open());
            if (points == 0)
                stream.Stream.Remove(stream.Cloud);
            for (int frame = 0; points == 0 && frame < 10; frame++)
                stream.Frame();
            var at = new double3(10.05, 20.05, 30.05);
            var resident = stream.Settle();
            var x = new double3(1, 0, 0);
            var edges = new double3x3(x, new double3(0, 1, 0), new double3(0, 0, 1));
            foreach (var (query, holds) in new[]
            {
                (PointQuery.Nearest(default), true),
                (PointQuery.Sphere(at, 0), true),
                (PointQuery.Sphere(at, -1), false),
                (PointQuery.Sphere(double.NaN, 1), false),
                (PointQuery.Ray(at - 5 * x, x, 0), true), // Along the edge of every box.
                (PointQuery.Ray(at + 0.01 * x, x, 1), false),
                (PointQuery.Ray(at, new double3(0, 0, 0), 1), false),
                (PointQuery.Ray(at - new double3(3, 0.5, 0), x, 0.5), true), // It touches the point.
                (PointQuery.Below(at + new double3(0, 2, 0), 1e-3), true),
                (PointQuery.Box(at - 0.5 * x, edges), true), // The point is on a face.
                (PointQuery.Box(at - 0.51 * x, edges), false),
                (PointQuery.Box(at, default), false),
            })
            {
                int wanted = holds ? points : 0;
                Assert.That(resident.Count(query), Is.EqualTo(wanted), query.Shape + " at " + query.OriginWorld);
                Assert.That(QueryTestStream.Find(resident, query, 4), Has.Length.EqualTo(Math.Min(4, wanted)));
                Assert.That(QueryTestStream.Find(resident, query, 0), Is.Empty);
                Assert.That(stream.CountInFullDetail(query), Is.EqualTo(wanted), query.Shape.ToString());
                Assert.That(stream.FindInFullDetail(query, 4), Has.Length.EqualTo(Math.Min(4, wanted)));
            }
            if (points == 0)
                return;
            // A cloud without volume is never hit.
            var flat = stream.Stream.Clouds[stream.Cloud].Placement;
            flat.Linear.c2 = 0;
            stream.Stream.Clouds[stream.Cloud].Placement = flat;
            stream.Queries.Update();
            Assert.That(stream.Queries.Resident.Count(PointQuery.Nearest(default)), Is.Zero);
            Assert.That(stream.CountInFullDetail(PointQuery.Nearest(default)), Is.Zero);
        }

        [TestCase("lion.laz"), TestCase("ca13_d.laz")]
        public void Queries_OfARealCloud_AreThoseOfEveryPoint(string name)
        {
            using var scratch = new TemporaryFolder();
            using (var reader = PointReaders.Open(TestData.PathOrIgnore("data/" + name)))
                JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, scratch.File("cloud.fastpoints"),
                    new ConvertSettings { Attributes = new string[0] }, r => { }, null));
            using var stream = new QueryTestStream(new FolderSource(CloudFolder.Open(scratch.File("cloud.fastpoints"))), null,
                500_000);
            var points = stream.Settle();
            var worlds = stream.Resident().Select(point => point.World).ToArray();
            Assert.That(worlds.Length, Is.InRange(300_000, 700_000));
            double unit = math.cmax(stream.Stream.Clouds[0].Source.Cubes.Size) / 100;
            foreach (var query in QueriesAround(worlds, unit, 3, 4))
            {
                var wanted = QueryTestStream.Distances(query, worlds);
                QueryTestStream.Check(QueryTestStream.Find(points, query, 20), wanted, 20, 1e-8 * unit + 1e-9,
                    query.Shape.ToString());
                Assert.That(points.Count(query), Is.EqualTo(wanted.Length), query.Shape.ToString());
            }
        }
    }
}
