// Written by RepoTools hlsl from FastPoints.Gpu.GpuClipBox: 64 bytes.
#ifndef FASTPOINTS_GPU_CLIP_BOX_INCLUDED
#define FASTPOINTS_GPU_CLIP_BOX_INCLUDED

struct GpuClipBox
{
    float4 RowX;    // 0, 16
    float4 RowY;    // 16, 16
    float4 RowZ;    // 32, 16
    uint3 Reserved; // 48, 12
    uint Cuts;      // 60, 4
};

#endif
