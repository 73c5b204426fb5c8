// Which points a progressive picture draws: those that were visible in the last one, then a share of every block's points.
// FastPoints.Rendering.VisiblePoints describes the buffers.
#ifndef FASTPOINTS_PROGRESSIVE_POINTS_INCLUDED
#define FASTPOINTS_PROGRESSIVE_POINTS_INCLUDED

#include "PointBlocks.hlsl"
#include "Generated/GpuNode.hlsl"

// VisiblePoints.HeaderBytes, BankBytes.
#define FASTPOINTS_CHOSEN_HEADER_BYTES 16u
#define FASTPOINTS_CHOSEN_BANK_BYTES 32u

// Phase and share (points of a block that are tried); by bank: first block, blocks, visible points, the first of these;
// numbers of the visible points, bank by bank. A point's number is its block's << 7 | its index there.
ByteAddressBuffer _FastPointsChosen;
uint _FastPointsVisibleAt;

// Of the draw: its place among the banks.
uint _FastPointsBankNumber;

// Of a block as long as it is in memory, so that blocks do not all try the same places first.
uint FastPointsSeedOf(uint block)
{
    uint number = _FastPointsLists.Load(_FastPointsNodeOfInstanceAt + block * 4u);
    GpuNode node = FastPointsGpuNodeAt(_FastPointsNodesAt + number * 96u);
    uint seed = (node.PositionWord + block - node.FirstInstance) * 0x9E3779B1u;
    return seed >> 25;
}

// From a number of 128 points that the draw has threads for, and one of these, to a block and an index in it, which is 128
// where there is no point left. Whether that point was visible in the last picture; else it is one of the block's share: points
// lie along a Morton curve in it, so that reversed bits spread what is tried first evenly.
bool FastPointsChoose(inout uint block, inout uint index)
{
    uint4 bank = _FastPointsChosen.Load4(FASTPOINTS_CHOSEN_HEADER_BYTES + _FastPointsBankNumber * FASTPOINTS_CHOSEN_BANK_BYTES);
    uint2 phaseAndShare = _FastPointsChosen.Load2(0u);
    uint number = block * FASTPOINTS_POINTS_PER_BLOCK + index;
    uint visible = (bank.z + FASTPOINTS_POINTS_PER_BLOCK - 1u) / FASTPOINTS_POINTS_PER_BLOCK * FASTPOINTS_POINTS_PER_BLOCK;
    bool wasVisible = number < bank.z;
    block = bank.x;
    index = FASTPOINTS_POINTS_PER_BLOCK;
    if (wasVisible)
    {
        uint chosen = _FastPointsChosen.Load(_FastPointsVisibleAt + (bank.w + number) * 4u);
        block = chosen / FASTPOINTS_POINTS_PER_BLOCK;
        index = chosen % FASTPOINTS_POINTS_PER_BLOCK;
    }
    else if (number >= visible && (number - visible) / phaseAndShare.y < bank.y)
    {
        block += (number - visible) / phaseAndShare.y;
        index = reversebits(phaseAndShare.x + (number - visible) % phaseAndShare.y) >> 25 ^ FastPointsSeedOf(block);
    }
    return wasVisible;
}

#endif
