// Points of a cloud for shaders of your own, as FastPoints.Rendering.PointCloudBuffers has gathered and bound them: see the
// manual's page "Effects". For compute shaders, procedural draws, and Shader Graph's Custom Function nodes (source: this file,
// name: FastPoints_Load). Nothing of Unity's is used here.
#ifndef FASTPOINTS_POINT_CLOUD_BUFFERS_INCLUDED
#define FASTPOINTS_POINT_CLOUD_BUFFERS_INCLUDED

#include "PointColors.hlsl"

// 16 bytes: along the world's axes, from PointCloudBuffers.OriginWorld; sRGB with red, green, blue from the lowest byte, and an
// alpha of 255, or of 0 where a clip box or a hidden class takes the point away.
struct FastPointsEffectPoint
{
    float3 Position;
    uint Color;
};

StructuredBuffer<FastPointsEffectPoint> _FastPointsEffectPoints;

// PointCloudBuffers.Count.
uint _FastPointsEffectPointCount;

// PointCloudBuffers.OriginWorld; w: 1 where the project's colours are linear.
float4 _FastPointsEffectOrigin;

// The point of a number below PointCloudBuffers.Count.
// position: in the world; HDRP's shaders count from the camera.
// color: in the project's colour space; its alpha is 0 where there is no point.
void FastPoints_Load(uint i, out float3 position, out float4 color)
{
    FastPointsEffectPoint loaded = (FastPointsEffectPoint)0;
    if (i < _FastPointsEffectPointCount)
        loaded = _FastPointsEffectPoints[i];
    position = _FastPointsEffectOrigin.xyz + loaded.Position;
    float3 srgb = FastPointsUnpackColor(loaded.Color);
    color = float4(_FastPointsEffectOrigin.w != 0.0 ? FastPointsLinearFromSrgb(srgb) : srgb, float(loaded.Color >> 24) / 255.0);
}

// What Shader Graph calls: its numbers are floats, which count to 16,777,216.
void FastPoints_Load_float(float I, out float3 Position, out float4 Color)
{
    FastPoints_Load(uint(I + 0.5), Position, Color);
}

#endif
