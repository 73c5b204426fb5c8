// Written by RepoTools hlsl from FastPoints.Drawing.GpuCloud: 160 bytes.
#ifndef FASTPOINTS_GPU_CLOUD_INCLUDED
#define FASTPOINTS_GPU_CLOUD_INCLUDED

#include "../PointLists.hlsl"

struct GpuCloud
{
    float3 StepX;        // 0, 12
    uint ColorSource;    // 12, 4
    float3 StepY;        // 16, 12
    uint ColumnTypes;    // 28, 4
    float3 StepZ;        // 32, 12
    uint Columns;        // 44, 4
    float3 ValuePerStep; // 48, 12
    float Bias;          // 60, 4
    float3 Scale;        // 64, 12
    uint ClassDivisor;   // 76, 4
    uint4 HiddenLow;     // 80, 16
    uint4 HiddenHigh;    // 96, 16
    float4 NormalX;      // 112, 16
    float4 NormalY;      // 128, 16
    float4 NormalZ;      // 144, 16
};

// at: where it begins in the lists, in bytes.
GpuCloud FastPointsGpuCloudAt(uint at)
{
    GpuCloud loaded;
    loaded.StepX = asfloat(_FastPointsLists.Load3(at + 0u));
    loaded.ColorSource = _FastPointsLists.Load(at + 12u);
    loaded.StepY = asfloat(_FastPointsLists.Load3(at + 16u));
    loaded.ColumnTypes = _FastPointsLists.Load(at + 28u);
    loaded.StepZ = asfloat(_FastPointsLists.Load3(at + 32u));
    loaded.Columns = _FastPointsLists.Load(at + 44u);
    loaded.ValuePerStep = asfloat(_FastPointsLists.Load3(at + 48u));
    loaded.Bias = asfloat(_FastPointsLists.Load(at + 60u));
    loaded.Scale = asfloat(_FastPointsLists.Load3(at + 64u));
    loaded.ClassDivisor = _FastPointsLists.Load(at + 76u);
    loaded.HiddenLow = _FastPointsLists.Load4(at + 80u);
    loaded.HiddenHigh = _FastPointsLists.Load4(at + 96u);
    loaded.NormalX = asfloat(_FastPointsLists.Load4(at + 112u));
    loaded.NormalY = asfloat(_FastPointsLists.Load4(at + 128u));
    loaded.NormalZ = asfloat(_FastPointsLists.Load4(at + 144u));
    return loaded;
}

#endif
