using FastPoints.Drawing;
using FastPoints.Picture;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Picture
{
    public class ResolvePictureTests
    {
        const uint White = 0xFFFFFFFF, RadiusOfOne = 1 << 24;

        /// <summary>A row of pixels with these depths (NaN: none), orthographic, one unit a pixel.</summary>
        static uint[] Resolve(float strength, uint background, params float[] depths)
        {
            using var pixels = new NativeArray<ulong>(depths.Length, Allocator.Persistent);
            using var colors = new NativeArray<uint>(depths.Length, Allocator.Persistent);
            var keys = pixels;
            for (int i = 0; i < depths.Length; i++)
                keys[i] = float.IsNaN(depths[i])
                    ? PointDrawing.EmptyPixel
                    : (ulong)PointProjection.DepthToBits(depths[i]) << 32 | RadiusOfOne | White & 0xFFFFFF;
            new ResolvePictureJob
            {
                Pixels = pixels,
                Projection = new PointProjection { WidthPx = depths.Length, HeightPx = 1, IsOrthographic = true, ScalePx = 1 },
                Background = background,
                EdlStrength = strength,
                Colors = colors,
            }.Schedule(1, default).Complete();
            return colors.ToArray();
        }

        [Test]
        public void Resolve_NoLighting_KeepsColoursAndFillsTheBackground() =>
            Assert.That(Resolve(0, 0x80402010, 1, float.NaN, 5), Is.EqualTo(new[] { White, 0x80402010u, White }));

        [Test]
        public void Resolve_FlatSurface_IsNotDarkened() =>
            Assert.That(Resolve(1, 0, 3, 3, 3), Is.EqualTo(new[] { White, White, White }));

        [Test]
        public void Resolve_PixelBehindItsNeighbour_IsDarkenedAndTheNeighbourIsNot()
        {
            var colors = Resolve(1, 0, 1, 5, 5);
            Assert.That(colors[0], Is.EqualTo(White));
            // 4 pixels behind one of eight: exp(-4 / 8) * 255 = 154.7.
            Assert.That(colors[1], Is.EqualTo(0xFF9B9B9Bu));
            Assert.That(colors[2], Is.EqualTo(White));
        }

        /// <summary>3 by 3 pixels of depth 1, the middle empty, and as many more empty as told.</summary>
        [TestCase(0, true), TestCase(2, true), TestCase(3, false)]
        public void Resolve_HoleAmongPixels_IsFilledByTheirMean(int empty, bool isFilled)
        {
            using var pixels = new NativeArray<ulong>(9, Allocator.Persistent);
            using var colors = new NativeArray<uint>(9, Allocator.Persistent);
            var keys = pixels;
            for (int i = 0; i < 9; i++)
                keys[i] = i < empty || i == 4 ? PointDrawing.EmptyPixel
                    : PointDrawing.KeyOf(1, 1, 0, i < 6 ? 0x000010u : 0x00FF20u);
            new ResolvePictureJob
            {
                Pixels = pixels,
                Projection = new PointProjection { WidthPx = 3, HeightPx = 3, IsOrthographic = true, ScalePx = 1 },
                Background = 0x12345678,
                FillsHoles = true,
                Colors = colors,
            }.Schedule(3, default).Complete();
            // Three of the pixels have 0xFF, 0x20.
            int count = 8 - empty;
            uint green = (uint)((3 * 0xFF + count / 2) / count),
                red = (uint)((3 * 0x20 + (count - 3) * 0x10 + count / 2) / count);
            Assert.That(colors[4], Is.EqualTo(isFilled ? 0xFF000000u | green << 8 | red : 0x12345678u));
        }

        const int Edge = 33;

        /// <summary>The light on white pixels of a plane, by the middle one: share 1, from the left, above and behind the
        /// viewer, nothing from the sky.</summary>
        static float LightOnPlane(float3 normal, bool isOrthographic, int lastColumn = Edge, float distance = 500)
        {
            using var pixels = new NativeArray<ulong>(Edge * Edge, Allocator.Persistent);
            using var colors = new NativeArray<uint>(Edge * Edge, Allocator.Persistent);
            var keys = pixels;
            float step = isOrthographic ? 1 : 0.002f;
            var positions = new PixelPositions
            {
                First = new float3(-16, 16, 0) * step,
                StepX = new float3(step, 0, 0),
                StepY = new float3(0, -step, 0),
                Forward = new float3(0, 0, 1),
                IsOrthographic = isOrthographic,
            };
            for (int i = 0; i < Edge * Edge; i++)
            {
                // The plane through (0, 0, distance).
                var across = positions.First + positions.StepX * (i % Edge) + positions.StepY * (i / Edge);
                float depth = isOrthographic ? distance - (normal.x * across.x + normal.y * across.y) / normal.z
                    : distance * normal.z / math.dot(normal, across + positions.Forward);
                depth += i % Edge > lastColumn ? 100 : 0;
                keys[i] = PointDrawing.KeyOf(depth, 1, PointLighting.MaxLitLevel, 0xFFFFFF);
            }
            new ResolvePictureJob
            {
                Pixels = pixels,
                Projection = new PointProjection { WidthPx = Edge, HeightPx = Edge, IsOrthographic = isOrthographic },
                PixelPositions = positions,
                Light = new PointLighting { Direction = math.normalize(new float3(-1, 1, -2)), Color = 1 },
                Colors = colors,
            }.Schedule(Edge, default).Complete();
            return PointLighting.LinearOf((colors[Edge * Edge / 2] & 0xFF) / 255f).x;
        }

        [TestCase(0, 0, true), TestCase(0, 0, false), TestCase(-0.5f, 0.3f, true), TestCase(-0.5f, 0.3f, false)]
        [TestCase(0.2f, -2, true), TestCase(1.5f, 0.7f, false), TestCase(0.4f, 3, false)]
        public void Resolve_LitPlane_IsAsBrightAsItsAngle(float x, float y, bool isOrthographic)
        {
            var normal = math.normalize(new float3(x, y, -1));
            float expected = math.max(0, math.dot(normal, math.normalize(new float3(-1, 1, -2))));
            Assert.That(LightOnPlane(normal, isOrthographic), Is.EqualTo(expected).Within(0.01));
        }

        /// <summary>A micrometre from the eye, or as far as the sun. Where squares of lengths leave single precision, it is a
        /// pixel without a normal: half of the light.</summary>
        [TestCase(1e-15f, true)]
        [TestCase(1e-6f, false), TestCase(0.1f, false), TestCase(1e7f, false), TestCase(1.5e11f, false)]
        [TestCase(1e30f, true)]
        public void Resolve_LitPlaneAtAnyDistance_IsAsBrightAsItsAngle(float distance, bool isLost)
        {
            var normal = math.normalize(new float3(-0.5f, 0.3f, -1));
            float expected = isLost ? 0.5f : math.dot(normal, math.normalize(new float3(-1, 1, -2)));
            Assert.That(LightOnPlane(normal, false, Edge, distance), Is.EqualTo(expected).Within(0.01));
        }

        /// <summary>Seen along itself, as steep as depths can be: the light is one that a surface can have.</summary>
        [TestCase(true), TestCase(false)]
        public void Resolve_LitPlaneSeenAlongItself_HasALight(bool isOrthographic)
        {
            foreach (float x in new[] { 1e2f, 1e3f, 1e4f, 1e6f })
                Assert.That(LightOnPlane(math.normalize(new float3(-x, 0.5f * x, -1)), isOrthographic), Is.InRange(0f, 1f));
        }

        /// <summary>A surface far behind begins beside the pixel: the other side counts.</summary>
        [Test]
        public void Resolve_LitEdge_IsAsBrightAsItsOwnSurface()
        {
            var normal = math.normalize(new float3(-0.5f, 0.3f, -1));
            Assert.That(LightOnPlane(normal, true, Edge / 2), Is.EqualTo(LightOnPlane(normal, true)).Within(0.01));
        }

        [Test]
        public void Resolve_LitPointAlone_HasNoNormal()
        {
            using var pixels = new NativeArray<ulong>(1, Allocator.Persistent);
            using var colors = new NativeArray<uint>(1, Allocator.Persistent);
            var keys = pixels;
            keys[0] = PointDrawing.KeyOf(1, PointDrawing.MaxRadiusPx, PointLighting.MaxLitLevel, 0xFFFFFF);
            var light = new PointLighting { Direction = new float3(0, 0, 1), Color = 0.5f };
            light.SetAmbient(new float3(0, 1, 0), 0.4f, 0.2f);
            new ResolvePictureJob
            {
                Pixels = pixels,
                Projection = new PointProjection { WidthPx = 1, HeightPx = 1 },
                PixelPositions = new PixelPositions { StepX = new float3(1, 0, 0), StepY = new float3(0, 1, 0), Forward = 1 },
                Light = light,
                Colors = colors,
            }.Schedule(1, default).Complete();
            // The mean of the sky and the ground, and half of the main light: 0.55.
            Assert.That(PointLighting.LinearOf((colors[0] & 0xFF) / 255f).x, Is.EqualTo(0.55f).Within(0.005));
        }

        [TestCase(0, 0), TestCase(7, 31), TestCase(3, 1)]
        public void KeyOf_StyleOfAPoint_ComesBack(int litLevel, int radius)
        {
            ulong key = PointDrawing.KeyOf(2, (uint)radius, litLevel, 0xFF123456);
            Assert.That((PointDrawing.LitLevelOf(key), PointDrawing.LightingRadiusOf(key), (uint)key & 0xFFFFFF),
                Is.EqualTo((litLevel, radius, 0x123456u)));
        }

        [Test]
        public void Resolve_NextToBackground_IsNotDarkened() =>
            Assert.That(Resolve(1, 0, float.NaN, 5, float.NaN)[1], Is.EqualTo(White));
    }
}
