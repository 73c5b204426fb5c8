// A point of a block as it is stored: its steps from the node's anchor, and its colour. Functions return at their end only: see
// PointDrawing.hlsl.
#ifndef FASTPOINTS_POINT_LOADING_INCLUDED
#define FASTPOINTS_POINT_LOADING_INCLUDED

#include "PointBlocks.hlsl"
#include "PointValues.hlsl"
#include "Generated/GpuCloud.hlsl"
#include "Generated/GpuNode.hlsl"

// FastPoints.Drawing.ColorSource.
#define FASTPOINTS_COLOR_CHANNELS 0u
#define FASTPOINTS_COLOR_ATTRIBUTE 1u
#define FASTPOINTS_COLOR_WRAPPED 2u
#define FASTPOINTS_COLOR_POSITION 3u

// The first of the draw's blocks.
uint _FastPointsFirstInstance;

float3 FastPointsStepsFromAnchor(GpuNode node, FastPointsBlock block, uint index)
{
    uint packedY = block.Packed + FastPointsWordsOf(block, 0u);
    uint packedZ = packedY + FastPointsWordsOf(block, 1u);
    uint widthX = FastPointsWidthOf(block, 0u), widthY = FastPointsWidthOf(block, 1u), widthZ = FastPointsWidthOf(block, 2u);
    float3 steps;
    if ((node.Bits & 1u) != 0u)
    {
        uint4 minimaXY = _FastPointsBank.Load4((block.Descriptor + 2u) * 4u);
        uint2 minimumZ = _FastPointsBank.Load2((block.Descriptor + 6u) * 4u);
        uint2 x = FastPointsAddWide(minimaXY.xy, FastPointsWideOffset(block.Packed, widthX, index));
        uint2 y = FastPointsAddWide(minimaXY.zw, FastPointsWideOffset(packedY, widthY, index));
        uint2 z = FastPointsAddWide(minimumZ, FastPointsWideOffset(packedZ, widthZ, index));
        steps = float3(FastPointsWideDifference(x, uint2(node.Anchor.x, node.AnchorHigh.x)),
            FastPointsWideDifference(y, uint2(node.Anchor.y, node.AnchorHigh.y)),
            FastPointsWideDifference(z, uint2(node.Anchor.z, node.AnchorHigh.z)));
    }
    else
    {
        uint3 minima = _FastPointsBank.Load3((block.Descriptor + 2u) * 4u);
        steps = float3(FastPointsDifference(minima.x + FastPointsOffset(block.Packed, widthX, index), node.Anchor.x),
            FastPointsDifference(minima.y + FastPointsOffset(packedY, widthY, index), node.Anchor.y),
            FastPointsDifference(minima.z + FastPointsOffset(packedZ, widthZ, index), node.Anchor.z));
    }
    return steps;
}

// The value of one column of the colour plane, in entries of the palette or 255ths of a channel.
float FastPointsColumnValue(GpuCloud cloud, FastPointsBlock block, uint column, uint minimumWord, uint packed, uint index)
{
    uint type = cloud.ColumnTypes >> (column * 8u) & 0xFFu;
    uint width = FastPointsWidthOf(block, column);
    float value;
    if (cloud.Columns >> (8u + column) & 1u)
    {
        uint2 minimum = _FastPointsBank.Load2((block.Descriptor + minimumWord) * 4u);
        value = FastPointsWideValue(FastPointsAddWide(minimum, FastPointsWideOffset(packed, width, index)), type);
    }
    else
    {
        uint minimum = _FastPointsBank.Load((block.Descriptor + minimumWord) * 4u);
        value = FastPointsValue(minimum + FastPointsOffset(packed, width, index), type);
    }
    return value * cloud.Scale[column] + cloud.Bias;
}

float3 FastPointsColor(GpuNode node, GpuCloud cloud, uint blockIndex, uint index, float3 steps)
{
    uint palette = cloud.ColumnTypes >> 24;
    uint source = cloud.ColorSource & 0xFFu;
    float3 color;
    if (source == FASTPOINTS_COLOR_POSITION)
        color = FastPointsLookUp(palette, FastPointsEntry(asfloat(node.ColorWord) + dot(cloud.ValuePerStep, steps)));
    else
    {
        uint columns = cloud.Columns & 0xFFu, wide = cloud.Columns >> 8;
        uint descriptorWords = 2u + columns + countbits(wide);
        FastPointsBlock block = FastPointsOpenBlock(node.ColorWord, descriptorWords, blockIndex);
        float first = FastPointsColumnValue(cloud, block, 0u, 2u, block.Packed, index);
        if (source == FASTPOINTS_COLOR_ATTRIBUTE)
            color = FastPointsLookUp(palette, FastPointsEntry(first));
        else if (source == FASTPOINTS_COLOR_WRAPPED)
            color = FastPointsLookUp(palette, uint(int(floor(first))) & 0xFFu);
        else
        {
            uint packed = block.Packed + FastPointsWordsOf(block, 0u), minimumWord = 3u + (wide & 1u);
            float second = FastPointsColumnValue(cloud, block, 1u, minimumWord, packed, index);
            packed += FastPointsWordsOf(block, 1u);
            minimumWord += 1u + (wide >> 1 & 1u);
            float third = FastPointsColumnValue(cloud, block, 2u, minimumWord, packed, index);
            color = float3(FastPointsEntry(first), FastPointsEntry(second), FastPointsEntry(third)) / 255.0;
        }
    }
    return color;
}

#endif
