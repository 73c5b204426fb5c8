// Written by RepoTools hlsl from FastPoints.Gpu.GpuSizeNode: 8 bytes.
#ifndef FASTPOINTS_GPU_SIZE_NODE_INCLUDED
#define FASTPOINTS_GPU_SIZE_NODE_INCLUDED

struct GpuSizeNode
{
    uint Children; // 0, 4
    float Gap;     // 4, 4
};

#endif
