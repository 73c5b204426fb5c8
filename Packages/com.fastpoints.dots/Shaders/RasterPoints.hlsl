// Draws points of one pixel by atomics (Schuetz, Kerbl, Wimmer, "Rendering Point Clouds with Compute Shaders and Vertex Order
// Optimization", 2021, in two passes of 32 bits): the least depth of each pixel first, then the colour of the points that
// have it. Of two at one depth the smaller colour stays, so that a picture depends on no order.
#ifndef FASTPOINTS_RASTER_POINTS_INCLUDED
#define FASTPOINTS_RASTER_POINTS_INCLUDED

// Without clip boxes, or hidden classes, these cost a comparison.
#define FASTPOINTS_CLIPPED
#define FASTPOINTS_FILTERED

#include "PointDrawing.hlsl"

#define FASTPOINTS_CLEAR_THREADS 64

// FASTPOINTS_POINTS_PER_BLOCK, as a plain number.
#define FASTPOINTS_RASTER_THREADS 128

// A dispatch has no more along an axis.
#define FASTPOINTS_MAX_GROUPS 65535u

// By pixel, row by row from the top: depth, ordered as unsigned numbers, and colour, with the lit share above it.
RWByteAddressBuffer _FastPointsPixelsOut;

// Width and height of the picture in pixels.
float2 _FastPointsScreenPx;

// Blocks of the draw, and in a row of groups.
uint _FastPointsInstanceCount;
uint _FastPointsGroupsPerRow;

struct FastPointsPixel
{
    bool IsSeen;
    uint Pixel;
    uint Depth;
    uint Color;
#if defined(FASTPOINTS_PROGRESSIVE)
    uint Number;
#endif
};

#if defined(FASTPOINTS_PROGRESSIVE)
// Behind all depths and colours: numbers of the points that pixels show.
uint FastPointsNumberAt(uint pixel)
{
    return uint(_FastPointsScreenPx.x) * uint(_FastPointsScreenPx.y) * 8u + pixel * 4u;
}
#endif

FastPointsPixel FastPointsProject(uint3 group, uint index)
{
    FastPointsPixel projected = (FastPointsPixel)0;
    uint instance = group.x + group.y * _FastPointsGroupsPerRow;
    if (instance < _FastPointsInstanceCount)
    {
        FastPointsPoint drawn = FastPointsLoadPoint(instance, index);
        float4 clip = drawn.PositionClip;
        float2 place = float2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * _FastPointsScreenPx;
        projected.IsSeen = clip.w > 0.0 && clip.z >= 0.0 && clip.z <= clip.w && place.x >= 0.0 && place.y >= 0.0 &&
            place.x < _FastPointsScreenPx.x && place.y < _FastPointsScreenPx.y;
        if (projected.IsSeen)
        {
            projected.Pixel = uint(place.y) * uint(_FastPointsScreenPx.x) + uint(place.x);
            uint bits = asuint(drawn.Depth);
            projected.Depth = bits & 0x80000000u ? ~bits : bits | 0x80000000u;
            uint3 bytes = uint3(drawn.Color * 255.0 + 0.5);
            projected.Color = bytes.x | bytes.y << 8 | bytes.z << 16 | drawn.LitLevel << 29;
#if defined(FASTPOINTS_PROGRESSIVE)
            projected.Number = drawn.Number;
#endif
        }
    }
    return projected;
}

[numthreads(FASTPOINTS_CLEAR_THREADS, 1, 1)]
void FastPointsClearPixels(uint3 thread : SV_DispatchThreadID)
{
    uint pixel = thread.y * uint(_FastPointsScreenPx.x) + thread.x;
    if (thread.x < uint(_FastPointsScreenPx.x))
    {
        _FastPointsPixelsOut.Store2(pixel * 8u, uint2(0xFFFFFFFFu, 0xFFFFFFFFu));
#if defined(FASTPOINTS_PROGRESSIVE)
        _FastPointsPixelsOut.Store(FastPointsNumberAt(pixel), 0xFFFFFFFFu);
#endif
    }
}

[numthreads(FASTPOINTS_RASTER_THREADS, 1, 1)]
void FastPointsRasterDepth(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    FastPointsPixel drawn = FastPointsProject(group, thread.x);
    if (drawn.IsSeen)
        _FastPointsPixelsOut.InterlockedMin(drawn.Pixel * 8u, drawn.Depth);
}

[numthreads(FASTPOINTS_RASTER_THREADS, 1, 1)]
void FastPointsRasterColor(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    FastPointsPixel drawn = FastPointsProject(group, thread.x);
    if (drawn.IsSeen && _FastPointsPixelsOut.Load(drawn.Pixel * 8u) == drawn.Depth)
        _FastPointsPixelsOut.InterlockedMin(drawn.Pixel * 8u + 4u, drawn.Color);
}

#endif
