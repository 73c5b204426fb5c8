using System;
using System.IO;
using System.Threading;
using FastPoints.Cli;
using FastPoints.Entities;
using FastPoints.Gpu;
using FastPoints.Headless.Graphics;
using FastPoints.HostTests.Cli;
using FastPoints.HostTests.StandIns.Graphics;
using FastPoints.Picture;
using FastPoints.Rendering;
using FastPoints.Streaming;
using NUnit.Framework;
using StandIns.Scene;
using Unity.Collections;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using Camera = UnityEngine.Camera;
using PictureCamera = FastPoints.Picture.Camera;

namespace FastPoints.HostTests.Gpu
{
    /// <summary>A camera of the engine's in each pipeline, clouds of entities, a card: all of the way at once, against the
    /// software rasteriser.</summary>
    public sealed class PipelinePassTests : GraphicsFixture
    {
        const int WidthPx = 320, HeightPx = 180, MostFrames = 200_000;

        ScratchFolder m_scratch;
        string m_cloud;
        World m_world;
        PointCloudSystemGroup m_group;
        PointScene m_scene;
        PipelineHost m_pipeline;

        [OneTimeSetUp]
        public void MakeCloud()
        {
            m_scratch = new ScratchFolder();
            m_cloud = m_scratch["scan.fastpoints"];
            var call = CliCall.Of("convert", m_scratch.Demo(points: 30_000), "-o", m_cloud, "--quiet");
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        }

        [OneTimeTearDown]
        public void DeleteCloud() => m_scratch?.Dispose();

        [SetUp]
        public void MakeWorld()
        {
            m_world = new World("game");
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(PointCloudSystemGroup),
                typeof(CollectViewsSystem), typeof(AddCloudsSystem), typeof(ReceiveNodesSystem), typeof(ControlNodesSystem),
                typeof(SelectNodesSystem), typeof(UploadNodesSystem), typeof(RequestNodesSystem), typeof(ListNodesSystem),
                typeof(TrackNodesSystem));
            m_group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
            var shaders = new GpuShaders();
            m_group.Begin(shaders.CreatePool(64 << 20, 8 << 20, 1 << 20));
            m_group.Stream.Settings.Selection.SmallestNodePx = 0;
            m_group.Stream.Settings.Selection.FinestSpacingPx = 0;
            PointScene.Current = m_scene = new PointScene(shaders.Points, shaders.Compose, m_group.Stream)
            {
                Style = new PointStyle { Shape = PointShape.Disc, Size = PointSize.Pixels(3) },
            };
        }

        [TearDown]
        public void EndWorld()
        {
            m_pipeline?.Dispose();
            HeadlessGraphics.WaitForIdle();
            m_scene.Dispose();
            m_world.Dispose();
        }

        /// <summary>A cloud of the world's, around its origin.</summary>
        PicturePlan Add(StreamContext reference, PictureOptions options, out CloudPlacement placement)
        {
            var plan = FlightCloud.Add(m_cloud, reference, options, default, out var ranges, out int number);
            placement = reference.Clouds[number].Placement;
            placement.OriginWorld -= math.round(ranges.Robust.Center);
            reference.Clouds[number].Placement = placement;
            var source = new FolderSource(Store.CloudFolder.Open(m_cloud), Store.StoreLayout.ColorName);
            var entities = m_world.EntityManager;
            var entity = entities.CreateEntity(ComponentType.ReadWrite<PointCloudPlacement>());
            entities.SetComponentData(entity, new PointCloudPlacement { Value = placement });
            entities.AddComponentObject(entity, new PointCloudSource { Source = source });
            m_scene.SetLook(0, CloudLooks.Of(plan.Colors, source));
            return plan;
        }

        static Camera CameraAt(PictureCamera at, Matrix4x4 projection, RenderTexture target)
        {
            var camera = new GameObject("camera").AddComponent<Camera>();
            var place = Matrix4x4.identity;
            place.SetColumn(3, new Vector4((float)at.EyeGeo.x, (float)at.EyeGeo.y, (float)at.EyeGeo.z, 1));
            SceneLoop.Place(camera.transform, place);
            var view = Matrix4x4.identity;
            view.SetRow(0, Row(at.Right, at.EyeGeo));
            view.SetRow(1, Row(at.Up, at.EyeGeo));
            view.SetRow(2, Row(-at.Forward, at.EyeGeo));
            camera.worldToCameraMatrix = view;
            camera.projectionMatrix = projection;
            camera.targetTexture = target;
            return camera;
        }

        static Vector4 Row(double3 axis, double3 eye) => new Vector4((float)axis.x, (float)axis.y, (float)axis.z, (float)-math.dot(axis, eye));

        RgbaImage Render(Camera camera)
        {
            for (int frame = 0; frame < MostFrames; frame++)
            {
                m_pipeline.Render(camera);
                m_world.Update();
                HeadlessGraphics.EndFrame();
                if (frame > 2 && m_group.Stats.IsSettled)
                    break;
                Thread.Yield();
            }
            Assert.That(m_group.Stats.IsSettled, Is.True, "streaming did not come to rest");
            m_pipeline.Render(camera);
            var request = AsyncGPUReadback.Request(camera.targetTexture);
            request.WaitForCompletion();
            // Into a texture the engine draws with the lowest row first.
            var pixels = request.GetData<byte>().ToArray();
            var image = new RgbaImage(WidthPx, HeightPx);
            for (int row = 0; row < HeightPx; row++)
                Array.Copy(pixels, (HeightPx - 1 - row) * WidthPx * 4, image.Rgba, row * WidthPx * 4, WidthPx * 4);
            return image;
        }

        [TestCase(nameof(BuiltInHost), false)]
        [TestCase(nameof(BuiltInHost), true)]
        [TestCase(nameof(UrpHost), false)]
        [TestCase(nameof(HdrpHost), false)]
        [TestCase(nameof(BuiltInHost), false, 0.3f)]
        [TestCase(nameof(UrpHost), true, 0.3f)]
        [TestCase(nameof(HdrpHost), false, 0.3f)]
        public void Render_CameraOfTheEngine_IsThePictureOfTheSoftwareRasterizer(string pipeline, bool isOrthographic, float edlStrength = 0)
        {
            m_scene.Style = new PointStyle { Shape = PointShape.Disc, Size = PointSize.Pixels(3), EdlStrength = edlStrength };
            m_pipeline = PipelineHost.Make(pipeline);
            var options = new PictureOptions
            {
                WidthPx = WidthPx,
                HeightPx = HeightPx,
                PointSizePx = 3,
                RoundPoints = true,
                EdlStrength = edlStrength,
                Color = ColorMode.Rgb,
            };
            using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
            reference.Settings.Selection = m_group.Stream.Settings.Selection;
            using var picture = new StreamedPicture(options);
            var plan = Add(reference, options, out _);
            picture.Add(new StreamedBlocks(reference, 0, plan), plan.Mode);
            var eye = new double3(-60, -45, 40);
            var at = isOrthographic ? PictureCamera.Orthographic(eye, new double3(0, 0, 0), new double3(0, 0, 1), 60)
                : PictureCamera.Perspective(eye, new double3(0, 0, 0), new double3(0, 0, 1), 60);
            var target = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
            target.Create();
            float aspect = (float)WidthPx / HeightPx;
            var camera = CameraAt(at, isOrthographic ? Matrix4x4.Ortho(-30 * aspect, 30 * aspect, -30, 30, 0.1f, 1000)
                : Matrix4x4.Perspective(60, aspect, 0.1f, 10_000), target);
            camera.backgroundColor = new Color(24 / 255f, 26 / 255f, 30 / 255f, 1);
            var drawn = Render(camera);

            using var views = new NativeArray<StreamView>(1, Allocator.Persistent);
            var view = views;
            view[0] = CameraViews.StreamViewOf(camera);
            while (!FrameStep.Run(reference, views).IsSettled)
                Thread.Yield();
            Assert.That(m_group.Stats.DrawnPoints, Is.EqualTo(ReferencePoints(reference)).And.GreaterThan(10_000));
            var wanted = picture.Draw(at);
            int differ = 0, covered = 0;
            for (int y = 0; y < HeightPx; y++)
                for (int x = 0; x < WidthPx; x++)
                {
                    covered += wanted[x, y] != options.Background ? 1 : 0;
                    differ += wanted[x, y] != drawn[x, y] ? 1 : 0;
                }
            string output = Path.Combine(TestContext.CurrentContext.WorkDirectory, pipeline + (isOrthographic ? "-flat" : "") + (edlStrength > 0 ? "-edl" : "") + ".png");
            File.WriteAllBytes(output, Png.Encode(drawn));
            Assert.That(covered, Is.GreaterThan(2000));
            Assert.That(differ / (double)covered, Is.LessThan(0.003), output);
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
            target.Release();
        }

        static long ReferencePoints(StreamContext stream)
        {
            long points = 0;
            unsafe
            {
                foreach (var drawn in stream.Drawn)
                    points += stream.Clouds[drawn.Cloud].Pages[drawn.Page].Nodes[drawn.Node].PointCount;
            }
            return points;
        }

        [TestCase(nameof(BuiltInHost))]
        [TestCase(nameof(UrpHost))]
        [TestCase(nameof(HdrpHost))]
        public void Render_CameraOfAPreview_DrawsNothingAndIsNotSelectedFor(string pipeline)
        {
            m_pipeline = PipelineHost.Make(pipeline);
            var options = new PictureOptions { WidthPx = WidthPx, HeightPx = HeightPx, EdlStrength = 0, Color = ColorMode.Rgb };
            using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
            Add(reference, options, out _);
            var target = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
            target.Create();
            var camera = CameraAt(PictureCamera.Perspective(new double3(-60, -45, 40), new double3(0, 0, 0), new double3(0, 0, 1), 60),
                Matrix4x4.Perspective(60, 16 / 9f, 0.1f, 10_000), target);
            camera.cameraType = CameraType.Preview;
            m_pipeline.Render(camera);
            Assert.That(m_scene.NextViews.Length, Is.Zero);
            camera.cameraType = CameraType.SceneView;
            m_pipeline.Render(camera);
            Assert.That(m_scene.NextViews.Length, Is.EqualTo(1));
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
            target.Release();
        }
    }
}
