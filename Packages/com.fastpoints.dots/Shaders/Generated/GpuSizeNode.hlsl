// Written by RepoTools hlsl from FastPoints.Drawing.GpuSizeNode: 8 bytes.
#ifndef FASTPOINTS_GPU_SIZE_NODE_INCLUDED
#define FASTPOINTS_GPU_SIZE_NODE_INCLUDED

#include "../PointLists.hlsl"

struct GpuSizeNode
{
    uint Children; // 0, 4
    float Gap;     // 4, 4
};

// at: where it begins in the lists, in bytes.
GpuSizeNode FastPointsGpuSizeNodeAt(uint at)
{
    GpuSizeNode loaded;
    loaded.Children = _FastPointsLists.Load(at + 0u);
    loaded.Gap = asfloat(_FastPointsLists.Load(at + 4u));
    return loaded;
}

#endif
