// Points that are not drawn: clipped away, of a class that is hidden, or of a node that appears or leaves.
#ifndef FASTPOINTS_POINT_FILTERS_INCLUDED
#define FASTPOINTS_POINT_FILTERS_INCLUDED

#include "PointBlocks.hlsl"
#include "Generated/GpuClipBox.hlsl"
#include "Generated/GpuCloud.hlsl"
#include "Generated/GpuNode.hlsl"

#if defined(FASTPOINTS_CLIPPED)
uint _FastPointsClipBoxCount;

// Boxes that cut take away what is in them; of the others, what is in any is left.
// seen: from the camera, along the world's axes.
bool FastPointsPassesClips(float3 seen)
{
    bool isKept = false, doesAnyKeep = false, isCut = false;
    for (uint i = 0u; i < _FastPointsClipBoxCount; i++)
    {
        GpuClipBox box = FastPointsGpuClipBoxAt(_FastPointsClipBoxesAt + i * 64u);
        float4 place = float4(seen, 1.0);
        float3 inBox = abs(float3(dot(box.RowX, place), dot(box.RowY, place), dot(box.RowZ, place)));
        bool isIn = max(inBox.x, max(inBox.y, inBox.z)) <= 0.5;
        isCut = isCut || (isIn && box.Cuts != 0u);
        isKept = isKept || (isIn && box.Cuts == 0u);
        doesAnyKeep = doesAnyKeep || box.Cuts == 0u;
    }
    return !isCut && (isKept || !doesAnyKeep);
}
#endif

#if defined(FASTPOINTS_FILTERED)
// FastPoints.Drawing.PointFade.
// index: of the point in its node.
bool FastPointsIsFaded(GpuNode node, uint index)
{
    uint hash = (index + (node.Bits >> 14) * 0x9E3779B9u) * 0x85EBCA6Bu;
    hash = (hash ^ hash >> 13) * 0xC2B2AE35u;
    return (hash ^ hash >> 16) >> 20 >= (node.Bits >> 1 & 0x1FFFu);
}

bool FastPointsIsHidden(GpuCloud cloud, uint classWord, uint blockIndex, uint index)
{
    bool isHidden = false;
    if (cloud.ClassDivisor != 0u)
    {
        // A plane of one column: two words and its minimum.
        FastPointsBlock block = FastPointsOpenBlock(classWord, 3u, blockIndex);
        uint minimum = _FastPointsBank.Load((block.Descriptor + 2u) * 4u);
        uint value = minimum + FastPointsOffset(block.Packed, FastPointsWidthOf(block, 0u), index);
        uint number = value * cloud.ClassDivisor & 0xFFu;
        uint4 hidden = number < 128u ? cloud.HiddenLow : cloud.HiddenHigh;
        isHidden = (hidden[number >> 5 & 3u] >> (number & 31u) & 1u) != 0u;
    }
    return isHidden;
}
#endif

#endif
