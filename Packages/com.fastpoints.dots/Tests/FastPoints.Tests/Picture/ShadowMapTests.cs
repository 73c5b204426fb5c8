using FastPoints.Drawing;
using FastPoints.Picture;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Picture
{
    public sealed class ShadowMapTests
    {
        // A cube of 100 m, from a corner within it; degrees beside metres where lengths differ.
        static ShadowMapProjection FrameOf(double3 origin, double3 lengths, float3 toLight, out Camera camera)
        {
            camera = Camera.Perspective(origin + 60 / lengths, origin + 10 / lengths, new double3(0, 0, 1), 60);
            var frame = new ShadowMapProjection(toLight, lengths);
            frame.Add(camera.ToStreamView(640, 360), new CloudPlacement(double3x3.identity, origin), 50 / lengths, 50 / lengths);
            frame.Fit();
            return frame;
        }

        [TestCase(0, 1, 1), TestCase(1e9, 1, 1), TestCase(0.5, 78_000, 111_000)]
        public void From_AnyPlace_IsWhereTheLightsCameraSeesIt(double origin, double east, double north)
        {
            var lengths = new double3(east, north, 1);
            foreach (var toLight in new[] { new float3(1, 2, 3), new float3(-1, 0.1f, 0.2f), new float3(0, 0, 1) })
            {
                var frame = FrameOf(origin, lengths, toLight, out var camera);
                var projection = new PointProjection(ShadowMap.CameraOf(frame), PositionTransform.Identity,
                    ShadowMapProjection.EdgePx,
                    ShadowMapProjection.EdgePx);
                var seen = frame.From(camera.EyeGeo);
                for (int i = 0; i < 27; i++)
                {
                    var place = origin + new double3(i % 3, i / 3 % 3, i / 9) * 40 / lengths;
                    projection.Project(place.x, place.y, place.z, out double column, out double row, out float depth);
                    var fromEye = (float3)((place - camera.EyeGeo) * lengths);
                    Assert.That(math.dot(seen.Column, fromEye) + seen.Eye.x, Is.EqualTo(column).Within(2e-3));
                    Assert.That(math.dot(seen.Row, fromEye) + seen.Eye.y, Is.EqualTo(row).Within(2e-3));
                    Assert.That(math.dot(seen.Forward, fromEye) + seen.Eye.z, Is.EqualTo(depth).Within(1e-3));
                }
            }
        }

        // A view that sees little has small texels, and all of what it sees is in the map.
        [TestCase(60), TestCase(2)]
        public void Fit_View_HasAllThatItShows(double fovDegrees)
        {
            var camera = Camera.Perspective(new double3(50, -100, 120), new double3(50, 50, 0), new double3(0, 0, 1), fovDegrees);
            var frame = new ShadowMapProjection(new float3(1, 2, 3), 1);
            frame.Add(camera.ToStreamView(640, 360), new CloudPlacement(double3x3.identity, 0), new double3(50, 50, 1),
                new double3(50, 50, 1));
            frame.Fit();
            Assert.That(frame.EdgeWorld, fovDegrees > 30 ? Is.InRange(64, 256) : Is.InRange(4, 32));
            var light = new PointProjection(ShadowMap.CameraOf(frame), PositionTransform.Identity, ShadowMapProjection.EdgePx,
                ShadowMapProjection.EdgePx);
            var picture = new PointProjection(camera, PositionTransform.Identity, 640, 360);
            int shown = 0;
            for (int i = 0; i < 500 * 500; i++)
            {
                var place = new double3(i % 500, i / 500, 0) / 5;
                if (!picture.Project(place.x, place.y, 0, out double x, out double y, out _) || x < 0 || y < 0 || x > 640 ||
                    y > 360)
                    continue;
                shown++;
                light.Project(place.x, place.y, 0, out double column, out double row, out _);
                Assert.That(column, Is.InRange(1, ShadowMapProjection.EdgePx - 1));
                Assert.That(row, Is.InRange(1, ShadowMapProjection.EdgePx - 1));
            }
            Assert.That(shown, Is.GreaterThan(20));
        }

        [TestCase(0, ExpectedResult = 1), TestCase(2, ExpectedResult = 1), TestCase(-2, ExpectedResult = 0)]
        [TestCase(-0.5f, ExpectedResult = 1)] // Within a texel.
        public float At_TexelsByDepth_AreShadedFromBefore(float depth)
        {
            using var pixels = new NativeArray<ulong>(ShadowMapProjection.EdgePx * ShadowMapProjection.EdgePx,
                Allocator.Persistent);
            var keys = pixels;
            for (int i = 0; i < keys.Length; i++)
                keys[i] = PointDrawing.KeyOf(depth, 1, 0, 0);
            var map = new ShadowMap
            {
                Pixels = pixels,
                Shadow = new MainLightShadow
                {
                    Column = new float3(1, 0, 0),
                    Row = new float3(0, 1, 0),
                    Forward = new float3(0, 0, 1),
                    Eye = new float3(500, 500, 0),
                    TexelWorld = 1,
                },
            };
            Assert.That(map.At(new float3(-600, 0, 0), 1), Is.EqualTo(1), "outside of the map");
            Assert.That(map.At(new float3(0, 0, 0), 0.1f), Is.EqualTo(1), "steep");
            return map.At(0, 1);
        }
    }
}
