// From a layer of points (FASTPOINTS_LAYERED in PointPass.hlsl) to the camera's picture: eye-dome lighting as in
// FastPoints.Picture.ResolvePictureJob, and depth against what else the picture has.
#ifndef FASTPOINTS_COMPOSE_PASS_INCLUDED
#define FASTPOINTS_COMPOSE_PASS_INCLUDED

#include "PointValues.hlsl"

// ResolvePictureJob.MaxDifferencePx.
#define FASTPOINTS_MOST_BEFORE_PX 12.0

// Width and height of the layer in pixels.
float2 _FastPointsScreenPx;

#if defined(FASTPOINTS_FROM_PIXELS)
// What RasterPoints.hlsl made.
ByteAddressBuffer _FastPointsPixels;

// The device's depth is (x * depth + y) / (z * depth + w).
float4 _FastPointsDepthToDevice;

uint2 FastPointsPixelAt(int2 pixel)
{
    return _FastPointsPixels.Load2((uint(pixel.y) * uint(_FastPointsScreenPx.x) + uint(pixel.x)) * 8u);
}

float4 FastPointsColorAt(int2 pixel)
{
    uint2 found = FastPointsPixelAt(pixel);
    float style = float(found.y >> 24 | 1u) / 255.0;
    return found.x == 0xFFFFFFFFu ? float4(0.0, 0.0, 0.0, 0.0) : float4(FastPointsUnpackColor(found.y), style);
}

float2 FastPointsDepthAt(int2 pixel)
{
    uint bits = FastPointsPixelAt(pixel).x;
    float depth = asfloat(bits & 0x80000000u ? bits & 0x7FFFFFFFu : ~bits);
    float4 device = _FastPointsDepthToDevice;
    return float2(depth, (device.x * depth + device.y) / (device.z * depth + device.w));
}
#else
Texture2D<float4> _FastPointsLayerColor;
Texture2D<float2> _FastPointsLayerDepth;

#if defined(FASTPOINTS_BLENDED)
Texture2D<float4> _FastPointsLayerSums;
#endif

// sRGB; alpha: 255ths, of which the lower five bits are the point's radius and the others its lit share in sevenths; 0 where
// there is none.
float4 FastPointsColorAt(int2 pixel)
{
    float4 color = _FastPointsLayerColor.Load(int3(pixel, 0));
#if defined(FASTPOINTS_BLENDED)
    float4 sums = _FastPointsLayerSums.Load(int3(pixel, 0));
    // Of halves, sums may be beyond their range.
    if (sums.w > 0.0 && sums.w < 60000.0 && max(sums.x, max(sums.y, sums.z)) < 60000.0)
        color.xyz = floor(sums.xyz / sums.w + 0.5) / 255.0;
#endif
    return color;
}

// Depth in world units along the view's direction, and the device's.
float2 FastPointsDepthAt(int2 pixel)
{
    return _FastPointsLayerDepth.Load(int3(pixel, 0));
}
#endif

int FastPointsRadiusOf(float4 color)
{
    return int(color.w * 255.0 + 0.5) & 31;
}

int FastPointsLitLevelOf(float4 color)
{
    return int(color.w * 255.0 + 0.5) >> 5;
}

// 0: none.
float _FastPointsEdlStrength;

// 1: a pixel without a point gets the mean of those around it, where most of these have one.
uint _FastPointsFillsHoles;

// x: pixels of a world unit at a depth of one; at any depth where y is 1 (orthographic).
float2 _FastPointsScalePx;

// 1: colours are written as light, not as sRGB.
uint _FastPointsIsLinear;

#if defined(FASTPOINTS_SHADOWED)
#define FASTPOINTS_LIT
#endif

#if defined(FASTPOINTS_LIT)
#include "PointLighting.hlsl"
#endif

struct FastPointsComposed
{
    float4 Color : SV_Target;
    float Depth : SV_Depth;
};

struct FastPointsPlace
{
    float4 PositionClip : SV_POSITION;

    // In the layer, from 0 to 1, row by row as it lies there: the picture may be any part of its target.
    float2 InLayer : TEXCOORD0;
};

// A triangle that covers the picture.
FastPointsPlace FastPointsComposeVertex(uint vertex : SV_VertexID)
{
    FastPointsPlace place;
    place.PositionClip = float4(vertex == 1u ? 3.0 : -1.0, vertex == 2u ? 3.0 : -1.0, 0.5, 1.0);
    place.InLayer = 0.5 + 0.5 * place.PositionClip.xy * float2(1.0, _FastPointsFlip.x * FastPointsFlip());
    return place;
}

// How far the eight pixels around lie before this one, in pixels.
float FastPointsBeforePx(int2 pixel, float depth, int radius)
{
    float pixelsPerUnit = _FastPointsScalePx.x / (_FastPointsScalePx.y != 0.0 ? 1.0 : depth) / float(radius);
    float before = 0.0;
    for (int y = -1; y <= 1; y++)
    {
        for (int x = -1; x <= 1; x++)
        {
            int2 beside = pixel + int2(x, y) * radius;
            if (beside.x < 0 || beside.y < 0 || beside.x >= int(_FastPointsScreenPx.x) || beside.y >= int(_FastPointsScreenPx.y))
                continue;
            if (FastPointsColorAt(beside).w == 0.0)
                continue;
            float between = depth - FastPointsDepthAt(beside).x;
            before += clamp(between * pixelsPerUnit, 0.0, FASTPOINTS_MOST_BEFORE_PX);
        }
    }
    return before;
}

// ResolvePictureJob.MinAroundHole.
#define FASTPOINTS_LEAST_AROUND_HOLE 6.0

// The mean of the points around a pixel, as a point of one pixel; alpha is 0 where there are too few.
void FastPointsFill(int2 pixel, out float4 color, out float2 depth)
{
    float count = 0.0, litLevel = 0.0;
    color = float4(0.0, 0.0, 0.0, 0.0);
    depth = float2(0.0, 0.0);
    for (int y = -1; y <= 1; y++)
    {
        for (int x = -1; x <= 1; x++)
        {
            int2 beside = pixel + int2(x, y);
            if (beside.x < 0 || beside.y < 0 || beside.x >= int(_FastPointsScreenPx.x) || beside.y >= int(_FastPointsScreenPx.y))
                continue;
            float4 there = FastPointsColorAt(beside);
            if (there.w == 0.0)
                continue;
            count += 1.0;
            litLevel += float(FastPointsLitLevelOf(there));
            color.xyz += floor(there.xyz * 255.0 + 0.5);
            depth += FastPointsDepthAt(beside);
        }
    }
    if (count < FASTPOINTS_LEAST_AROUND_HOLE)
        return;
    // In whole 255ths, as colours are.
    litLevel = floor((litLevel + floor(count * 0.5)) / count);
    color = float4(floor((color.xyz + floor(count * 0.5)) / count), 1.0 + 32.0 * litLevel) / 255.0;
    depth /= count;
}

FastPointsComposed FastPointsComposeFragment(FastPointsPlace place)
{
    int2 pixel = int2(place.InLayer * _FastPointsScreenPx);
    float4 color = FastPointsColorAt(pixel);
    float2 depth = FastPointsDepthAt(pixel);
    if (color.w == 0.0 && _FastPointsFillsHoles != 0u)
        FastPointsFill(pixel, color, depth);
    if (color.w == 0.0)
        discard;
    int radius = FastPointsRadiusOf(color);
    float before = FastPointsBeforePx(pixel, depth.x, radius);
#if defined(FASTPOINTS_LIT)
    int litLevel = FastPointsLitLevelOf(color);
    if (litLevel != 0)
        color.xyz = FastPointsLit(color.xyz, float(litLevel) / 7.0, FastPointsNormalAt(pixel, depth.x, radius),
            FastPointsPlaceOf(pixel, depth.x));
#endif
    color.xyz *= exp(-_FastPointsEdlStrength * before / 8.0);
    FastPointsComposed composed;
    composed.Color = float4(_FastPointsIsLinear != 0u ? FastPointsLinearFromSrgb(color.xyz) : color.xyz, 1.0);
    composed.Depth = depth.y;
    return composed;
}

#endif
