// Light on points: the twin of FastPoints.Drawing.PointLight. Where FASTPOINTS_LIT is defined, by the normal that the depths
// around a pixel show: the twin of PixelPlaces and FastPoints.Picture.DepthNormals.
#ifndef FASTPOINTS_POINT_LIGHT_INCLUDED
#define FASTPOINTS_POINT_LIGHT_INCLUDED

#include "PointValues.hlsl"

// PointLight.ShareWithoutNormal.
#define FASTPOINTS_LIGHT_WITHOUT_NORMAL 0.5

// Rows: AmbientX, AmbientY, AmbientZ, AmbientAll of PointLight.
float4x4 _FastPointsAmbient;

// Towards the main light; linear.
float3 _FastPointsLightDirection;
float3 _FastPointsLightColor;

#if defined(FASTPOINTS_LIT)
// Rows: First, StepX, StepY, Forward of PixelPlaces.
float4x4 _FastPointsPlaces;

float3 FastPointsPlaceOf(int2 pixel, float depth)
{
    float3 across = _FastPointsPlaces[0].xyz + _FastPointsPlaces[1].xyz * float(pixel.x)
        + _FastPointsPlaces[2].xyz * float(pixel.y);
    float3 forward = _FastPointsPlaces[3].xyz;
    return _FastPointsScalePx.y != 0.0 ? across + forward * depth : (across + forward) * depth;
}

float3 FastPointsAlong(int2 pixel, int2 way, float depth, float3 place)
{
    float3 sum = float3(0.0, 0.0, 0.0);
    float3 column = _FastPointsPlaces[1].xyz;
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
    return dot(normal, _FastPointsScalePx.y != 0.0 ? _FastPointsPlaces[3].xyz : place) > 0.0 ? -normal : normal;
}
#endif

float3 FastPointsLightOn(float3 normal)
{
    float3 ambient = _FastPointsAmbient[3].xyz + _FastPointsAmbient[0].xyz * normal.x + _FastPointsAmbient[1].xyz * normal.y
        + _FastPointsAmbient[2].xyz * normal.z;
    float main = dot(normal, normal) > 0.0 ? max(0.0, dot(normal, _FastPointsLightDirection)) : FASTPOINTS_LIGHT_WITHOUT_NORMAL;
    return max(float3(0.0, 0.0, 0.0), ambient) + _FastPointsLightColor * main;
}

// From sRGB to sRGB.
float3 FastPointsLit(float3 color, float share, float3 normal)
{
    float3 lit = FastPointsLinearFromSrgb(color) * (1.0 - share + share * FastPointsLightOn(normal));
    return saturate(FastPointsSrgbFromLinear(lit));
}

#endif
