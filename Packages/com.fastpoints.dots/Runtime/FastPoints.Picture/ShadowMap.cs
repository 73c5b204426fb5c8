using FastPoints.Drawing;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // How much of the main light reaches a place past the points of its depth map. PointLighting.hlsl has its twin.
    internal struct ShadowMap
    {
        // As a picture's, seen by the light; empty where nothing is shaded.
        [ReadOnly] public NativeArray<ulong> Pixels;
        public MainLightShadow Shadow;

        // What draws it, as points of one pixel.
        public static Camera CameraOf(in ShadowMapProjection frame) => new Camera
        {
            EyeGeo = frame.MiddleWorld,
            Right = frame.Right,
            Up = frame.Up,
            Forward = frame.ScaledForward,
            IsOrthographic = true,
            HeightGeo = frame.EdgeWorld,
        };

        // 1 for all. facing: the cosine between the surface and the light, more than 0.
        public readonly float At(float3 place, float facing)
        {
            const int edge = ShadowMapProjection.EdgePx;
            float column = math.dot(Shadow.Column, place) + Shadow.Eye.x, row = math.dot(Shadow.Row, place) + Shadow.Eye.y;
            if (Pixels.Length == 0 || !(column >= 1 && row >= 1 && column <= edge - 1 && row <= edge - 1))
                return 1;
            float slope = math.sqrt(math.max(0, 1 - facing * facing)) / facing;
            uint nearest = PointProjection.DepthToBits(math.dot(Shadow.Forward, place) + Shadow.Eye.z -
                Shadow.TexelWorld * (MainLightShadow.BiasTexels + MainLightShadow.SlopeTexels * slope));
            // A square of two texels' length around it, of which up to nine are a part.
            int left = (int)(column - 1), top = (int)(row - 1);
            float partX = column - 1 - left, partY = row - 1 - top;
            float shaded = 0;
            for (int y = 0; y < 3; y++)
                for (int x = 0; x < 3; x++)
                {
                    int at = math.min(top + y, edge - 1) * edge + math.min(left + x, edge - 1);
                    if ((uint)(Pixels[at] >> 32) < nearest)
                        shaded += WeightOf(x, partX) * WeightOf(y, partY);
                }
            return 1 - math.saturate(shaded / (4 * MainLightShadow.WholeShare));
        }

        static float WeightOf(int texel, float part) => texel == 0 ? 1 - part : texel == 1 ? 1 : part;
    }
}
