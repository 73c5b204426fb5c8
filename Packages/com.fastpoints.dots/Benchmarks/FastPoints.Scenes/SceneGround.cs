using Unity.Mathematics;

namespace FastPoints.Scenes
{
    /// <summary>The ground of the scene: a street along x through gentle grassland. Heights are in metres over the scene's
    /// zero.</summary>
    internal static class SceneGround
    {
        public const float RoadHalf = 4; // Half the width of the carriageway, and where the pavement beside it ends.
        public const float PavementHalf = 6.5f;

        const float KerbHeight = 0.12f;

        public static float Height(float2 p)
        {
            float land = 0.9f * math.sin(p.x * 0.021f + 1) * math.cos(p.y * 0.017f) + 0.35f * math.sin(p.x * 0.09f + p.y * 0.07f);
            float aside = math.abs(p.y);
            if (aside < RoadHalf)
                // The road is crowned for rain and follows the land along its middle line only.
                return RoadLevel(p.x) - 0.02f * aside;
            float grass = land + 0.05f * math.sin(p.x * 1.7f) * math.cos(p.y * 2.1f);
            float pavement = RoadLevel(p.x) + KerbHeight;
            return math.lerp(pavement, grass, math.saturate((aside - PavementHalf) / 6));
        }

        static float RoadLevel(float x) => 0.9f * math.sin(x * 0.021f + 1);

        public static float3 Normal(float2 p)
        {
            const float step = 0.05f;
            float dx = Height(p + new float2(step, 0)) - Height(p - new float2(step, 0));
            float dy = Height(p + new float2(0, step)) - Height(p - new float2(0, step));
            return math.normalize(new float3(-dx, -dy, 2 * step));
        }

        /// <summary>Distance along the ray to the ground, or infinity beyond <paramref name="reach"/>.</summary>
        public static float Hit(float3 origin, float3 direction, float reach)
        {
            // The land never rises above 1.5 m nor falls below -1.5: a bracket to bisect by the false position (Illinois).
            float a = 0, b = reach;
            if (direction.z < 0)
                b = math.min(b, (-1.6f - origin.z) / direction.z);
            float fa = origin.z - Height(origin.xy), fb = Above(origin, direction, b);
            if (fb > 0 || fa < 0)
                return float.PositiveInfinity;
            for (int i = 0; i < 12; i++)
            {
                float t = (a * fb - b * fa) / (fb - fa);
                float f = Above(origin, direction, t);
                if (math.abs(f) < 0.0005f)
                    return t;
                if (f < 0)
                {
                    b = t;
                    fb = f;
                    fa *= 0.5f;
                }
                else
                {
                    a = t;
                    fa = f;
                    fb *= 0.5f;
                }
            }
            return (a + b) * 0.5f;
        }

        static float Above(float3 origin, float3 direction, float t)
        {
            var p = origin + direction * t;
            return p.z - Height(p.xy);
        }

        /// <summary>Linear colour, 0 to 1.</summary>
        public static float3 Color(float2 p, uint seed)
        {
            float aside = math.abs(p.y), grain = SceneHash.Noise(p * 9, seed);
            if (aside < RoadHalf)
            {
                // A dashed middle line and two edge lines are worn.
                bool dash = aside < 0.08f && math.frac(p.x / 6) < 0.5f;
                bool edge = math.abs(aside - 3.75f) < 0.06f;
                if ((dash || edge) && grain > 0.25f)
                    return new float3(0.72f, 0.72f, 0.68f);
                float patch = SceneHash.Noise(p * 0.35f, seed + 1);
                return new float3(0.085f, 0.085f, 0.092f) * (0.8f + 0.5f * patch + 0.25f * grain);
            }
            if (aside < PavementHalf)
            {
                var slab = math.frac(p / 0.6f);
                bool joint = math.cmin(slab) < 0.04f;
                return new float3(0.33f, 0.31f, 0.29f) * (joint ? 0.45f : 0.85f + 0.3f * grain);
            }
            float dry = SceneHash.Noise(p * 0.12f, seed + 2);
            var grassColor = math.lerp(new float3(0.055f, 0.13f, 0.025f), new float3(0.19f, 0.19f, 0.06f), dry * dry);
            return grassColor * (0.6f + 0.8f * grain);
        }
    }
}
