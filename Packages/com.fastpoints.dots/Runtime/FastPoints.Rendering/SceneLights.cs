using FastPoints.Drawing;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    // From the engine's lights to that of points: linear, with nothing divided by pi, as the engine's own shaders have it.
    internal static class SceneLights
    {
        // From above and the side: for a scene whose Lighting settings name no sun.
        static readonly float3 s_fromAbove = math.normalize(new float3(-0.5f, 1, -0.5f));

        public static PointLighting OfSun()
        {
            var light = OfSunWithoutIntensity();
            var sun = RenderSettings.sun;
            if (sun != null && sun.isActiveAndEnabled)
            {
                var color = VectorOf(sun.color);
                light.Color = GraphicsSettings.lightsUseLinearIntensity ? PointLighting.LinearOf(color) * sun.intensity
                    : PointLighting.LinearOf(color * sun.intensity);
            }
            SetAmbient(ref light, RenderSettings.ambientProbe);
            return light;
        }

        // HDRP's lights are in lux, and only the card knows the exposure: of the sun its direction and colour count.
        public static PointLighting OfSunWithoutIntensity()
        {
            var sun = RenderSettings.sun;
            bool isThere = sun != null && sun.isActiveAndEnabled;
            var direction = isThere ? DirectionOf(sun.transform.localToWorldMatrix) : s_fromAbove;
            var light = PointLighting.Default(direction, new float3(0, 1, 0));
            if (isThere)
                light.Color *= PointLighting.LinearOf(VectorOf(sun.color));
            return light;
        }

        // The light that the pipeline takes for the main one; null for none.
        public static PointLighting Of(in VisibleLight? main)
        {
            var light = new PointLighting { Direction = s_fromAbove };
            if (main != null)
            {
                light.Direction = DirectionOf(main.Value.localToWorldMatrix);
                light.Color = ColorOf(main.Value.finalColor);
            }
            SetAmbient(ref light, RenderSettings.ambientProbe);
            return light;
        }

        // From what URP gives its shaders: place (w: 0 for a direction), colour, 1 / range squared and the cone's scale and
        // offset, the cone's axis.
        public static void Add(ref PointLighting light, Vector3 eye, Vector4 place, Vector4 color, Vector4 attenuation,
            Vector4 axis) => light.Add(new AdditionalLight
            {
                PositionOrDirection = VectorOf(place),
                Color = ColorOf(color),
                OneOverRangeSq = place.w > 0 ? attenuation.x : 0,
                AxisToLight = VectorOf(axis),
                ConeScale = attenuation.z,
                ConeOffset = attenuation.w,
            }, VectorOf(eye));

        static float3 ColorOf(Vector4 color) => IsLinear ? VectorOf(color) : PointLighting.LinearOf(VectorOf(color));

        static bool IsLinear => QualitySettings.activeColorSpace == ColorSpace.Linear;

        // Its order: constant, y, z, x, then the second order. In gamma space its mean becomes linear, the rest in proportion.
        static void SetAmbient(ref PointLighting light, in SphericalHarmonicsL2 probe)
        {
            var mean = Coefficients(probe, 0);
            float3 scale = IsLinear ? 1 : PointLighting.LinearOf(math.max(0, mean)) / math.max(1e-6f, mean);
            light.AmbientAll = mean * scale;
            light.AmbientX = Coefficients(probe, 3) * scale;
            light.AmbientY = Coefficients(probe, 1) * scale;
            light.AmbientZ = Coefficients(probe, 2) * scale;
        }

        static float3 Coefficients(in SphericalHarmonicsL2 probe, int number) =>
            new float3(probe[0, number], probe[1, number], probe[2, number]);

        // Lights shine along their Z.
        static float3 DirectionOf(in Matrix4x4 toWorld) => -math.normalizesafe(VectorOf(toWorld.GetColumn(2)));

        static float3 VectorOf(Vector4 value) => new float3(value.x, value.y, value.z);
    }
}
