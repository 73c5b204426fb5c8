// Vertex and fragment stages that draw points as pixels, squares, discs or paraboloids.
#ifndef FASTPOINTS_POINT_PASS_INCLUDED
#define FASTPOINTS_POINT_PASS_INCLUDED

#include "PointDrawing.hlsl"

#if defined(FASTPOINTS_PROGRESSIVE)
#define FASTPOINTS_LAYERED
#endif

#if defined(FASTPOINTS_PARABOLOIDS) || defined(FASTPOINTS_BLENDING)
#define FASTPOINTS_DISCS

// What the clip space's z and w become with one unit along the view's direction, in x and y;
// z: units of a pixel at a depth of one; w: 1 for OpenGL.
float4 _FastPointsForwardClip;
#endif

#if defined(FASTPOINTS_SQUARES) || defined(FASTPOINTS_DISCS)
#define FASTPOINTS_IS_QUAD
#endif

#if defined(FASTPOINTS_BLENDING)
// BlendedPixels.MaxWeight.
#define FASTPOINTS_LARGEST_WEIGHT 32.0

// Sums are whole numbers of these: 255 times the largest weight is about one, and a power of two loses nothing.
#define FASTPOINTS_SUM_UNIT (1.0 / 8192.0)

// A point as far before its place as others may lie behind it and be blended with it, where it covers the same pixels.
float4 FastPointsMoveNearer(FastPointsPoint drawn)
{
    float distance = _FastPointsSize.z != 0.0 ? 1.0 : drawn.Depth;
    float window = drawn.SizePx * _FastPointsForwardClip.z * distance;
    float4 clip = drawn.PositionClip;
    float w = clip.w - window * _FastPointsForwardClip.y;
    return float4(clip.xy * (w / clip.w), clip.z - window * _FastPointsForwardClip.x, w);
}
#endif

// Width and height of the picture in pixels.
float2 _FastPointsScreenPx;

struct FastPointsVaryings
{
    float4 PositionClip : SV_POSITION;
    nointerpolation float3 Color : TEXCOORD0;
#if defined(FASTPOINTS_DISCS)
    // The disc is where it is no longer than 1.
    float2 Corner : TEXCOORD1;
#endif
#if defined(FASTPOINTS_PARABOLOIDS)
    // The middle's z and w in clip space, the radius in world units.
    nointerpolation float3 Middle : TEXCOORD3;
#endif
#if defined(FASTPOINTS_LAYERED)
    // The radius in whole pixels and the lit share (see ComposePass.hlsl), and the depth in world units.
    nointerpolation float2 RadiusAndDepth : TEXCOORD2;
#endif
#if defined(FASTPOINTS_PROGRESSIVE)
    nointerpolation uint Number : TEXCOORD4;
#endif
#if defined(FASTPOINTS_STEREO)
    uint Slice : SV_RenderTargetArrayIndex;
#endif
#if !defined(FASTPOINTS_IS_QUAD)
    // Some APIs want it where the topology is points; others have no such thing.
    float PointSize : PSIZE;
#endif
};

FastPointsVaryings FastPointsVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    FastPointsVaryings varyings;
#if defined(FASTPOINTS_IS_QUAD)
#if defined(FASTPOINTS_DISCS)
    // One triangle around the disc.
    FastPointsPoint drawn = FastPointsLoadPoint(instance, vertex / 3u);
    uint of = vertex % 3u;
    float2 corner = of == 0u ? float2(0.0, 2.0) : float2(of == 1u ? -1.7320508 : 1.7320508, -1.0);
#else
    // PointMaterials.SquareIndices make two triangles of a square's corners.
    FastPointsPoint drawn = FastPointsLoadPoint(instance, vertex / 4u);
    float2 corner = float2((vertex & 1u) != 0u ? 1.0 : -1.0, (vertex & 2u) != 0u ? 1.0 : -1.0);
#endif
#if defined(FASTPOINTS_BLENDING)
    drawn.PositionClip = FastPointsMoveNearer(drawn);
#endif
    drawn.PositionClip.xy += corner * (drawn.SizePx / _FastPointsScreenPx) * drawn.PositionClip.w;
#else
    FastPointsPoint drawn = FastPointsLoadPoint(instance, vertex);
    varyings.PointSize = 1.0;
#endif
#if defined(FASTPOINTS_PROGRESSIVE)
    varyings.Number = drawn.Number;
    // Of points at one depth, those that are visible stay: a picture at rest does not flicker. Others lie behind by 2^-22.
    drawn.PositionClip.z *= drawn.WasVisible ? 1.0 : 1.0 - 1.0 / 4194304.0;
#endif
#if defined(FASTPOINTS_DISCS)
    varyings.Corner = corner;
#endif
#if defined(FASTPOINTS_PARABOLOIDS)
    varyings.Middle = float3(drawn.PositionClip.zw,
        drawn.SizePx * 0.5 * _FastPointsForwardClip.z * (_FastPointsSize.z != 0.0 ? 1.0 : drawn.Depth));
#endif
#if defined(FASTPOINTS_LAYERED)
    float radius = clamp(floor(drawn.SizePx * 0.5 + 0.5), 1.0, 31.0);
    varyings.RadiusAndDepth = float2(radius + 32.0 * float(drawn.LitLevel), drawn.Depth);
#endif
#if defined(FASTPOINTS_STEREO)
    varyings.Slice = FastPointsEyeOf(instance);
#endif
#if !defined(FASTPOINTS_LAYERED) && !defined(FASTPOINTS_BLENDING)
    drawn.PositionClip.y *= FastPointsFlip();
#endif
    varyings.PositionClip = drawn.PositionClip;
    varyings.Color = drawn.Color;
    return varyings;
}

struct FastPointsTargets
{
    // Where layered, alpha has radius and lit share, 0 where no point is.
    float4 Color : SV_Target0;
#if defined(FASTPOINTS_LAYERED)
    // In world units, and the device's.
    float2 Depth : SV_Target1;
#endif
#if defined(FASTPOINTS_PROGRESSIVE)
    uint Number : SV_Target2;
#endif
#if defined(FASTPOINTS_PARABOLOIDS)
    float DeviceDepth : SV_Depth;
#endif
};

FastPointsTargets FastPointsFragment(FastPointsVaryings varyings)
{
#if defined(FASTPOINTS_DISCS)
    if (dot(varyings.Corner, varyings.Corner) > 1.0)
        discard;
#endif
    FastPointsTargets targets;
    float behind = 0.0;
    float deviceDepth = varyings.PositionClip.z;
#if defined(FASTPOINTS_PARABOLOIDS)
    behind = dot(varyings.Corner, varyings.Corner) * varyings.Middle.z;
    deviceDepth = (varyings.Middle.x + behind * _FastPointsForwardClip.x)
        / (varyings.Middle.y + behind * _FastPointsForwardClip.y);
    // OpenGL's clip space goes from -1 to 1, and what is written from 0 to 1.
    deviceDepth = deviceDepth * (1.0 - 0.5 * _FastPointsForwardClip.w) + 0.5 * _FastPointsForwardClip.w;
    targets.DeviceDepth = deviceDepth;
#endif
    targets.Color = float4(varyings.Color, 1.0);
#if defined(FASTPOINTS_BLENDING)
    // BlendedPixels.WeightOf.
    float weight = max(1.0, floor(FASTPOINTS_LARGEST_WEIGHT * (1.0 - dot(varyings.Corner, varyings.Corner)) + 0.5));
    targets.Color = float4(floor(varyings.Color * 255.0 + 0.5), 1.0) * (weight * FASTPOINTS_SUM_UNIT);
#endif
#if defined(FASTPOINTS_LAYERED)
    targets.Color.w = varyings.RadiusAndDepth.x / 255.0;
    targets.Depth = float2(varyings.RadiusAndDepth.y + behind, deviceDepth);
#endif
#if defined(FASTPOINTS_PROGRESSIVE)
    targets.Number = varyings.Number;
#endif
    return targets;
}

#endif
