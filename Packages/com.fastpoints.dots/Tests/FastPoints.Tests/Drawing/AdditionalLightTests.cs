using FastPoints.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Drawing
{
    public sealed class AdditionalLightTests
    {
        static readonly float3 s_up = new float3(0, 1, 0);

        static AdditionalLight Above(float height, float range) => new AdditionalLight
        {
            PositionOrDirection = s_up * height,
            Color = 12,
            OneOverRangeSq = 1 / (range * range),
            ConeOffset = 1,
        };

        // URP: 1 / d^2 * (1 - (d^2 / range^2)^2)^2.
        [TestCase(2, 4, ExpectedResult = 2.637f)]
        [TestCase(2, 1000, ExpectedResult = 3)]
        [TestCase(4, 4, ExpectedResult = 0)]
        public float On_LightAbove_FallsOffWithinItsRange(float height, float range) =>
            math.round(Above(height, range).On(s_up, 0).x * 1000) / 1000;

        [TestCase(0, ExpectedResult = 1)] // Along the axis.
        [TestCase(40, ExpectedResult = 0.366f)]
        [TestCase(60, ExpectedResult = 0)]
        public float On_Cone_FadesAtItsRim(float degrees)
        {
            float inner = math.cos(math.radians(20)), outer = math.cos(math.radians(60));
            var additional = new AdditionalLight { PositionOrDirection = s_up, Color = 1, ConeScale = 1 / (inner - outer) };
            additional.ConeOffset = -outer * additional.ConeScale;
            additional.AxisToLight = new float3(math.sin(math.radians(degrees)), math.cos(math.radians(degrees)), 0);
            return math.round(additional.On(s_up, 0).x * 1000) / 1000;
        }

        [Test]
        public void Add_SixLights_KeepsTheFourBrightestAtTheEye()
        {
            var light = new PointLighting();
            foreach (float height in new float[] { 5, 1, 6, 3, 2, 4 })
                light.Add(Above(height, 100), 0);
            Assert.That(light.AdditionalCount, Is.EqualTo(4));
            Assert.That(new[] { light.Light0.PositionOrDirection.y, light.Light1.PositionOrDirection.y,
                light.Light2.PositionOrDirection.y, light.Light3.PositionOrDirection.y },
                Is.EqualTo(new float[] { 1, 2, 3, 4 }));
        }

        [Test]
        public void From_EyeFarAway_LightsTheSamePlace()
        {
            var light = new PointLighting();
            light.Add(Above(2, 10), 0);
            light.Add(new AdditionalLight { PositionOrDirection = s_up, Color = 1, ConeOffset = 1 }, 0);
            var eye = new double3(3, -4, 5);
            var moved = light.RelativeTo(eye).On(s_up, (float3)(0 - eye));
            Assert.That(moved.x, Is.EqualTo(light.On(s_up, 0).x).Within(1e-5).And.GreaterThan(3));
        }
    }
}
