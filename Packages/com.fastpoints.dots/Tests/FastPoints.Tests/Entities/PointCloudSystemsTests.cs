using System.Linq;
using System.Threading;
using FastPoints.Entities;
using FastPoints.Queries;
using FastPoints.Streaming;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;
using Camera = FastPoints.Picture.Camera;

namespace FastPoints.Tests.Entities
{
    [Category("Smoke")]
    public sealed class PointCloudSystemsTests : CloudWorldFixture
    {
        const int MaxFrames = 1_000_000;

        StreamedTestCloud m_cloud;
        Entity m_asking;

        [OneTimeSetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud(60_000, 4000);

        [OneTimeTearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        [SetUp]
        public void MakeWorld() => MakeWorld(typeof(ApplyBudgetSystem), typeof(ControlNodesSystem), typeof(TrackNodesSystem),
            typeof(ReportFailuresSystem));

        void Begin(long limitBytes = 64 << 20)
        {
            m_asking = Entities.CreateEntity(ComponentType.ReadWrite<PointCloudNodesWanted>());
            Group.Begin(new MemoryNodePool(limitBytes, 1 << 17));
            Group.Stream.Settings.Selection = StreamedTestCloud.Selection;
        }

        Entity Add() => AddSource(m_cloud);

        FrameStats Settle(Camera camera, bool hasAll = true)
        {
            for (int frame = 0; frame < MaxFrames; frame++)
            {
                var stats = Frame(camera);
                if (stats.IsSettled && (!hasAll || Count<PointCloudNode>() == stats.CachedNodes))
                    return stats;
                Thread.Yield();
            }
            Assert.Fail("streaming did not come to rest");
            return default;
        }

        int Count<T>() where T : unmanaged, IComponentData
        {
            using var query = new EntityQueryBuilder(Allocator.Temp).WithAll<T>().Build(Entities);
            return query.CalculateEntityCount();
        }

        NativeArray<Entity> All<T>() where T : unmanaged, IComponentData
        {
            using var query = new EntityQueryBuilder(Allocator.Temp).WithAll<T>().Build(Entities);
            return query.ToEntityArray(Allocator.Temp);
        }

        [Test]
        public void Update_CaptureDeltaTimeSet_TakesItForFrameSeconds()
        {
            Begin();
            Add();
            double before = Time.realtimeSinceStartupAsDouble;
            Frame(StreamedTestCloud.Overview());
            double between = Time.realtimeSinceStartupAsDouble, later = between;
            while (later == between)
                later = Time.realtimeSinceStartupAsDouble;
            Frame(StreamedTestCloud.Overview());
            float seconds = Group.Stream.FrameSeconds;
            Assert.That(seconds, Is.InRange((float)(later - between), (float)(Time.realtimeSinceStartupAsDouble - before)));
            Time.captureDeltaTime = 1 / 24f;
            try
            {
                Frame(StreamedTestCloud.Overview());
                Assert.That(Group.Stream.FrameSeconds, Is.EqualTo(1 / 24f));
            }
            finally
            {
                Time.captureDeltaTime = 0;
            }
        }

        [Test]
        public void Queries_FirstAsked_FollowTheWorldsFramesFromThenOn()
        {
            Assert.That(Group.Queries, Is.Null, "nothing is streamed");
            Begin();
            Add();
            Settle(StreamedTestCloud.Overview());
            var queries = Group.Queries;
            Assert.That(queries.Bytes, Is.Zero);
            var everything = PointQuery.Nearest(StreamedTestCloud.OriginGeo);
            Assert.That(queries.Resident.Count(everything), Is.Zero);
            for (int frame = 0; frame < MaxFrames && !queries.IsComplete; frame++)
                Settle(StreamedTestCloud.Overview());
            Assert.That(queries.Resident.Count(everything), Is.EqualTo(Group.Stats.DrawnPoints));
            Assert.That(Group.Queries, Is.SameAs(queries));
        }

        [Test]
        public void Update_SourceFails_IsNotRetriedAndOthersAreDrawn()
        {
            Begin();
            var broken = Add();
            Group.Live.Find(broken).NextSource.Dispose();
            Add();
            Assert.That(Settle(StreamedTestCloud.Overview()).DrawnPoints, Is.GreaterThan(20_000));
            Assert.That(Group.ErrorOf(broken), Is.Not.Null);
            Assert.That(Group.Live.Find(broken).NextSource, Is.Null, "it is not tried again");
        }

        [Test]
        public void Update_NewerSourceFails_KeepsDrawingTheOlder()
        {
            Begin();
            var entity = Add();
            long drawn = Settle(StreamedTestCloud.Overview()).DrawnPoints;
            var newer = m_cloud.Open();
            Group.SetSource(entity, newer);
            newer.Dispose();
            Assert.That(Settle(StreamedTestCloud.Overview()).DrawnPoints, Is.EqualTo(drawn));
            Assert.That(Group.ErrorOf(entity), Is.Not.Null);
        }

        [Test]
        public void Update_CloudEntityCreated_IsDrawnWithAnEntityPerResidentNode()
        {
            Begin();
            var cloud = Add();
            var stats = Settle(StreamedTestCloud.Overview());
            Assert.That(stats.DrawnPoints, Is.EqualTo(stats.SelectedPoints).And.GreaterThan(20_000));
            Assert.That(Count<Drawn>(), Is.EqualTo(stats.DrawnNodes));
            Assert.That(Count<Resident>(), Is.EqualTo(stats.CachedNodes));
            Assert.That(Count<Requested>(), Is.Zero);
            Assert.That(Group.Live.Find(cloud).NextSource, Is.Null);
            long points = 0;
            foreach (var entity in All<Drawn>())
            {
                var node = Entities.GetComponentData<PointCloudNode>(entity);
                Assert.That(node.Cloud, Is.EqualTo(cloud));
                points += node.PointCount;
            }
            Assert.That(points, Is.EqualTo(stats.DrawnPoints));
        }

        void SettleStream()
        {
            while (!Frame(StreamedTestCloud.Overview()).IsSettled)
                Thread.Yield();
        }

        [Test]
        public void Update_NodesNotRequested_AreAddedAndRemovedOnRequest()
        {
            Begin();
            Entities.DestroyEntity(m_asking);
            Add();
            SettleStream();
            Assert.That(Count<PointCloudNode>() + Count<Prefab>(), Is.Zero);
            var tint = new Tint { Rgba = CachedNode.White };
            for (int turn = 0; turn < 3; turn++)
            {
                m_asking = Entities.CreateEntity(ComponentType.ReadWrite<PointCloudNodesWanted>());
                var stats = Settle(StreamedTestCloud.Overview());
                Assert.That(Count<PointCloudNode>(), Is.EqualTo(stats.CachedNodes).And.GreaterThan(20));
                Assert.That(Count<Resident>(), Is.EqualTo(stats.CachedNodes));
                Assert.That(Count<Drawn>(), Is.EqualTo(stats.DrawnNodes));
                Assert.That(Count<Requested>() + Count<Hidden>() + Count<Pinned>() + Count<Tint>(), Is.Zero);
                Assert.That(All<PointCloudNode>().ToArray().All(e => Entities.GetComponentData<Tint>(e).Equals(tint)));
                Entities.DestroyEntity(m_asking);
                Frame(StreamedTestCloud.Overview());
                Assert.That(Count<PointCloudNode>(), Is.Zero);
                Assert.That(Frame(StreamedTestCloud.Overview()).DrawnNodes, Is.EqualTo(stats.DrawnNodes));
            }
        }

        [Test]
        public void Update_Idle_ChangesNoEntity()
        {
            Begin();
            Add();
            Settle(StreamedTestCloud.Overview());
            var before = All<PointCloudNode>().ToArray();
            for (int frame = 0; frame < 20; frame++)
                Frame(StreamedTestCloud.Overview());
            Assert.That(All<PointCloudNode>().ToArray(), Is.EqualTo(before));
        }

        [Test]
        public void Update_NodeEntitiesDestroyedByOthers_Continues()
        {
            Begin();
            Add();
            Settle(StreamedTestCloud.Overview());
            Entities.DestroyEntity(All<PointCloudNode>());
            for (int turn = 0; turn < 3; turn++)
                Settle(StreamedTestCloud.Near(30 * turn, 160, 1), false);
            Assert.That(Settle(StreamedTestCloud.Overview(), false).DrawnNodes, Is.GreaterThan(20));
        }

        [Test]
        public void Update_CameraElsewhere_EntitiesFollow()
        {
            // Room for a part of the cloud, so that nodes are given up.
            Begin(1 << 18);
            Add();
            Group.Stream.Settings.Selection.PointBudget = 8000;
            for (int view = 0; view < 6; view++)
            {
                var stats = Settle(StreamedTestCloud.Near(30 * view, 190 - 30 * view, view));
                Assert.That(Count<Drawn>(), Is.EqualTo(stats.DrawnNodes));
                Assert.That(All<PointCloudNode>().ToArray().Select(e => Entities.GetComponentData<PointCloudNode>(e))
                    .Select(n => (n.Page, n.Node)), Is.Unique);
            }
        }

        [Test]
        public void NodeHidden_NodeHiddenByUser_IsNotDrawnUntilShownAgain()
        {
            Begin();
            Add();
            var all = Settle(StreamedTestCloud.Overview());
            var node = All<Drawn>()[0];
            Entities.SetComponentEnabled<Hidden>(node, true);
            var without = Frame(StreamedTestCloud.Overview());
            Assert.That(without.DrawnNodes, Is.EqualTo(all.DrawnNodes - 1));
            Assert.That(without.IsSettled, Is.True);
            Assert.That(Entities.IsComponentEnabled<Drawn>(node), Is.False);
            Entities.SetComponentEnabled<Hidden>(node, false);
            Assert.That(Frame(StreamedTestCloud.Overview()).DrawnNodes, Is.EqualTo(all.DrawnNodes));
        }

        [Test]
        public void NodeTint_NodeTintedByUser_IsInTheDrawList()
        {
            Begin();
            Add();
            Settle(StreamedTestCloud.Overview());
            var entity = All<Drawn>()[3];
            Entities.SetComponentData(entity, new Tint { Rgba = 0xFF0000FF });
            Entities.SetComponentEnabled<Tint>(entity, true);
            Frame(StreamedTestCloud.Overview());
            var node = Entities.GetComponentData<PointCloudNode>(entity);
            foreach (var drawn in Group.Stream.Drawn)
                Assert.That(drawn.Tint, Is.EqualTo(drawn.Page == node.Page && drawn.Node == node.Node
                    ? 0xFF0000FF
                    : CachedNode.White));
        }

        [Test]
        public void NodePinned_NodePinnedByUser_StaysWhenOthersAreEvicted()
        {
            Begin(1 << 18);
            Add();
            Group.Stream.Settings.Selection.PointBudget = 8000;
            Settle(StreamedTestCloud.Near(10, 10, 3));
            // The last that were selected are the first to go.
            var pinned = All<Drawn>().ToArray()
                .OrderByDescending(e => Entities.GetComponentData<PointCloudNode>(e).Page).First();
            Entities.SetComponentEnabled<Pinned>(pinned, true);
            int evicted = 0;
            // On a busy machine frames pass without reads: then there are more of them.
            for (int view = 0; view < 8 || (evicted <= 50 && view < 10_000); view++)
                for (int frame = 0; frame < 200; frame++, Thread.Yield())
                    evicted += Frame(StreamedTestCloud.Near(25 * (view % 8), 200 - 25 * (view % 8), view % 8)).EvictedNodes;
            Assert.That(evicted, Is.GreaterThan(50));
            Assert.That(Entities.Exists(pinned), Is.True);
        }

        [Test]
        public void DestroyEntity_OfACloud_RemovesItAndItsNodesFromTheStream()
        {
            Begin();
            var cloud = Add();
            Settle(StreamedTestCloud.Overview());
            Entities.DestroyEntity(cloud);
            Assert.That(Entities.Exists(cloud), Is.True, "its cleanup component keeps it");
            Settle(StreamedTestCloud.Overview());
            Assert.That(Entities.Exists(cloud), Is.False);
            Assert.That(Count<PointCloudNode>(), Is.Zero);
            Assert.That(Group.Stream.Pool.UsedBytes, Is.Zero);
        }

        [Test]
        public void Placement_OfTheComponent_MovesTheCloud()
        {
            Begin();
            var cloud = Add();
            Settle(StreamedTestCloud.Overview());
            var away = Entities.GetComponentData<PointCloudPlacement>(cloud);
            away.Value.OriginWorld += new double3(0, -1e6, 0);
            Entities.SetComponentData(cloud, away);
            Assert.That(Frame(StreamedTestCloud.Overview()).SelectedNodes, Is.LessThanOrEqualTo(1), "the root always is");
        }

        void AwaitOpen(Entity entity)
        {
            for (int frame = 0; frame < MaxFrames && !Entities.HasComponent<StreamedPointCloud>(entity) &&
                Group.ErrorOf(entity) == null; frame++)
            {
                World.Update();
                Thread.Yield();
            }
        }

        [Test]
        public void File_WithATransform_IsShownThere()
        {
            Begin();
            var entity = AddFile(new PointCloudPaths { Path = m_cloud.Path }, float4x4.Translate(new float3(1000, 20, -300)));
            AwaitOpen(entity);
            var space = Entities.GetComponentData<PointCloudSpace>(entity).Value;
            Assert.That(math.length(space.OriginGeo - StreamedTestCloud.OriginGeo), Is.LessThan(200));
            // The same camera as over the cloud's own coordinates, in Unity's axes.
            double3 At(double3 geo) => space.FromGeo(geo) + new double3(1000, 20, -300);
            var over = StreamedTestCloud.Overview();
            var camera = Camera.Perspective(At(over.EyeGeo), At(StreamedTestCloud.OriginGeo + new double3(100, 100, 0)),
                new double3(0, 1, 0), 60);
            var stats = Settle(camera);
            Assert.That(stats.DrawnPoints, Is.GreaterThan(20_000));
            EndWorld();
            MakeWorld();
            Begin();
            Add();
            Assert.That(Settle(over).DrawnPoints, Is.EqualTo(stats.DrawnPoints));
        }

        [Test]
        public void File_Missing_IsReportedOnceAndOthersStream()
        {
            Begin();
            var broken = AddFile(new PointCloudPaths { Path = m_cloud.Path + "-gone" }, float4x4.identity);
            AwaitOpen(broken);
            Assert.That(Group.ErrorOf(broken), Does.Contain("-gone"));
            Add();
            Assert.That(Settle(StreamedTestCloud.Overview()).DrawnPoints, Is.GreaterThan(20_000));
        }

        [Test]
        public void Budget_OfTheWorld_AppliesFromTheNextFrame()
        {
            Begin();
            Add();
            Settle(StreamedTestCloud.Overview());
            var entity = Entities.CreateEntity(ComponentType.ReadWrite<PointCloudBudget>());
            Entities.SetComponentData(entity, new PointCloudBudget
            {
                Points = 5000,
                PoolBytes = 1 << 17,
                MaxUploadBytesPerFrame = 1 << 14,
                MinNodePx = 2,
            });
            var stats = Frame(StreamedTestCloud.Overview());
            Assert.That(stats.SelectedPoints, Is.LessThanOrEqualTo(5000));
            for (int frame = 0; frame < 100; frame++)
                stats = Frame(StreamedTestCloud.Overview());
            Assert.That(stats.PoolBytes, Is.LessThanOrEqualTo(1 << 17));
        }

        [Test]
        public void Dispose_OfTheWorldWhileItStreams_FreesAll()
        {
            EndWorld();
            UnsafeUtility.ForgiveLeaks();
            for (int frames = 0; frames < 20; frames++)
            {
                MakeWorld();
                Begin();
                Add();
                for (int i = 0; i < frames; i++)
                    Frame(StreamedTestCloud.Overview());
                World.Dispose();
            }
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        [Test]
        public void Update_WithoutAPool_DoesNothing()
        {
            Add();
            World.Update();
            Assert.That(Group.Stream, Is.Null);
        }
    }
}
