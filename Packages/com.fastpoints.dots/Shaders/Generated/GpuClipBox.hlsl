// Written by RepoTools hlsl from FastPoints.Drawing.GpuClipBox: 64 bytes.
#ifndef FASTPOINTS_GPU_CLIP_BOX_INCLUDED
#define FASTPOINTS_GPU_CLIP_BOX_INCLUDED

#include "../PointLists.hlsl"

struct GpuClipBox
{
    float4 RowX;    // 0, 16
    float4 RowY;    // 16, 16
    float4 RowZ;    // 32, 16
    uint3 Reserved; // 48, 12
    uint Cuts;      // 60, 4
};

// at: where it begins in the lists, in bytes.
GpuClipBox FastPointsGpuClipBoxAt(uint at)
{
    GpuClipBox loaded;
    loaded.RowX = asfloat(_FastPointsLists.Load4(at + 0u));
    loaded.RowY = asfloat(_FastPointsLists.Load4(at + 16u));
    loaded.RowZ = asfloat(_FastPointsLists.Load4(at + 32u));
    loaded.Reserved = _FastPointsLists.Load3(at + 48u);
    loaded.Cuts = _FastPointsLists.Load(at + 60u);
    return loaded;
}

#endif
