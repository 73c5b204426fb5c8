using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // The light on a scene's points, linear, along the world's axes. A point of which a share is lit has the colour
    //     albedo * (1 - share + share * (ambient(normal) + main * max(0, dot(normal, direction)) * shadow + additional)).
    // PointLighting.hlsl is its twin.
    internal struct PointLighting
    {
        // A cloud's share is kept in so many parts, three bits beside a pixel's depth: at most a fourteenth off.
        public const int MaxLitLevel = 7;

        // Of the main light, where a pixel has no neighbours that show which way its surface looks: the mean over all surfaces
        // that see the light. The viewer's direction in place of a normal would make such points flicker as the camera turns.
        const float ShareWithoutNormal = 0.5f;

        public float3 Direction; // Towards the main light; a unit vector.
        public float3 Color;

        // Spherical harmonics of order 1: on a surface falls AmbientAll + AmbientX * normal.x + and so on. What order 2 would
        // add is nothing where light changes evenly from the sky to the ground.
        public float3 AmbientAll;
        public float3 AmbientX;
        public float3 AmbientY;
        public float3 AmbientZ;

        // Those that are brightest at the eye; of the four, the first AdditionalCount.
        public AdditionalLight Light0, Light1, Light2, Light3;
        public int AdditionalCount;

        // Level ground is as bright as its own colour by light from 45 degrees.
        public static PointLighting Default(float3 direction, float3 up)
        {
            var light = new PointLighting { Direction = direction, Color = 1.06f };
            light.SetAmbient(up, 0.25f, 0.1f);
            return light;
        }

        public static int LitLevelOf(float share) => (int)math.round(math.saturate(share) * MaxLitLevel);

        // From a sky's light, on what looks up, to the ground's.
        public void SetAmbient(float3 up, float3 sky, float3 ground)
        {
            var half = (sky - ground) / 2;
            (AmbientX, AmbientY, AmbientZ, AmbientAll) = (half * up.x, half * up.y, half * up.z, (sky + ground) / 2);
        }

        // The first of two that are alike stays.
        public void Add(AdditionalLight additional, float3 eye)
        {
            Keep(ref Light0, ref additional, eye);
            Keep(ref Light1, ref additional, eye);
            Keep(ref Light2, ref additional, eye);
            Keep(ref Light3, ref additional, eye);
            AdditionalCount = math.min(AdditionalCount + 1, AdditionalLight.MaxCount);
        }

        static void Keep(ref AdditionalLight kept, ref AdditionalLight additional, float3 eye)
        {
            if (additional.BrightnessAt(eye) > kept.BrightnessAt(eye))
                (kept, additional) = (additional, kept);
        }

        public readonly PointLighting RelativeTo(double3 eye)
        {
            var light = this;
            light.Light0.MakeRelativeTo(eye);
            light.Light1.MakeRelativeTo(eye);
            light.Light2.MakeRelativeTo(eye);
            light.Light3.MakeRelativeTo(eye);
            return light;
        }

        // IEC 61966-2-1; HLSL's PointValues.hlsl and PointLighting.hlsl have the same.
        public static float3 LinearOf(float3 srgb) =>
            math.select(math.pow((srgb + 0.055f) / 1.055f, 2.4f), srgb / 12.92f, srgb <= 0.04045f);

        public static float3 SrgbOf(float3 linear) =>
            math.select(1.055f * math.pow(linear, 1 / 2.4f) - 0.055f, linear * 12.92f, linear <= 0.0031308f);

        // From sRGB to sRGB.
        public readonly float3 Lit(float3 srgb, int litLevel, float3 normal, float3 place, float shadow)
        {
            float share = litLevel / (float)MaxLitLevel;
            return math.saturate(SrgbOf(LinearOf(srgb) * (1 - share + share * On(normal, place, shadow))));
        }

        // normal: 0 where it is not known. place: from the eye. shadow: 1 where the whole main light falls.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly float3 On(float3 normal, float3 place, float shadow = 1)
        {
            var ambient = AmbientAll + AmbientX * normal.x + AmbientY * normal.y + AmbientZ * normal.z;
            var light = math.max(0, ambient) + Color * (Facing(normal, Direction) * shadow);
            return AdditionalCount == 0 ? light
                : light + Light0.On(normal, place) + Light1.On(normal, place) + Light2.On(normal, place) +
                    Light3.On(normal, place);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal static float Facing(float3 normal, float3 direction) =>
            math.lengthsq(normal) > 0 ? math.max(0, math.dot(normal, direction)) : ShareWithoutNormal;
    }

    // A light besides the main one, of the brightness and reach that URP's shaders give it. All zero: none.
    internal struct AdditionalLight
    {
        public const int MaxCount = 4;

        const float MinDistanceSq = 6.1e-5f; // HLSL's HALF_MIN.

        public float3 PositionOrDirection; // The direction towards it where its range is endless.
        public float ConeOffset; // 1, without a cone.
        public float3 Color;
        public float OneOverRangeSq; // 0: endless, and without falling off.
        public float3 AxisToLight; // Of the cone.
        public float ConeScale;

        public readonly float BrightnessAt(float3 place) => math.csum(Color) /
            (OneOverRangeSq > 0 ? math.max(MinDistanceSq, math.distancesq(PositionOrDirection, place)) : 1);

        public void MakeRelativeTo(double3 eye) =>
            PositionOrDirection = OneOverRangeSq > 0 ? (float3)(PositionOrDirection - eye) : PositionOrDirection;

        public readonly float3 On(float3 normal, float3 place)
        {
            var to = OneOverRangeSq > 0 ? PositionOrDirection - place : PositionOrDirection;
            float distanceSq = math.max(MinDistanceSq, math.lengthsq(to));
            to /= math.sqrt(distanceSq);
            float fade = math.saturate(1 - distanceSq * OneOverRangeSq * distanceSq * OneOverRangeSq);
            float cone = math.saturate(math.dot(AxisToLight, to) * ConeScale + ConeOffset);
            float falloff = OneOverRangeSq > 0 ? fade * fade / distanceSq : 1;
            return Color * (falloff * cone * cone * PointLighting.Facing(normal, to));
        }
    }

    // Where a picture's pixels are in the world, as seen from its eye, by their depth along the view.
    internal struct PixelPositions
    {
        // Of the first pixel's middle; from one column, and row, to the next; of a unit of depth: at a depth of one
        // (perspective), or at any (orthographic).
        public float3 First;
        public float3 StepX;
        public float3 StepY;
        public float3 Forward;
        public bool IsOrthographic;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly float3 Of(int x, int y, float depth)
        {
            var across = First + StepX * x + StepY * y;
            return IsOrthographic ? across + Forward * depth : (across + Forward) * depth;
        }
    }
}
