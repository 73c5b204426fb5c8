// Written by RepoTools hlsl from FastPoints.Gpu.GpuCloud: 112 bytes.
#ifndef FASTPOINTS_GPU_CLOUD_INCLUDED
#define FASTPOINTS_GPU_CLOUD_INCLUDED

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
};

#endif
