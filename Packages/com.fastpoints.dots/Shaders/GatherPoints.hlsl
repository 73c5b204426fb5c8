// Unpacks the listed points of a bank into one buffer, or a share of them: a group is a block, a thread a point.
#ifndef FASTPOINTS_GATHER_POINTS_INCLUDED
#define FASTPOINTS_GATHER_POINTS_INCLUDED

// Without clip boxes, or hidden classes, these cost a comparison.
#define FASTPOINTS_CLIPPED
#define FASTPOINTS_FILTERED

#include "PointLoading.hlsl"
#include "PointFilters.hlsl"
#include "PointCloudBuffers.hlsl"

// FASTPOINTS_POINTS_PER_BLOCK, as a plain number.
#define FASTPOINTS_GATHER_THREADS 128

RWStructuredBuffer<FastPointsEffectPoint> _FastPointsEffectPointsOut;

// Of all points, how many are kept, in 2^-32; 0 for all.
uint _FastPointsKeptShare;

// Blocks of the dispatch, and in a row of groups.
uint _FastPointsInstanceCount;
uint _FastPointsGroupsPerRow;

// How many of so many points are kept: the upper half of a product of 64 bits, which shaders lack. Each kept one is where this
// number grows, so that those that are left out lie as evenly among the others as the Morton curve does in space.
uint FastPointsKeptOf(uint points)
{
    uint high = points >> 16, low = points & 0xFFFFu;
    uint shareHigh = _FastPointsKeptShare >> 16, shareLow = _FastPointsKeptShare & 0xFFFFu;
    uint highLow = high * shareLow, lowHigh = low * shareHigh;
    uint carried = (low * shareLow >> 16) + (highLow & 0xFFFFu) + (lowHigh & 0xFFFFu);
    uint kept = high * shareHigh + (highLow >> 16) + (lowHigh >> 16) + (carried >> 16);
    return _FastPointsKeptShare == 0u ? points : kept;
}

// Points of the node before the group's block.
groupshared uint FastPointsBefore;

[numthreads(FASTPOINTS_GATHER_THREADS, 1, 1)]
void FastPointsGatherPoints(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    uint instance = group.x + group.y * _FastPointsGroupsPerRow;
    bool isThere = instance < _FastPointsInstanceCount;
    instance = _FastPointsFirstInstance + (isThere ? instance : 0u);
    uint number = _FastPointsLists.Load(_FastPointsNodeOfInstanceAt + instance * 4u);
    GpuNode node = FastPointsGpuNodeAt(_FastPointsNodesAt + number * 96u);
    uint blockIndex = instance - node.FirstInstance;
    uint descriptorWords = (node.Bits & 1u) != 0u ? 8u : 5u;
    if (thread.x == 0u)
        FastPointsBefore = 0u;
    GroupMemoryBarrierWithGroupSync();
    // Blocks of inlined leaves are short.
    uint before = 0u;
    for (uint b = thread.x; b < blockIndex; b += FASTPOINTS_POINTS_PER_BLOCK)
        before += FastPointsCountOf(FastPointsOpenBlock(node.PositionWord, descriptorWords, b));
    if (before > 0u)
        InterlockedAdd(FastPointsBefore, before);
    GroupMemoryBarrierWithGroupSync();
    FastPointsBlock block = FastPointsOpenBlock(node.PositionWord, descriptorWords, blockIndex);
    // Of the list; without adaptive sizes, SizeNode is the node's first.
    uint listed = node.SizeNode + FastPointsBefore + thread.x;
    uint kept = FastPointsKeptOf(listed);
    if (isThere && thread.x < FastPointsCountOf(block) && FastPointsKeptOf(listed + 1u) != kept)
    {
        GpuCloud cloud = FastPointsGpuCloudAt(_FastPointsCloudsAt + node.Cloud * 160u);
        float3 steps = FastPointsStepsFromAnchor(node, block, thread.x);
        float3 place = node.AnchorView + cloud.StepX * steps.x + cloud.StepY * steps.y + cloud.StepZ * steps.z;
        float3 color = FastPointsColor(node, cloud, blockIndex, thread.x, steps) * FastPointsUnpackColor(node.Tint);
        uint3 bytes = uint3(color * 255.0 + 0.5);
        bool isShown = FastPointsPassesClips(place);
        if (isShown)
            isShown = !FastPointsIsHidden(cloud, node.ClassWord, blockIndex, thread.x);
        FastPointsEffectPoint gathered;
        gathered.Position = place;
        gathered.Color = bytes.x | bytes.y << 8 | bytes.z << 16 | (isShown ? 0xFF000000u : 0u);
        _FastPointsEffectPointsOut[kept] = gathered;
    }
}

#endif
