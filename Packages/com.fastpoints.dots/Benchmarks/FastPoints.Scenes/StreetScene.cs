using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Scenes
{
    /// <summary>The scene before the scanner: a street of houses with trees, lamps and parked cars, and open land behind them.
    /// All of it follows from the seed.</summary>
    internal sealed class StreetScene : IDisposable
    {
        public const float HalfLength = 130; // Half the length of the street, metres.

        /// <summary>Positions of the scanner in the order of the scan: on the street, 1.8 m over the ground.</summary>
        public static readonly float3[] Stations =
        {
            new float3(-52, 1.2f, 1.8f), new float3(3, -1.5f, 1.8f), new float3(58, 0.8f, 1.8f),
        };

        static readonly float3[] s_wallColors =
        {
            new float3(0.62f, 0.56f, 0.42f), new float3(0.45f, 0.17f, 0.11f), new float3(0.66f, 0.63f, 0.58f),
            new float3(0.52f, 0.23f, 0.14f), new float3(0.60f, 0.42f, 0.25f), new float3(0.42f, 0.47f, 0.50f),
        };

        static readonly float3[] s_carColors =
        {
            new float3(0.45f, 0.03f, 0.03f), new float3(0.60f, 0.60f, 0.62f), new float3(0.03f, 0.05f, 0.18f),
            new float3(0.04f, 0.04f, 0.045f), new float3(0.75f, 0.75f, 0.73f), new float3(0.05f, 0.16f, 0.09f),
        };

        readonly List<SceneObject> m_objects = new List<SceneObject>();
        uint m_random;

        public StreetScene(uint seed, Allocator allocator)
        {
            m_random = SceneHash.Mix(seed ^ 0x51CE5EEDu);
            for (int side = -1; side <= 1; side += 2)
            {
                Houses(side);
                StreetTrees(side);
                Lamps(side);
                Cars(side);
            }
            OpenLand();
            Objects = new NativeArray<SceneObject>(m_objects.ToArray(), allocator);
        }

        public NativeArray<SceneObject> Objects { get; private set; }

        public void Dispose()
        {
            if (Objects.IsCreated)
                Objects.Dispose();
            Objects = default;
        }

        float Between(float low, float high) => low + (high - low) * SceneHash.Next(ref m_random);

        void Add(SceneShape shape, float3 center, float3 half, (float3 Color, byte Class) surface, float heading = 0,
            float slope = 0)
        {
            m_objects.Add(new SceneObject
            {
                Shape = shape,
                Center = center,
                Half = half,
                Heading = new float2(math.cos(heading), math.sin(heading)),
                Color = surface.Color,
                Classification = surface.Class,
                Slope = slope,
                Seed = (uint)(Between(0, 1) * 16777216),
            });
        }

        float3 OnGround(float x, float y) => new float3(x, y, SceneGround.Height(new float2(x, y)));

        void Houses(int side)
        {
            float x = -HalfLength + Between(0, 6);
            while (x < HalfLength - 10)
            {
                var half = new float3(Between(5, 8.5f), Between(4.5f, 6.5f), 3 * (Between(0, 1) < 0.6f ? 2 : 3) + 0.3f);
                float y = side * (SceneGround.PavementHalf + Between(3.5f, 6.5f) + half.y);
                var color = s_wallColors[(int)Between(0, s_wallColors.Length - 0.01f)];
                Add(SceneShape.House, OnGround(x + half.x, y), half, (color, SceneTrace.Building), Between(-0.04f, 0.04f),
                    Between(0.55f, 1));
                for (float bush = 1.5f; bush < 2 * half.x; bush += Between(1.6f, 4))
                    Bush(x + bush, side * (SceneGround.PavementHalf + Between(0.8f, 2.2f)));
                x += 2 * half.x + Between(2.5f, 8);
            }
        }

        void Bush(float x, float y)
        {
            var half = new float3(Between(0.5f, 1), Between(0.4f, 0.6f), Between(0.4f, 0.75f));
            Add(SceneShape.Crown, OnGround(x, y) + new float3(0, 0, half.z * 0.8f), half,
                (new float3(Between(0.05f, 0.10f), Between(0.16f, 0.24f), 0.03f), SceneTrace.LowVegetation), slope: 5);
        }

        void Tree(float x, float y, float size)
        {
            var foot = OnGround(x, y);
            float trunk = Between(2.2f, 3) * size;
            var half = new float3(Between(1.9f, 2.6f), Between(1.9f, 2.6f), Between(2.2f, 3.2f)) * size;
            Add(SceneShape.Pole, foot, new float3(0.11f * size + 0.05f, 0, trunk + half.z),
                (new float3(0.17f, 0.12f, 0.08f), SceneTrace.HighVegetation));
            Add(SceneShape.Crown, foot + new float3(0, 0, trunk + half.z * 0.85f), half,
                (new float3(Between(0.07f, 0.16f), Between(0.20f, 0.30f), Between(0.03f, 0.05f)), SceneTrace.HighVegetation),
                slope: Between(2.2f, 3.4f));
        }

        void StreetTrees(int side)
        {
            for (float x = -HalfLength + Between(2, 9); x < HalfLength; x += Between(11, 19))
                Tree(x, side * (SceneGround.RoadHalf + 1), Between(0.75f, 1.05f));
        }

        void Lamps(int side)
        {
            var steel = (new float3(0.32f, 0.34f, 0.35f), SceneTrace.StreetFurniture);
            for (float x = -HalfLength + (side > 0 ? 8 : 23); x < HalfLength; x += 30)
            {
                var foot = OnGround(x, side * (SceneGround.RoadHalf + 0.5f));
                Add(SceneShape.Pole, foot, new float3(0.07f, 0, 6.6f), steel);
                Add(SceneShape.Box, foot + new float3(0, -side * 0.6f, 6.5f), new float3(0.13f, 0.7f, 0.1f), steel);
            }
        }

        void Cars(int side)
        {
            for (float x = -HalfLength + Between(4, 15); x < HalfLength; x += Between(6, 26))
            {
                float y = side * Between(2.85f, 3);
                var foot = OnGround(x, y);
                float heading = Between(-0.03f, 0.03f);
                var color = s_carColors[(int)Between(0, s_carColors.Length - 0.01f)];
                float scale = Between(0.92f, 1.12f);
                Add(SceneShape.Box, foot + new float3(0, 0, 0.22f), new float3(2.1f, 0.86f, 0.62f) * scale,
                    (color, SceneTrace.Vehicle), heading);
                Add(SceneShape.Box, foot + new float3(0, 0, 0.22f + 0.62f * scale), new float3(1.15f, 0.74f, 0.55f) * scale,
                    (color * 0.25f, SceneTrace.Vehicle), heading);
                for (int wheel = 0; wheel < 4; wheel++)
                {
                    var at = new float3((wheel & 1) == 0 ? 1.35f : -1.35f, (wheel & 2) == 0 ? 0.72f : -0.72f, 0) * scale;
                    Add(SceneShape.Box, foot + at, new float3(0.3f, 0.12f, 0.5f),
                        (new float3(0.03f, 0.03f, 0.03f), SceneTrace.Vehicle), heading);
                }
            }
        }

        void OpenLand()
        {
            for (int i = 0; i < 90; i++)
            {
                float x = Between(-HalfLength, HalfLength);
                float y = Between(29, 110) * (Between(0, 1) < 0.5f ? -1 : 1);
                Tree(x, y, Between(1, 2));
            }
        }
    }
}
