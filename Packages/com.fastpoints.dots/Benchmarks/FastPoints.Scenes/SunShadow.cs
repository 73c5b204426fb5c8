using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Scenes
{
    /// <summary>The regions without sunlight: for each cell of the ground plane z = 0, the height at which the ray from the sun
    /// to that cell first met an object. Any point on that ray below this height lies in the shade.</summary>
    internal struct SunShadow
    {
        const float CellSize = 0.25f;
        const int CellsX = 1280, CellsY = 1200;

        public static float3 Sun => math.normalize(new float3(0.45f, -0.62f, 0.8f));

        static float2 Corner => new float2(CellsX, CellsY) * (-0.5f * CellSize);

        public NativeArray<float> TopOfCell;

        public SunShadow(Allocator allocator) => TopOfCell = new NativeArray<float>(CellsX * CellsY, allocator);

        public static bool Reaches(in NativeArray<float> topOfCell, float3 at)
        {
            var cell = (int2)math.floor((OnPlane(at) - Corner) / CellSize);
            if (math.any(cell < 0) || cell.x >= CellsX || cell.y >= CellsY)
                return true;
            return at.z > topOfCell[cell.y * CellsX + cell.x] - 0.3f;
        }

        static float2 OnPlane(float3 at) => at.xy - at.z * Sun.xy / Sun.z;

        [BurstCompile]
        public struct CastShadowsJob : IJob
        {
            [ReadOnly] public NativeArray<SceneObject> Objects;
            public NativeArray<float> TopOfCell;

            public void Execute()
            {
                for (int i = 0; i < TopOfCell.Length; i++)
                    TopOfCell[i] = float.NegativeInfinity;
                for (int i = 0; i < Objects.Length; i++)
                    Cast(Objects[i]);
            }

            void Cast(in SceneObject o)
            {
                var sun = Sun;
                float rise = o.Half.z + (o.Shape == SceneShape.House ? o.Half.y * o.Slope : 0);
                float drop = o.Shape == SceneShape.Crown ? o.Half.z : 1;
                var low = OnPlane(o.Center - new float3(0, 0, drop));
                var high = OnPlane(o.Center + new float3(0, 0, rise));
                var first = math.max(0, (int2)math.floor((math.min(low, high) - o.Reach - Corner) / CellSize));
                var last = (int2)math.floor((math.max(low, high) + o.Reach - Corner) / CellSize);
                last = math.min(new int2(CellsX, CellsY) - 1, last);
                for (int y = first.y; y <= last.y; y++)
                    for (int x = first.x; x <= last.x; x++)
                    {
                        var target = new float3(Corner + (new float2(x, y) + 0.5f) * CellSize, 0);
                        var from = target + sun * 100;
                        float distance;
                        if (o.Shape == SceneShape.Crown)
                        {
                            // Light falls through the gaps between the leaves.
                            if (!SceneTrace.CrownSpan(o, from, -sun, out var span) ||
                                SceneHash.OfCell(new int3(x, y, 7), o.Seed) < 0.22f)
                                continue;
                            distance = (span.x + span.y) * 0.5f;
                        }
                        else
                        {
                            var hit = SceneHit.None;
                            SceneTrace.Solid(o, from, -sun, 1, ref hit);
                            distance = hit.Distance;
                        }
                        if (!math.isfinite(distance))
                            continue;
                        int cell = y * CellsX + x;
                        TopOfCell[cell] = math.max(TopOfCell[cell], from.z - sun.z * distance);
                    }
            }
        }
    }
}
