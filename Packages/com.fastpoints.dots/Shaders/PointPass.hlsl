// Vertex and fragment stages that draw points as pixels, squares or discs.
#ifndef FASTPOINTS_POINT_PASS_INCLUDED
#define FASTPOINTS_POINT_PASS_INCLUDED

#include "PointDrawing.hlsl"

#if defined(FASTPOINTS_SQUARES) || defined(FASTPOINTS_DISCS)
#define FASTPOINTS_IS_QUAD
#endif

// Width and height of the picture in pixels.
float2 _FastPointsScreenPx;

// Edge of a square, diameter of a disc.
float _FastPointsSizePx;

struct FastPointsVaryings
{
    float4 PositionClip : SV_POSITION;
    nointerpolation float3 Color : TEXCOORD0;
#if defined(FASTPOINTS_DISCS)
    // From -1 to 1 over the square.
    float2 Corner : TEXCOORD1;
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
    FastPointsPoint drawn = FastPointsLoadPoint(instance, vertex / 6u);
    // Two triangles: 0, 1, 2 and 3, 4, 5.
    uint of = vertex % 6u;
    float2 corner = float2(of == 1u || of >= 4u ? 1.0 : -1.0, of == 2u || of == 3u || of == 5u ? 1.0 : -1.0);
    drawn.PositionClip.xy += corner * (_FastPointsSizePx / _FastPointsScreenPx) * drawn.PositionClip.w;
#else
    FastPointsPoint drawn = FastPointsLoadPoint(instance, vertex);
    varyings.PointSize = 1.0;
#endif
#if defined(FASTPOINTS_DISCS)
    varyings.Corner = corner;
#endif
    varyings.PositionClip = drawn.PositionClip;
    varyings.Color = drawn.Color;
    return varyings;
}

float4 FastPointsFragment(FastPointsVaryings varyings) : SV_Target
{
#if defined(FASTPOINTS_DISCS)
    if (dot(varyings.Corner, varyings.Corner) > 1.0)
        discard;
#endif
    return float4(varyings.Color, 1.0);
}

#endif
