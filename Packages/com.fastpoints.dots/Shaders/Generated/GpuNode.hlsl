// Written by RepoTools hlsl from FastPoints.Drawing.GpuNode: 96 bytes.
#ifndef FASTPOINTS_GPU_NODE_INCLUDED
#define FASTPOINTS_GPU_NODE_INCLUDED

#include "../PointLists.hlsl"

struct GpuNode
{
    uint3 Anchor;        // 0, 12
    uint PositionWord;   // 12, 4
    uint3 AnchorHigh;    // 16, 12
    uint ColorWord;      // 28, 4
    float3 AnchorView;   // 32, 12
    uint NormalWord;     // 44, 4
    uint FirstInstance;  // 48, 4
    uint Cloud;          // 52, 4
    uint Bits;           // 56, 4
    uint Tint;           // 60, 4
    float3 AnchorInCube; // 64, 12
    uint SizeNode;       // 76, 4
    float3 CubesPerStep; // 80, 12
    uint ClassWord;      // 92, 4
};

// at: where it begins in the lists, in bytes.
GpuNode FastPointsGpuNodeAt(uint at)
{
    GpuNode loaded;
    loaded.Anchor = _FastPointsLists.Load3(at + 0u);
    loaded.PositionWord = _FastPointsLists.Load(at + 12u);
    loaded.AnchorHigh = _FastPointsLists.Load3(at + 16u);
    loaded.ColorWord = _FastPointsLists.Load(at + 28u);
    loaded.AnchorView = asfloat(_FastPointsLists.Load3(at + 32u));
    loaded.NormalWord = _FastPointsLists.Load(at + 44u);
    loaded.FirstInstance = _FastPointsLists.Load(at + 48u);
    loaded.Cloud = _FastPointsLists.Load(at + 52u);
    loaded.Bits = _FastPointsLists.Load(at + 56u);
    loaded.Tint = _FastPointsLists.Load(at + 60u);
    loaded.AnchorInCube = asfloat(_FastPointsLists.Load3(at + 64u));
    loaded.SizeNode = _FastPointsLists.Load(at + 76u);
    loaded.CubesPerStep = asfloat(_FastPointsLists.Load3(at + 80u));
    loaded.ClassWord = _FastPointsLists.Load(at + 92u);
    return loaded;
}

#endif
