using System;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using FastPoints.Entities;
using FastPoints.Streaming;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;
using Camera = FastPoints.Picture.Camera;

namespace FastPoints.Tests.Entities
{
    public abstract class CloudWorldFixture
    {
        static readonly TimeSpan s_maxTime = TimeSpan.FromMinutes(2);

        private protected World World { get; private set; }
        private protected PointCloudSystemGroup Group { get; private set; }

        private protected EntityManager Entities => World.EntityManager;

        private protected void MakeWorld(params Type[] otherSystems)
        {
            World = new World("clouds");
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(World, new[]
            {
                typeof(PointCloudSystemGroup), typeof(OpenCloudsSystem), typeof(PlaceCloudsSystem), typeof(AddCloudsSystem),
                typeof(ReceiveNodesSystem), typeof(SelectNodesSystem), typeof(UploadNodesSystem), typeof(RequestNodesSystem),
                typeof(ListNodesSystem),
            }.Concat(otherSystems).ToArray());
            Group = World.GetExistingSystemManaged<PointCloudSystemGroup>();
        }

        [TearDown]
        public void EndWorld()
        {
            if (World.IsCreated)
                World.Dispose();
        }

        private protected Entity AddFile(PointCloudPaths paths, float4x4 localToWorld, params ComponentType[] more)
        {
            var entity = Entities.CreateEntity(more);
            Entities.AddComponentData(entity, new PointCloudFile());
            paths.WriteTo(Entities.AddBuffer<PointCloudPathByte>(entity));
            Entities.AddComponentData(entity, new LocalToWorld { Value = localToWorld });
            return entity;
        }

        private protected Entity AddSource(StreamedTestCloud cloud)
        {
            var source = cloud.Open();
            var entity = Entities.CreateEntity(ComponentType.ReadWrite<PointCloudPlacement>());
            Entities.SetComponentData(entity, new PointCloudPlacement { Value = StreamedTestCloud.Geo(source) });
            Group.SetSource(entity, source);
            return entity;
        }

        private protected FrameStats Frame(Camera camera)
        {
            Group.Views.Add(camera.ToStreamView(StreamedTestCloud.WidthPx, StreamedTestCloud.HeightPx));
            World.Update();
            return Group.Stats;
        }

        private protected FrameStats Frame() =>
            Frame(Camera.Perspective(new double3(0, 180, -260), new double3(0, 0, 0), new double3(0, 1, 0), 60));

        private protected void Frames(Func<bool> isDone, Action more = null)
        {
            for (var watch = Stopwatch.StartNew(); watch.Elapsed < s_maxTime && !isDone();)
            {
                Frame();
                more?.Invoke();
                Thread.Yield();
            }
            Assert.That(isDone(), Is.True, "nothing came of it");
        }
    }
}
