using System.Diagnostics;
using System.IO;
using System.Linq;
using FastPoints.Entities;
using FastPoints.Streaming;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;

namespace FastPoints.Tests.Entities
{
    public sealed class CloudCopiesTests : CloudWorldFixture
    {
        public enum Moment { Waiting, Opening, Opened, Shown }

        StreamedTestCloud m_cloud;

        [OneTimeSetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud(4000, 2000);

        [OneTimeTearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        [SetUp]
        public void Begin()
        {
            MakeWorld();
            Group.Begin(new MemoryNodePool(64 << 20, 1 << 20));
        }

        Entity Add(string path, params ComponentType[] more) =>
            AddFile(new PointCloudPaths { Path = path }, float4x4.identity, more);

        bool IsStreamed(Entity entity) => Entities.HasComponent<StreamedPointCloud>(entity);

        int StreamedCount => Group.Stream.Clouds.Count(c => c != null && !c.IsRemoving);

        long PointsDrawn()
        {
            Frame();
            Frames(() => Group.Stats.IsSettled && !Group.IsOpening && !Group.Stream.IsRemovingAny);
            return Group.Stats.DrawnPoints;
        }

        void Reach(Entity entity, Moment moment)
        {
            if (moment == Moment.Opening)
                Frame();
            else if (moment == Moment.Opened)
                while (Group.Live.Find(entity)?.NextSource == null)
                    World.GetExistingSystemManaged<OpenCloudsSystem>().Update();
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
            Assert.That(Group.Stream.Pool.UsedBytes, Is.Zero);
        }

        [Test]
        public void Instantiate_FailedCloud_FailsItselfAndCanBeRefreshed()
        {
            using var cloud = new StreamedTestCloud(3000, 2000);
            string away = cloud.Path + ".away";
            Directory.Move(cloud.Path, away);
            var first = Add(cloud.Path);
            Frames(() => Group.ErrorOf(first) != null);
            var copy = Entities.Instantiate(first);
            Assert.That(Group.ErrorOf(copy), Is.Null);
            Frames(() => Group.ErrorOf(copy) != null);
            Directory.Move(away, cloud.Path);
            Entities.SetComponentData(copy, new PointCloudFile { NeedsRefresh = true });
            Frames(() => IsStreamed(copy));
            Assert.That((Group.ErrorOf(copy), IsStreamed(first)), Is.EqualTo(((string)null, false)));
            Assert.That(Group.ErrorOf(first), Is.Not.Null);
            Assert.That(Group.ErrorOf(Entity.Null), Is.Null);
            World.Dispose();
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
            Assert.That(Group.Live.Find(child), Is.Null);
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
            Frames(() => StreamedCount == 0 && !Group.Stream.IsRemovingAny);
            Assert.That(Group.Stream.Pool.UsedBytes, Is.Zero);
        }

        [Test]
        public void CopyEntitiesFrom_AnotherWorld_DrawsTheCloudInBoth()
        {
            var first = Add(m_cloud.Path);
            PointsDrawn();
            var firstWorld = World;
            Begin();
            try
            {
                using var sources = new NativeArray<Entity>(new[] { first }, Allocator.Temp);
                using var copies = new NativeArray<Entity>(1, Allocator.Temp);
                Entities.CopyEntitiesFrom(firstWorld.EntityManager, sources, copies);
                Frames(() => IsStreamed(copies[0]));
                Assert.That(firstWorld.EntityManager.HasComponent<StreamedPointCloud>(first), Is.True);
            }
            finally
            {
                firstWorld.Dispose();
            }
            Frames(() => Group.Stats.IsSettled && Group.Stats.DrawnPoints > 0);
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
            var first = AddSource(m_cloud);
            var early = Entities.Instantiate(first);
            Frames(() => IsStreamed(first));
            var late = Entities.Instantiate(first);
            Frame();
            Assert.That((IsStreamed(early), IsStreamed(late), IsStreamed(first)), Is.EqualTo((false, false, true)));
            Group.SetSource(late, m_cloud.Open());
            Group.SetSource(late, m_cloud.Open());
            Frame();
            Assert.That(IsStreamed(late), Is.True);
            Entities.DestroyEntity(AddSource(m_cloud));
            Frame();
            World.Dispose();
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
