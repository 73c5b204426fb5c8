using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Scenes
{
    /// <summary>Traces scan lines of one station: the mirror sweeps upwards while the head turns, with equal angle steps both
    /// ways, so that the density falls with the square of the distance.</summary>
    [BurstCompile]
    internal struct TraceLinesJob : IJobFor
    {
        public const int MaxReturns = 4;
        public const float LowestElevation = -1.08f;
        public const float HighestElevation = 0.96f;

        const float Reach = 90;
        const double GpsTimeOfStart = 3.2e8, SecondsPerPulse = 2e-6, SecondsPerStation = 600;

        [ReadOnly] public NativeArray<SceneObject> Objects;
        [ReadOnly] public NativeArray<float> TopOfShadow;
        public float3 Station;
        public ushort StationNumber;
        public int FirstLine;
        public int LinesPerTurn;
        public int RaysPerLine;
        public uint Seed;

        /// <summary>Each line's returns start at line * <see cref="RaysPerLine"/> * <see cref="MaxReturns"/>.</summary>
        [NativeDisableParallelForRestriction] public NativeArray<ScanReturn> ReturnsOfLine;

        public NativeArray<int> CountOfLine;

        public unsafe void Execute(int index)
        {
            int line = FirstLine + index;
            // A second turn scans between the lines of the first.
            float turn = (line + line / LinesPerTurn * 0.5f) / LinesPerTurn;
            float azimuth = 2 * math.PI * turn;
            var limit = new float2(math.cos(azimuth), math.sin(azimuth));
            var origin = Station;
            origin.z += SceneGround.Height(Station.xy);

            int* near = stackalloc int[Objects.Length];
            int nearCount = 0;
            for (int i = 0; i < Objects.Length; i++)
            {
                var o = Objects[i];
                var to = o.Center.xy - origin.xy;
                float reach = o.Reach + 0.1f;
                if (math.abs(to.x * limit.y - to.y * limit.x) < reach && math.dot(to, limit) > -reach)
                    near[nearCount++] = i;
            }

            int start = index * RaysPerLine * MaxReturns;
            int end = start;
            for (int ray = 0; ray < RaysPerLine; ray++)
                Pulse(new Beam { Line = line, Ray = ray, Origin = origin }, azimuth, near, nearCount, ref end);
            CountOfLine[index] = end - start;
        }

        unsafe void Pulse(Beam beam, float azimuth, int* near, int nearCount, ref int end)
        {
            beam.Random = SceneHash.Of(Seed + StationNumber, (uint)beam.Line, (uint)beam.Ray);
            float step = (HighestElevation - LowestElevation) / RaysPerLine;
            float elevation = LowestElevation + (beam.Ray + 0.5f + 0.2f * (SceneHash.Next(ref beam.Random) - 0.5f)) * step;
            float heading = azimuth + 0.2f * (SceneHash.Next(ref beam.Random) - 0.5f) * step;
            float3 origin = beam.Origin, direction = new float3(math.cos(heading) * math.cos(elevation),
                math.sin(heading) * math.cos(elevation), math.sin(elevation));
            (beam.Elevation, beam.Direction) = (elevation, direction);

            var hit = SceneHit.None;
            float ground = SceneGround.Hit(origin, direction, Reach);
            if (ground < Reach)
                GroundHit(origin + direction * ground, ground, ref hit);
            for (int i = 0; i < nearCount; i++)
                SceneTrace.Solid(Objects[near[i]], origin, direction, beam.Random, ref hit);

            // Leaves in front of the solid hit, nearest first.
            float* leaf = stackalloc float[MaxReturns];
            int* crown = stackalloc int[MaxReturns];
            int leaves = 0;
            float limit = math.min(hit.Distance, Reach);
            for (int i = 0; i < nearCount; i++)
                if (Objects[near[i]].Shape == SceneShape.Crown)
                    Leaves(near[i], ref beam, limit, leaf, crown, ref leaves);

            // Each leaf takes a part of the pulse, which continues behind the first one with even odds only.
            int returns = leaves;
            for (int i = 0; i < leaves; i++)
                if (SceneHash.Next(ref beam.Random) < 0.5f)
                {
                    returns = i + 1;
                    break;
                }
            bool endsInLeaves = leaves > 0 && (returns < leaves || SceneHash.Next(ref beam.Random) < 0.35f);
            bool hasSolid = !endsInLeaves && hit.Distance < Reach && !hit.IsLost && returns < MaxReturns;
            int all = returns + (hasSolid ? 1 : 0);
            for (int i = 0; i < all; i++)
            {
                var at = i < returns ? LeafHit(Objects[crown[i]], leaf[i], origin + direction * leaf[i], ref beam.Random) : hit;
                ReturnsOfLine[end++] = Return(at, ref beam, i + 1, all);
            }
        }

        struct Beam
        {
            public int Line;
            public int Ray;
            public float3 Origin;
            public float3 Direction;
            public float Elevation;
            public uint Random;
        }

        void GroundHit(float3 at, float distance, ref SceneHit hit)
        {
            bool isRoad = math.abs(at.y) < SceneGround.PavementHalf;
            hit.Distance = distance;
            hit.Normal = SceneGround.Normal(at.xy);
            hit.Color = SceneGround.Color(at.xy, Seed);
            hit.Reflectance = isRoad ? 0.2f : 0.5f;
            hit.Classification = isRoad ? SceneTrace.RoadSurface : SceneTrace.Ground;
        }

        /// <summary>Samples free paths between leaves by delta tracking (Woodcock): steps for the densest place, accepted with
        /// the density at hand.</summary>
        unsafe void Leaves(int index, ref Beam beam, float limit, float* leaf, int* crown, ref int leaves)
        {
            var o = Objects[index];
            if (!SceneTrace.CrownSpan(o, beam.Origin, beam.Direction, out var span))
                return;
            float t = span.x, last = math.min(span.y, limit);
            for (int guard = 0; guard < 64; guard++)
            {
                t -= math.log(1 - SceneHash.Next(ref beam.Random)) / o.Slope;
                if (!(t < last))
                    return;
                if (SceneHash.Next(ref beam.Random) > SceneTrace.LeafDensity(o, beam.Origin + beam.Direction * t))
                    continue;
                int insert = math.min(leaves, MaxReturns - 1);
                if (leaves == MaxReturns && leaf[insert] <= t)
                    return;
                for (; insert > 0 && leaf[insert - 1] > t; insert--)
                {
                    leaf[insert] = leaf[insert - 1];
                    crown[insert] = crown[insert - 1];
                }
                leaf[insert] = t;
                crown[insert] = index;
                leaves = math.min(leaves + 1, MaxReturns);
            }
        }

        static SceneHit LeafHit(in SceneObject o, float distance, float3 at, ref uint random)
        {
            var normal =
                new float3(SceneHash.NextNormal(ref random), SceneHash.NextNormal(ref random), SceneHash.NextNormal(ref random));
            // Leaves look to the light more often than not.
            normal = math.normalize(normal + new float3(0, 0, 0.6f) + 1e-4f);
            float depth = math.length((at - o.Center) / o.Half);
            return new SceneHit
            {
                Distance = distance,
                Normal = normal,
                Color = o.Color * (0.35f + 0.75f * depth) * (0.7f + 0.6f * SceneHash.Next(ref random)),
                Reflectance = 0.48f,
                Classification = o.Classification,
            };
        }

        ScanReturn Return(in SceneHit hit, ref Beam beam, int number, int count)
        {
            float incidence = math.abs(math.dot(hit.Normal, beam.Direction));
            // A slanted or far surface spreads the echo.
            float noise = 0.0015f + 0.00003f * hit.Distance + 0.002f * (1 - incidence);
            float distance = hit.Distance + noise * SceneHash.NextNormal(ref beam.Random);
            var at = beam.Origin + beam.Direction * distance;

            var sun = SunShadow.Sun;
            float light = 0.32f + 0.14f * hit.Normal.z, towards = math.dot(hit.Normal, sun);
            if (towards > 0 && SunShadow.Reaches(TopOfShadow, at + hit.Normal * 0.05f))
                light += 1.05f * towards;
            var tint = math.lerp(new float3(0.86f, 0.95f, 1.12f), new float3(1.05f, 1, 0.9f), math.saturate(light));
            var color = math.saturate(hit.Color * tint * light * (1.35f + 0.05f * SceneHash.NextNormal(ref beam.Random)));
            // The sRGB curve, to 16 bits.
            color = math.select(1.055f * math.pow(color, 1 / 2.4f) - 0.055f, 12.92f * color, color <= 0.0031308f);
            color = math.round(color * 65535);

            float echo = hit.Reflectance * (0.25f + 0.75f * incidence) / (1 + math.lengthsq(distance / 70)) / math.sqrt(count);
            echo *= 1 + 0.06f * SceneHash.NextNormal(ref beam.Random);

            var toGrid = 1 / ScanReturn.Step;
            double pulse = (double)beam.Line * RaysPerLine + beam.Ray;
            return new ScanReturn
            {
                GpsTime = GpsTimeOfStart + (StationNumber - 1) * SecondsPerStation + pulse * SecondsPerPulse,
                X = (int)math.round(at.x * toGrid),
                Y = (int)math.round(at.y * toGrid),
                Z = (int)math.round(at.z * toGrid),
                Intensity = (ushort)(math.saturate(echo) * 65535),
                Red = (ushort)color.x,
                Green = (ushort)color.y,
                Blue = (ushort)color.z,
                ScanAngle = (short)math.round(math.degrees(beam.Elevation) / 0.006f),
                Station = StationNumber,
                ReturnNumber = (byte)number,
                NumberOfReturns = (byte)count,
                Classification = hit.Classification,
            };
        }
    }
}
