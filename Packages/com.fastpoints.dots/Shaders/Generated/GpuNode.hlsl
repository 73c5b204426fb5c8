// Written by RepoTools hlsl from FastPoints.Gpu.GpuNode: 96 bytes.
#ifndef FASTPOINTS_GPU_NODE_INCLUDED
#define FASTPOINTS_GPU_NODE_INCLUDED

struct GpuNode
{
    uint3 Anchor;        // 0, 12
    uint PositionWord;   // 12, 4
    uint3 AnchorHigh;    // 16, 12
    uint ColorWord;      // 28, 4
    float3 AnchorView;   // 32, 12
    float AnchorValue;   // 44, 4
    uint FirstInstance;  // 48, 4
    uint Cloud;          // 52, 4
    uint IsWide;         // 56, 4
    uint Tint;           // 60, 4
    float3 AnchorInCube; // 64, 12
    uint SizeNode;       // 76, 4
    float3 CubesPerStep; // 80, 12
    uint ClassWord;      // 92, 4
};

#endif
