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

// By pixel, row by row from the top: depth, ordered as unsigned numbers, and colour.
RWByteAddressBuffer _FastPointsPixelsOut;

// Width and height of the picture in pixels.
float2 _FastPointsScreenPx;

// Blocks of the draw, and in a row of groups.
uint _FastPointsInstanceCount;
uint _FastPointsGroupsPerRow;

// Of a point that is drawn: its pixel's place in the buffer, its depth, its colour.
bool FastPointsProject(uint3 group, uint index, out uint address, out uint depth, out uint color)
{
    address = 0u;
    depth = 0u;
    color = 0u;
    bool isSeen = false;
    uint instance = group.x + group.y * _FastPointsGroupsPerRow;
    if (instance < _FastPointsInstanceCount)
    {
        FastPointsPoint drawn = FastPointsLoadPoint(instance, index);
        float4 clip = drawn.PositionClip;
        float2 place = float2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * _FastPointsScreenPx;
        isSeen = clip.w > 0.0 && clip.z >= 0.0 && clip.z <= clip.w && place.x >= 0.0 && place.y >= 0.0 &&
            place.x < _FastPointsScreenPx.x && place.y < _FastPointsScreenPx.y;
        if (isSeen)
        {
            address = (uint(place.y) * uint(_FastPointsScreenPx.x) + uint(place.x)) * 8u;
            uint bits = asuint(drawn.Depth);
            depth = bits & 0x80000000u ? ~bits : bits | 0x80000000u;
            uint3 bytes = uint3(drawn.Color * 255.0 + 0.5);
            color = bytes.x | bytes.y << 8 | bytes.z << 16;
        }
    }
    return isSeen;
}

[numthreads(FASTPOINTS_CLEAR_THREADS, 1, 1)]
void FastPointsClearPixels(uint3 thread : SV_DispatchThreadID)
{
    if (thread.x < uint(_FastPointsScreenPx.x))
        _FastPointsPixelsOut.Store2((thread.y * uint(_FastPointsScreenPx.x) + thread.x) * 8u, uint2(0xFFFFFFFFu, 0xFFFFFFFFu));
}

[numthreads(FASTPOINTS_RASTER_THREADS, 1, 1)]
void FastPointsRasterDepth(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    uint address, depth, color;
    if (FastPointsProject(group, thread.x, address, depth, color))
        _FastPointsPixelsOut.InterlockedMin(address, depth);
}

[numthreads(FASTPOINTS_RASTER_THREADS, 1, 1)]
void FastPointsRasterColor(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    uint address, depth, color;
    if (FastPointsProject(group, thread.x, address, depth, color) && _FastPointsPixelsOut.Load(address) == depth)
        _FastPointsPixelsOut.InterlockedMin(address + 4u, color);
}

#endif
