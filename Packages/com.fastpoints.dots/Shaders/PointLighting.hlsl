// Light on points: the twin of FastPoints.Drawing.PointLighting. Where FASTPOINTS_LIT is defined, by the normal that the depths
// around a pixel show: the twin of PixelPositions and FastPoints.Picture.DepthNormals.
#ifndef FASTPOINTS_POINT_LIGHT_INCLUDED
#define FASTPOINTS_POINT_LIGHT_INCLUDED

#include "PointValues.hlsl"

// PointLighting.ShareWithoutNormal.
#define FASTPOINTS_LIGHT_WITHOUT_NORMAL 0.5

// Rows: AmbientX, AmbientY, AmbientZ, AmbientAll of PointLighting.
float4x4 _FastPointsAmbient;

// Towards the main light; linear.
float3 _FastPointsLightDirection;
float3 _FastPointsLightColor;

// Rows: a light each, see AdditionalLight. Place, ConeOffset; Color, OneOverRangeSq; AxisToLight, ConeScale.
float4x4 _FastPointsAdditionalPlaces;
float4x4 _FastPointsAdditionalColors;
float4x4 _FastPointsAdditionalAxes;
int _FastPointsAdditionalCount;

#if defined(FASTPOINTS_SHADOWED)
// ShadowMapProjection.EdgePx; MainLightShadow.BiasTexels, SlopeTexels; 4 * WholeShare.
#define FASTPOINTS_SHADOW_EDGE 1024
#define FASTPOINTS_SHADOW_BIAS 1.0
#define FASTPOINTS_SHADOW_SLOPE 2.0
#define FASTPOINTS_SHADOW_WHOLE 2.0

// What RasterPoints.hlsl made, seen by the light: depths and no colours.
ByteAddressBuffer _FastPointsShadowPixels;

// Rows: Column, Row, Forward of MainLightShadow, each with its part of Eye; the length of a texel.
float4x4 _FastPointsShadow;

// FastPoints.Picture.ShadowMap.At.
float FastPointsShadow(float3 place, float facing)
{
    float4 from = float4(place, 1.0);
    float column = dot(_FastPointsShadow[0], from), row = dot(_FastPointsShadow[1], from);
    float slope = sqrt(max(0.0, 1.0 - facing * facing)) / facing;
    float depth = dot(_FastPointsShadow[2], from)
        - _FastPointsShadow[3].x * (FASTPOINTS_SHADOW_BIAS + FASTPOINTS_SHADOW_SLOPE * slope);
    uint bits = asuint(depth);
    uint nearest = bits & 0x80000000u ? ~bits : bits | 0x80000000u;
    float most = float(FASTPOINTS_SHADOW_EDGE - 1), shaded = 0.0;
    if (column >= 1.0 && row >= 1.0 && column <= most && row <= most)
    {
        int2 first = int2(int(column - 1.0), int(row - 1.0));
        float2 part = float2(column - 1.0, row - 1.0) - float2(first);
        float3 across = float3(1.0 - part.x, 1.0, part.x), down = float3(1.0 - part.y, 1.0, part.y);
        for (int y = 0; y < 3; y++)
        {
            for (int x = 0; x < 3; x++)
            {
                int2 at = min(first + int2(x, y), FASTPOINTS_SHADOW_EDGE - 1);
                if (_FastPointsShadowPixels.Load(uint(at.y * FASTPOINTS_SHADOW_EDGE + at.x) * 8u) < nearest)
                    shaded += across[x] * down[y];
            }
        }
    }
    return 1.0 - saturate(shaded / FASTPOINTS_SHADOW_WHOLE);
}
#endif

#if defined(FASTPOINTS_LIT)
// Rows: First, StepX, StepY, Forward of PixelPositions.
float4x4 _FastPointsPixelPositions;

float3 FastPointsPlaceOf(int2 pixel, float depth)
{
    float3 across = _FastPointsPixelPositions[0].xyz + _FastPointsPixelPositions[1].xyz * float(pixel.x)
        + _FastPointsPixelPositions[2].xyz * float(pixel.y);
    float3 forward = _FastPointsPixelPositions[3].xyz;
    return _FastPointsScalePx.y != 0.0 ? across + forward * depth : (across + forward) * depth;
}

float3 FastPointsAlong(int2 pixel, int2 way, float depth, float3 place)
{
    float3 sum = float3(0.0, 0.0, 0.0);
    float3 column = _FastPointsPixelPositions[1].xyz;
    float edge = float(max(way.x, way.y)) * (_FastPointsScalePx.y != 0.0 ? 1.0 : depth);
    float edgeSq = dot(column, column) * edge * edge;
    for (int side = 1; side >= -1; side -= 2)
    {
        int2 beside = pixel + way * side;
        if (beside.x < 0 || beside.y < 0 || beside.x >= int(_FastPointsScreenPx.x) || beside.y >= int(_FastPointsScreenPx.y))
            continue;
        if (FastPointsColorAt(beside).w == 0.0)
            continue;
        float there = FastPointsDepthAt(beside).x;
        float between = there - depth;
        sum += (FastPointsPlaceOf(beside, there) - place) * (float(side) / (edgeSq + between * between));
    }
    return sum * edgeSq;
}

// Faces the viewer; 0 where no neighbours show it.
float3 FastPointsNormalAt(int2 pixel, float depth, int radius)
{
    float3 place = FastPointsPlaceOf(pixel, depth);
    float3 across = FastPointsAlong(pixel, int2(radius, 0), depth, place);
    float3 normal = cross(across, FastPointsAlong(pixel, int2(0, radius), depth, place));
    float lengthSq = dot(normal, normal);
    normal = lengthSq > 0.0 ? normal * rsqrt(lengthSq) : float3(0.0, 0.0, 0.0);
    return dot(normal, _FastPointsScalePx.y != 0.0 ? _FastPointsPixelPositions[3].xyz : place) > 0.0 ? -normal : normal;
}
#endif

float FastPointsFacing(float3 normal, float3 direction)
{
    return dot(normal, normal) > 0.0 ? max(0.0, dot(normal, direction)) : FASTPOINTS_LIGHT_WITHOUT_NORMAL;
}

// AdditionalLight.On.
float3 FastPointsAdditionalLightOn(float4 additional, float4 color, float4 axis, float3 normal, float3 place)
{
    float3 to = color.w > 0.0 ? additional.xyz - place : additional.xyz;
    float distanceSq = max(6.1e-5, dot(to, to));
    to *= rsqrt(distanceSq);
    float fade = saturate(1.0 - distanceSq * color.w * distanceSq * color.w);
    float cone = saturate(dot(axis.xyz, to) * axis.w + additional.w);
    float falloff = color.w > 0.0 ? fade * fade / distanceSq : 1.0;
    return color.xyz * (falloff * cone * cone * FastPointsFacing(normal, to));
}

float3 FastPointsLightOn(float3 normal, float3 place)
{
    float3 ambient = _FastPointsAmbient[3].xyz + _FastPointsAmbient[0].xyz * normal.x + _FastPointsAmbient[1].xyz * normal.y
        + _FastPointsAmbient[2].xyz * normal.z;
    float facing = FastPointsFacing(normal, _FastPointsLightDirection);
    float3 light = max(float3(0.0, 0.0, 0.0), ambient);
    if (facing > 0.0)
    {
#if defined(FASTPOINTS_SHADOWED)
        facing *= FastPointsShadow(place, facing);
#endif
        light += _FastPointsLightColor * facing;
    }
    // By numbers: WebGPU's compilers take no others for a matrix.
    float4x4 places = _FastPointsAdditionalPlaces, colors = _FastPointsAdditionalColors, axes = _FastPointsAdditionalAxes;
    if (_FastPointsAdditionalCount > 0)
        light += FastPointsAdditionalLightOn(places[0], colors[0], axes[0], normal, place)
            + FastPointsAdditionalLightOn(places[1], colors[1], axes[1], normal, place)
            + FastPointsAdditionalLightOn(places[2], colors[2], axes[2], normal, place)
            + FastPointsAdditionalLightOn(places[3], colors[3], axes[3], normal, place);
    return light;
}

// From sRGB to sRGB.
float3 FastPointsLit(float3 color, float share, float3 normal, float3 place)
{
    float3 lit = FastPointsLinearFromSrgb(color) * (1.0 - share + share * FastPointsLightOn(normal, place));
    return saturate(FastPointsSrgbFromLinear(lit));
}

#endif
