using Unity.Mathematics;

namespace FastPoints.Scenes
{
    /// <summary>Finds where rays meet the objects of the scene. Directions have length 1.</summary>
    internal static class SceneTrace
    {
        public const byte Unclassified = 1;
        public const byte Ground = 2;
        public const byte LowVegetation = 3;
        public const byte HighVegetation = 5;
        public const byte Building = 6;
        public const byte RoadSurface = 11;
        public const byte StreetFurniture = 64; // Classes from 64 on are the user's own.
        public const byte Vehicle = 65;

        const float FloorHeight = 3, WindowPitch = 2.6f, WindowHalf = 0.6f, WindowSill = 0.95f, WindowTop = 2.35f;
        const float WindowDepth = 0.18f, EavesOverhang = 0.5f, GableOverhang = 0.35f, WallBelowGround = 1.5f;

        static float3 ToObject(in SceneObject o, float3 v) =>
            new float3(v.x * o.Heading.x + v.y * o.Heading.y, v.y * o.Heading.x - v.x * o.Heading.y, v.z);

        static float3 FromObject(in SceneObject o, float3 v) =>
            new float3(v.x * o.Heading.x - v.y * o.Heading.y, v.x * o.Heading.y + v.y * o.Heading.x, v.z);

        /// <summary>Replaces <paramref name="hit"/> if the object is nearer. Crowns are not solid: see
        /// <see cref="CrownSpan"/>.</summary>
        public static void Solid(in SceneObject o, float3 origin, float3 direction, uint random, ref SceneHit hit)
        {
            var p = ToObject(o, origin - o.Center);
            var d = ToObject(o, direction);
            switch (o.Shape)
            {
                case SceneShape.House:
                    Walls(o, p, d, random, ref hit);
                    Roof(o, p, d, ref hit);
                    break;
                case SceneShape.Pole:
                    Pole(o, p, d, ref hit);
                    break;
                case SceneShape.Box:
                    Box(o, p, d, ref hit);
                    break;
            }
        }

        static void Walls(in SceneObject o, float3 p, float3 d, uint random, ref SceneHit hit)
        {
            for (int axis = 0; axis < 2; axis++)
            {
                float half = o.Half[axis], side = d[axis] > 0 ? -1 : 1;
                float t = (side * half - p[axis]) / d[axis];
                if (!(t > 0 && t < hit.Distance))
                    continue;
                var at = p + d * t;
                float along = axis == 0 ? at.y : at.x, alongHalf = axis == 0 ? o.Half.y : o.Half.x;
                float top = axis == 0 ? o.Half.z + (o.Half.y - math.abs(at.y)) * o.Slope : o.Half.z;
                if (math.abs(along) > alongHalf || at.z > top || at.z < -WallBelowGround)
                    continue;

                var normal = new float3(0, 0, 0);
                normal[axis] = side;
                hit.Distance = t;
                hit.Normal = FromObject(o, normal);
                hit.Classification = Building;
                hit.Reflectance = 0.55f;
                hit.IsLost = false;
                hit.Color = WallColor(o, along, at.z);

                float cells = math.floor(2 * alongHalf / WindowPitch);
                float cell = (along / WindowPitch) + (cells * 0.5f);
                if (at.z < 0 || at.z > o.Half.z - 0.4f || cell < 0 || cell >= cells)
                    continue;
                var fromMiddle = new float2((math.frac(cell) - 0.5f) * WindowPitch, math.frac(at.z / FloorHeight) * FloorHeight);
                bool inWindow = math.abs(fromMiddle.x) < WindowHalf && fromMiddle.y > WindowSill && fromMiddle.y < WindowTop;
                if (inWindow)
                    Window(fromMiddle, axis == 0 ? d.y : d.x, d.z, math.abs(d[axis]), random, ref hit);
            }
        }

        /// <param name="at">Position from the window's middle and the floor below, on the wall's face.</param>
        static void Window(float2 at, float dAlong, float dUp, float dIn, uint random, ref SceneHit hit)
        {
            float into = WindowDepth / dIn;
            var back = at + new float2(dAlong, dUp) * into;
            // The share of the way in at which the pulse meets the reveal, if it does.
            float share = 1;
            if (math.abs(back.x) > WindowHalf)
                share = math.min(share, (math.sign(back.x) * WindowHalf - at.x) / (back.x - at.x));
            if (back.y > WindowTop)
                share = math.min(share, (WindowTop - at.y) / (back.y - at.y));
            if (back.y < WindowSill)
                share = math.min(share, (WindowSill - at.y) / (back.y - at.y));
            hit.Distance += into * share;
            if (share < 1)
            {
                hit.Color = new float3(0.62f, 0.6f, 0.56f);
                return;
            }
            bool frame = WindowHalf - math.abs(back.x) < 0.06f || math.abs(back.x) < 0.03f
                || back.y - WindowSill < 0.06f || WindowTop - back.y < 0.06f;
            if (frame)
            {
                hit.Color = new float3(0.78f, 0.78f, 0.76f);
                return;
            }
            // Glass mostly returns nothing, sometimes the pane, sometimes what stands behind it.
            float roll = SceneHash.Next(ref random);
            hit.IsLost = roll < 0.6f;
            hit.Reflectance = 0.12f;
            hit.Color = new float3(0.05f, 0.075f, 0.1f);
            if (roll > 0.96f)
            {
                hit.Distance += 0.3f + 3 * SceneHash.Next(ref random);
                hit.Color = new float3(0.16f, 0.13f, 0.11f);
                hit.Classification = Unclassified;
            }
        }

        static float3 WallColor(in SceneObject o, float along, float up)
        {
            float stain = SceneHash.Noise(new float2(along * 0.8f, up * 0.4f), o.Seed);
            float shade = 0.82f + 0.25f * stain;
            if (up < 0.45f)
                return o.Color * 0.5f * shade;
            if ((o.Seed & 1) == 0)
                return o.Color * shade;
            // Bricks are 25 by 7.5 cm with their joints.
            float row = up / 0.075f;
            float column = along / 0.25f + (((int)math.floor(row) & 1) == 0 ? 0 : 0.5f);
            bool joint = math.frac(row) < 0.14f || math.frac(column) < 0.05f;
            var cell = new int3((int)math.floor(column), (int)math.floor(row), 0);
            return joint ? o.Color * 0.6f + 0.12f : o.Color * (0.75f + 0.4f * SceneHash.OfCell(cell, o.Seed));
        }

        static void Roof(in SceneObject o, float3 p, float3 d, ref SceneHit hit)
        {
            for (int side = -1; side <= 1; side += 2)
            {
                // z = eaves + (half - |y|) * slope, as a plane each side.
                float t = (o.Half.z + o.Half.y * o.Slope - p.z - side * o.Slope * p.y) / (d.z + side * o.Slope * d.y);
                if (!(t > 0 && t < hit.Distance))
                    continue;
                var at = p + d * t;
                float down = at.y * side;
                if (down < 0 || down > o.Half.y + EavesOverhang || math.abs(at.x) > o.Half.x + GableOverhang)
                    continue;
                float rows = down * math.sqrt(1 + o.Slope * o.Slope) / 0.33f;
                var tile = new int3((int)math.floor(at.x / 0.25f), (int)math.floor(rows), side);
                float shade = 0.7f + 0.35f * SceneHash.OfCell(tile, o.Seed) - (math.frac(rows) < 0.12f ? 0.2f : 0);
                hit.Distance = t;
                hit.Normal = FromObject(o, math.normalize(new float3(0, side * o.Slope, 1)));
                if (d.z + side * o.Slope * d.y > 0)
                    hit.Normal = -hit.Normal;
                hit.Color = ((o.Seed >> 3 & 1) == 0 ? new float3(0.36f, 0.13f, 0.08f) : new float3(0.14f, 0.13f, 0.14f)) * shade;
                hit.Classification = Building;
                hit.Reflectance = 0.4f;
                hit.IsLost = false;
            }
        }

        static void Pole(in SceneObject o, float3 p, float3 d, ref SceneHit hit)
        {
            float a = math.dot(d.xy, d.xy), b = math.dot(p.xy, d.xy), c = math.dot(p.xy, p.xy) - o.Half.x * o.Half.x;
            float disc = b * b - a * c;
            if (!(disc > 0))
                return;
            float t = (-b - math.sqrt(disc)) / a;
            if (!(t > 0 && t < hit.Distance))
                return;
            var at = p + d * t;
            if (at.z < -0.5f || at.z > o.Half.z)
                return;
            float bark = SceneHash.Noise(new float2(math.atan2(at.y, at.x) * 6, at.z * 2), o.Seed);
            hit.Distance = t;
            hit.Normal = FromObject(o, new float3(at.xy / o.Half.x, 0));
            hit.Color = o.Color * (0.7f + 0.6f * bark);
            hit.Classification = o.Classification;
            hit.Reflectance = 0.45f;
            hit.IsLost = false;
        }

        static void Box(in SceneObject o, float3 p, float3 d, ref SceneHit hit)
        {
            var min = new float3(-o.Half.xy, 0);
            var max = o.Half;
            var near = (math.select(max, min, d > 0) - p) / d;
            var far = (math.select(min, max, d > 0) - p) / d;
            float t = math.cmax(near);
            if (!(t > 0 && t < hit.Distance && t < math.cmin(far)))
                return;
            var normal = math.select(new float3(0, 0, 0), -math.sign(d), near >= t);
            hit.Distance = t;
            hit.Normal = FromObject(o, normal);
            hit.Color = o.Color;
            hit.Classification = o.Classification;
            hit.Reflectance = o.Classification == Vehicle ? 0.25f : 0.5f;
            hit.IsLost = false;
        }

        /// <summary>Where the ray is inside a crown's hull; false if it misses.</summary>
        public static bool CrownSpan(in SceneObject o, float3 origin, float3 direction, out float2 span)
        {
            var p = (origin - o.Center) / o.Half;
            var d = direction / o.Half;
            float a = math.dot(d, d), b = math.dot(p, d), c = math.dot(p, p) - 1;
            float disc = b * b - a * c;
            span = default;
            if (!(disc > 0))
                return false;
            float root = math.sqrt(disc);
            span = new float2(math.max(0, (-b - root) / a), (-b + root) / a);
            return span.y > span.x;
        }

        /// <summary>Density of leaves at a position, 0 to 1: clumps of 0.45 m, sparse at the heart, ragged at the hull.</summary>
        public static float LeafDensity(in SceneObject o, float3 at)
        {
            var fromCenter = (at - o.Center) / o.Half;
            float radius = math.length(fromCenter);
            var cell = (int3)math.floor((at - o.Center) / 0.45f);
            float clump = SceneHash.OfCell(cell, o.Seed);
            bool isGap = clump < 0.4f + 0.5f * math.saturate((radius - 0.7f) * 3.5f);
            return isGap ? 0.02f : math.saturate(0.25f + radius * radius) * clump;
        }
    }

    /// <summary>Where a pulse meets a solid surface.</summary>
    internal struct SceneHit
    {
        public float Distance; // Metres along the ray; infinity if it meets nothing.

        public float3 Normal;
        public float3 Color; // Linear colour of the material, unlit.
        public float Reflectance; // Share of the infrared light that is reflected at normal incidence.

        public byte Classification;
        public bool IsLost; // Whether the pulse ends here without a return, mirrored away by glass.

        public static SceneHit None => new SceneHit { Distance = float.PositiveInfinity };
    }
}
