using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using FastPoints.Entities;
using FastPoints.Streaming;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;
using Camera = FastPoints.Picture.Camera;

namespace FastPoints.Tests.Entities
{
    public sealed class CloudCopiesTests
    {
        public enum Moment { Waiting, Opening, Opened, Shown }

        static readonly TimeSpan s_maxTime = TimeSpan.FromMinutes(2);

        StreamedTestCloud m_cloud;
        World m_world;
        PointCloudSystemGroup m_group;

        EntityManager Entities => m_world.EntityManager;

        [OneTimeSetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud(4000, 2000);

        [OneTimeTearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        [SetUp]
        public void Begin() => m_group = Begin(out m_world);

        [TearDown]
        public void EndWorld()
        {
            if (m_world.IsCreated)
                m_world.Dispose();
        }

        static PointCloudSystemGroup Begin(out World world)
        {
            world = new World("clouds");
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(world, typeof(PointCloudSystemGroup),
                typeof(OpenCloudsSystem), typeof(PlaceCloudsSystem), typeof(AddCloudsSystem), typeof(ReceiveNodesSystem),
                typeof(SelectNodesSystem), typeof(UploadNodesSystem), typeof(RequestNodesSystem), typeof(ListNodesSystem));
            var group = world.GetExistingSystemManaged<PointCloudSystemGroup>();
            group.Begin(new MemoryNodePool(64 << 20, 1 << 20));
            return group;
        }

        Entity Add(string path, params ComponentType[] more)
        {
            var entity = Entities.CreateEntity(more);
            Entities.AddComponentData(entity, new PointCloudFile());
            new PointCloudPaths { Path = path }.WriteTo(Entities.AddBuffer<PointCloudPathByte>(entity));
            Entities.AddComponentData(entity, new LocalToWorld { Value = float4x4.identity });
            return entity;
        }

        void Frame() => Frame(m_world, m_group);

        static void Frame(World world, PointCloudSystemGroup group)
        {
            var camera = Camera.Perspective(new double3(0, 180, -260), new double3(0, 0, 0), new double3(0, 1, 0), 60);
            group.Views.Add(camera.ToStreamView(StreamedTestCloud.WidthPx, StreamedTestCloud.HeightPx));
            world.Update();
            Thread.Yield();
        }

        void Frames(Func<bool> isDone) => Frames(m_world, m_group, isDone);

        static void Frames(World world, PointCloudSystemGroup group, Func<bool> isDone)
        {
            for (var watch = Stopwatch.StartNew(); watch.Elapsed < s_maxTime && !isDone();)
                Frame(world, group);
            Assert.That(isDone(), Is.True, "nothing came of it");
        }

        bool IsStreamed(Entity entity) => Entities.HasComponent<StreamedPointCloud>(entity);

        int StreamedCount => m_group.Stream.Clouds.Count(c => c != null && !c.IsRemoving);

        long PointsDrawn()
        {
            Frame();
            Frames(() => m_group.Stats.IsSettled && !m_group.IsOpening && !m_group.Stream.IsRemovingAny);
            return m_group.Stats.DrawnPoints;
        }

        void Reach(Entity entity, Moment moment)
        {
            if (moment == Moment.Opening)
                Frame();
            else if (moment == Moment.Opened)
                while (m_group.Live.Find(entity)?.NextSource == null)
                    m_world.GetExistingSystemManaged<OpenCloudsSystem>().Update();
            else if (moment == Moment.Shown)
                PointsDrawn();
        }

        [Test]
        public void Instantiate_AtAnyTime_CreatesAnIndependentCloud([Values] Moment moment)
        {
            var first = Add(m_cloud.Path);
            Reach(first, moment);
            var copy = Entities.Instantiate(first);
            Frames(() => IsStreamed(first) && IsStreamed(copy));
            long both = PointsDrawn();
            int number = Entities.GetComponentData<StreamedPointCloud>(copy).Number;
            Assert.That(Entities.GetComponentData<StreamedPointCloud>(first).Number, Is.Not.EqualTo(number));
            Assert.That(Entities.GetComponentData<PointCloudSpace>(copy).Value,
                Is.EqualTo(Entities.GetComponentData<PointCloudSpace>(first).Value));
            Entities.DestroyEntity(first);
            Assert.That(PointsDrawn(), Is.EqualTo(both / 2).And.GreaterThan(0));
            Assert.That(Entities.GetComponentData<StreamedPointCloud>(copy).Number, Is.EqualTo(number));
            Entities.DestroyEntity(copy);
            Frame();
            Assert.That(Entities.Exists(copy) || Entities.Exists(first), Is.False);
            Assert.That(PointsDrawn(), Is.Zero);
            Assert.That(m_group.Stream.Pool.UsedBytes, Is.Zero);
        }

        [Test]
        public void Instantiate_FailedCloud_FailsItselfAndCanBeRefreshed()
        {
            using var cloud = new StreamedTestCloud(3000, 2000);
            string away = cloud.Path + ".away";
            Directory.Move(cloud.Path, away);
            var first = Add(cloud.Path);
            Frames(() => m_group.ErrorOf(first) != null);
            var copy = Entities.Instantiate(first);
            Assert.That(m_group.ErrorOf(copy), Is.Null);
            Frames(() => m_group.ErrorOf(copy) != null);
            Directory.Move(away, cloud.Path);
            Entities.SetComponentData(copy, new PointCloudFile { NeedsRefresh = true });
            Frames(() => IsStreamed(copy));
            Assert.That((m_group.ErrorOf(copy), IsStreamed(first)), Is.EqualTo(((string)null, false)));
            Assert.That(m_group.ErrorOf(first), Is.Not.Null);
            Assert.That(m_group.ErrorOf(Entity.Null), Is.Null);
            m_world.Dispose();
        }

        [Test]
        public void Prefab_WithLinkedEntities_OpensItsInstancesOnly()
        {
            var root = Entities.CreateEntity(ComponentType.ReadWrite<Prefab>());
            var child = Add(m_cloud.Path, ComponentType.ReadWrite<Prefab>());
            var linked = Entities.AddBuffer<LinkedEntityGroup>(root);
            linked.Add(new LinkedEntityGroup { Value = root });
            linked.Add(new LinkedEntityGroup { Value = child });
            for (int i = 0; i < 20; i++)
                Frame();
            Assert.That(m_group.Live.Find(child), Is.Null);
            Entity Instance() => Entities.GetBuffer<LinkedEntityGroup>(Entities.Instantiate(root), true)[1].Value;
            Entity first = Instance(), second = Instance();
            Frames(() => IsStreamed(first) && IsStreamed(second));
            Assert.That(IsStreamed(child), Is.False);
            Assert.That(PointsDrawn(), Is.GreaterThan(0));

            Entities.AddComponent<Prefab>(first);
            Frames(() => StreamedCount == 1);
            Assert.That(IsStreamed(first), Is.False, "what becomes a prefab is not shown");
            var third = Entities.Instantiate(first);
            Entities.RemoveComponent<Prefab>(first);
            Frames(() => IsStreamed(first) && IsStreamed(third) && StreamedCount == 3);
        }

        [Test]
        public void CommandBuffer_AThousandCopies_AreAThousandClouds()
        {
            const int Count = 1000;
            var commands = new EntityCommandBuffer(Allocator.Temp);
            var made = commands.CreateEntity();
            commands.AddComponent(made, new LocalToWorld { Value = float4x4.identity });
            commands.AddComponent(made, new PointCloudFile());
            new PointCloudPaths { Path = m_cloud.Path }.WriteTo(commands.AddBuffer<PointCloudPathByte>(made));
            for (int i = 1; i < Count; i++)
                commands.Instantiate(made);
            commands.Playback(Entities);
            commands.Dispose();
            var watch = Stopwatch.StartNew();
            using var streamed = Entities.CreateEntityQuery(ComponentType.ReadOnly<StreamedPointCloud>());
            Frames(() => streamed.CalculateEntityCount() == Count);
            TestContext.Out.WriteLine(Count + " clouds are in the stream after " + watch.ElapsedMilliseconds + " ms");
            Assert.That(StreamedCount, Is.EqualTo(Count));
            using var all = streamed.ToEntityArray(Allocator.Temp);
            Entities.DestroyEntity(all);
            Frames(() => StreamedCount == 0 && !m_group.Stream.IsRemovingAny);
            Assert.That(m_group.Stream.Pool.UsedBytes, Is.Zero);
        }

        [Test]
        public void CopyEntitiesFrom_AnotherWorld_DrawsTheCloudInBoth()
        {
            var first = Add(m_cloud.Path);
            PointsDrawn();
            var group = Begin(out var other);
            try
            {
                using var sources = new NativeArray<Entity>(new[] { first }, Allocator.Temp);
                using var copies = new NativeArray<Entity>(1, Allocator.Temp);
                other.EntityManager.CopyEntitiesFrom(Entities, sources, copies);
                Frames(other, group, () => other.EntityManager.HasComponent<StreamedPointCloud>(copies[0]));
                Assert.That(IsStreamed(first), Is.True);
                m_world.Dispose();
                Frames(other, group, () => group.Stats.IsSettled && group.Stats.DrawnPoints > 0);
            }
            finally
            {
                other.Dispose();
            }
        }

        /// <summary>Such entities come from MoveEntitiesFrom and world serialization.</summary>
        [Test]
        public void Entity_StreamedInAnotherWorld_IsOpenedHere()
        {
            var entity = Add(m_cloud.Path);
            Entities.AddComponentData(entity, new StreamedPointCloud { Number = 77, Preview = 78, Next = 79 });
            Frame();
            // Its file may be open by now.
            Assert.That(IsStreamed(entity) && Entities.GetComponentData<StreamedPointCloud>(entity).Number == 77, Is.False);
            Frames(() => IsStreamed(entity));
            Assert.That(Entities.GetComponentData<StreamedPointCloud>(entity).Number, Is.Zero);
            var husk = Entities.CreateEntity(ComponentType.ReadWrite<StreamedPointCloud>());
            Entities.DestroyEntity(husk);
            Frame();
            Assert.That(Entities.Exists(husk), Is.False);
            Assert.That(PointsDrawn(), Is.GreaterThan(0));
        }

        [Test]
        public void Instantiate_CloudWithItsOwnSource_DoesNotShareIt()
        {
            UnsafeUtility.ForgiveLeaks();
            Entity Sourced()
            {
                var source = m_cloud.Open();
                var entity = Entities.CreateEntity(ComponentType.ReadWrite<PointCloudPlacement>());
                Entities.SetComponentData(entity, new PointCloudPlacement { Value = StreamedTestCloud.Geo(source) });
                m_group.SetSource(entity, source);
                return entity;
            }
            var first = Sourced();
            var early = Entities.Instantiate(first);
            Frames(() => IsStreamed(first));
            var late = Entities.Instantiate(first);
            Frame();
            Assert.That((IsStreamed(early), IsStreamed(late), IsStreamed(first)), Is.EqualTo((false, false, true)));
            m_group.SetSource(late, m_cloud.Open());
            m_group.SetSource(late, m_cloud.Open());
            Frame();
            Assert.That(IsStreamed(late), Is.True);
            Entities.DestroyEntity(Sourced());
            Frame();
            m_world.Dispose();
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        [Test]
        public void Paths_OfAnyLengthAndLanguage_AreReadAsTheyWereWritten()
        {
            var entity = Entities.CreateEntity();
            PointCloudPaths Kept(PointCloudPaths paths)
            {
                paths.WriteTo(Entities.AddBuffer<PointCloudPathByte>(entity));
                return PointCloudPaths.Of(PointCloudPaths.BytesOf(Entities.GetBuffer<PointCloudPathByte>(entity, true)));
            }
            string far = "/" + string.Join("/", Enumerable.Repeat("\u00e9\u6e2c\ud83d\udccd", 500));
            var kept = Kept(new PointCloudPaths { Path = far, ProjectPath = "p", ProjectSources = new[] { "a", far, "" } });
            Assert.That((kept.Path, kept.PlayerSource, kept.ProjectPath), Is.EqualTo((far, "", "p")));
            Assert.That(kept.ProjectSources, Is.EqualTo(new[] { "a", far, "" }));
            kept = Kept(new PointCloudPaths { Path = "short", PlayerSource = "s" });
            Assert.That((kept.Path, kept.PlayerSource, kept.ProjectPath), Is.EqualTo(("short", "s", "")));
            Assert.That(kept.ProjectSources, Is.Empty);
            Assert.That(PointCloudPaths.Of(default).Path, Is.Empty);
        }

        [Test]
        public void File_NewComponent_PointsUpAlongZ([Values] UpAxis up)
        {
            Assert.That(new PointCloudFile().Up, Is.EqualTo(UpAxis.Z));
            Assert.That(new PointCloudFile { Up = up }.Up, Is.EqualTo(up));
        }
    }
}
