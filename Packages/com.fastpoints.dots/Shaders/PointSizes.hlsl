// How large a point is: see FastPoints.Drawing.PointSize and SizeTree, of which these are the twins.
#ifndef FASTPOINTS_POINT_SIZES_INCLUDED
#define FASTPOINTS_POINT_SIZES_INCLUDED

#include "Generated/GpuSizeNode.hlsl"

// SizeTree.MaxLevels.
#define FASTPOINTS_MOST_LEVELS 22

// x: pixels of all points alike; y: pixels at a depth of one, of a gap of one where sizes are adaptive, and the same at any
// depth where z is 1 (orthographic).
float4 _FastPointsSize;

// No point is smaller or larger, in pixels.
float2 _FastPointsSizeLimitsPx;

#if defined(FASTPOINTS_ADAPTIVE)
GpuSizeNode FastPointsSizeNode(uint number)
{
    return FastPointsGpuSizeNodeAt(_FastPointsSizeNodesAt + number * 8u);
}

// The distance between points at a place.
// place: of the point in its node's cube, from 0 to 1.
float FastPointsGapAt(uint node, float3 place)
{
    GpuSizeNode at = FastPointsSizeNode(node);
    for (int level = 0; level < FASTPOINTS_MOST_LEVELS; level++)
    {
        place *= 2.0;
        float3 upper = float3(place.x >= 1.0 ? 1.0 : 0.0, place.y >= 1.0 ? 1.0 : 0.0, place.z >= 1.0 ? 1.0 : 0.0);
        place -= upper;
        uint octant = uint(upper.x + 2.0 * upper.y + 4.0 * upper.z);
        if ((at.Children >> octant & 1u) == 0u)
            break;
        at = FastPointsSizeNode((at.Children >> 8) + countbits(at.Children & ((1u << octant) - 1u)));
    }
    return at.Gap;
}
#endif

// depth: along the view's direction, in world units.
float FastPointsSizePx(float gap, float depth)
{
    float unitDepth = _FastPointsSize.z != 0.0 ? 1.0 : depth;
    return clamp(_FastPointsSize.x + _FastPointsSize.y * gap / unitDepth, _FastPointsSizeLimitsPx.x, _FastPointsSizeLimitsPx.y);
}

#endif
