// What a progressive picture does before its points are drawn (count, plan and list those that were visible in the last one)
// and after: mark those that are visible in it. Nothing is read back.
#ifndef FASTPOINTS_PROGRESSIVE_RASTER_INCLUDED
#define FASTPOINTS_PROGRESSIVE_RASTER_INCLUDED

#define FASTPOINTS_PROGRESSIVE

#include "RasterPoints.hlsl"

#define FASTPOINTS_NONE 0xFFFFFFFFu

// RWByteAddressBuffer of _FastPointsChosen. Behind phase and share: whether the picture before the last one counts, too. Behind
// a bank's four numbers: how many of its points are listed, and how many were visible in the picture before the last one alone.
RWByteAddressBuffer _FastPointsChosenOut;

// Five numbers a bank: a dispatch's groups, or a draw's vertices and instances.
RWStructuredBuffer<uint> _FastPointsArgumentsOut;

// A bit a point: of the last picture, by its blocks, and of this one. 32 bytes a block, half of the picture before it.
ByteAddressBuffer _FastPointsMasks;
RWByteAddressBuffer _FastPointsMasksOut;

// By node: its first block in the last picture's list, or FASTPOINTS_NONE.
uint _FastPointsLastOfNodeAt;

// 0: there is no last picture.
uint _FastPointsCarries;
uint _FastPointsBankCount;

// How many points the list has room for, the picture may draw, and all blocks have.
uint _FastPointsCapacity;
uint _FastPointsPointsPerFrame;
uint _FastPointsListedPoints;

// Of a block's draw; 0: it is dispatched.
uint _FastPointsVerticesPerBlock;

// By pixel of a layer: the number of its point, where the colour's alpha says that there is one.
Texture2D<uint> _FastPointsLayerNumbers;
Texture2D<float4> _FastPointsLayerColor;

uint FastPointsThread(uint3 group, uint3 thread)
{
    return (group.x + group.y * _FastPointsGroupsPerRow) * FASTPOINTS_CLEAR_THREADS + thread.x;
}

uint FastPointsBankAt(uint bank)
{
    return FASTPOINTS_CHOSEN_HEADER_BYTES + bank * FASTPOINTS_CHOSEN_BANK_BYTES;
}

// Of the bank that has a block.
uint FastPointsBankOf(uint block)
{
    uint low = 0u, high = _FastPointsBankCount;
    while (high - low > 1u)
    {
        uint middle = (low + high) / 2u;
        if (_FastPointsChosenOut.Load(FastPointsBankAt(middle)) <= block)
            low = middle;
        else
            high = middle;
    }
    return FastPointsBankAt(low);
}

// The points of a block that were visible in the last picture, those that were only in the one before it: where several points
// share a pixel, another may show in each picture.
void FastPointsCarried(uint block, out uint4 visible, out uint4 wasVisible)
{
    uint node = _FastPointsLists.Load(_FastPointsNodeOfInstanceAt + block * 4u);
    uint last = _FastPointsLists.Load(_FastPointsLastOfNodeAt + node * 4u);
    uint first = FastPointsGpuNodeAt(_FastPointsNodesAt + node * 96u).FirstInstance;
    visible = uint4(0u, 0u, 0u, 0u);
    wasVisible = visible;
    if (_FastPointsCarries != 0u && last != FASTPOINTS_NONE)
    {
        visible = _FastPointsMasks.Load4((last + block - first) * 32u);
        wasVisible = _FastPointsMasks.Load4((last + block - first) * 32u + 16u) & ~visible;
    }
}

uint FastPointsCountOf(uint4 mask)
{
    return countbits(mask.x) + countbits(mask.y) + countbits(mask.z) + countbits(mask.w);
}

[numthreads(FASTPOINTS_CLEAR_THREADS, 1, 1)]
void FastPointsCountVisible(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    uint block = FastPointsThread(group, thread);
    if (block < _FastPointsInstanceCount)
    {
        uint4 visible, wasVisible;
        FastPointsCarried(block, visible, wasVisible);
        _FastPointsMasksOut.Store4(block * 32u, uint4(0u, 0u, 0u, 0u));
        _FastPointsMasksOut.Store4(block * 32u + 16u, visible);
        uint2 counts = uint2(FastPointsCountOf(visible), FastPointsCountOf(wasVisible));
        if (counts.x != 0u)
            _FastPointsChosenOut.InterlockedAdd(FastPointsBankOf(block) + 8u, counts.x);
        if (counts.y != 0u)
            _FastPointsChosenOut.InterlockedAdd(FastPointsBankOf(block) + 20u, counts.y);
    }
}

[numthreads(1, 1, 1)]
void FastPointsPlanFrame()
{
    uint visible = 0u, all = 0u, bank;
    for (bank = 0u; bank < _FastPointsBankCount; bank++)
        all += _FastPointsChosenOut.Load(FastPointsBankAt(bank) + 8u) + _FastPointsChosenOut.Load(FastPointsBankAt(bank) + 20u);
    // A quarter is left for others.
    uint hasBoth = all <= min(_FastPointsCapacity, _FastPointsPointsPerFrame - _FastPointsPointsPerFrame / 4u) ? 1u : 0u;
    _FastPointsChosenOut.Store(8u, hasBoth);
    for (bank = 0u; bank < _FastPointsBankCount; bank++)
    {
        uint count = _FastPointsChosenOut.Load(FastPointsBankAt(bank) + 8u)
            + hasBoth * _FastPointsChosenOut.Load(FastPointsBankAt(bank) + 20u);
        count = min(count, _FastPointsCapacity - visible);
        _FastPointsChosenOut.Store2(FastPointsBankAt(bank) + 8u, uint2(count, visible));
        visible += count;
    }
    float rest = float(_FastPointsPointsPerFrame - min(_FastPointsPointsPerFrame, visible));
    uint share = uint(clamp(rest * FASTPOINTS_POINTS_PER_BLOCK / float(_FastPointsListedPoints), 1.0,
        float(FASTPOINTS_POINTS_PER_BLOCK)));
    uint2 last = _FastPointsChosenOut.Load2(0u);
    _FastPointsChosenOut.Store2(0u, uint2(last.x + last.y, share));
    for (bank = 0u; bank < _FastPointsBankCount; bank++)
    {
        uint2 counts = _FastPointsChosenOut.Load2(FastPointsBankAt(bank) + 4u);
        uint groups = (counts.y + FASTPOINTS_POINTS_PER_BLOCK - 1u) / FASTPOINTS_POINTS_PER_BLOCK
            + (counts.x * share + FASTPOINTS_POINTS_PER_BLOCK - 1u) / FASTPOINTS_POINTS_PER_BLOCK;
        bool isDispatched = _FastPointsVerticesPerBlock == 0u;
        uint across = min(groups, FASTPOINTS_MAX_GROUPS);
        _FastPointsArgumentsOut[bank * 5u] = isDispatched ? across : _FastPointsVerticesPerBlock;
        _FastPointsArgumentsOut[bank * 5u + 1u] = isDispatched ? (groups + across - 1u) / across : groups;
        _FastPointsArgumentsOut[bank * 5u + 2u] = isDispatched ? 1u : 0u;
        _FastPointsArgumentsOut[bank * 5u + 3u] = 0u;
        _FastPointsArgumentsOut[bank * 5u + 4u] = 0u;
    }
}

[numthreads(FASTPOINTS_CLEAR_THREADS, 1, 1)]
void FastPointsListVisible(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    uint block = FastPointsThread(group, thread);
    if (block < _FastPointsInstanceCount)
    {
        uint4 mask, wasVisible;
        FastPointsCarried(block, mask, wasVisible);
        if (_FastPointsChosenOut.Load(8u) != 0u)
            mask |= wasVisible;
        uint count = FastPointsCountOf(mask), bank = FastPointsBankOf(block), at = 0u;
        if (count != 0u)
            _FastPointsChosenOut.InterlockedAdd(bank + 16u, count, at);
        uint2 listed = _FastPointsChosenOut.Load2(bank + 8u);
        for (uint word = 0u; word < 4u; word++)
        {
            uint bits = mask[word];
            while (bits != 0u)
            {
                uint number = block * FASTPOINTS_POINTS_PER_BLOCK + word * 32u + firstbitlow(bits);
                if (at < listed.x)
                    _FastPointsChosenOut.Store(_FastPointsVisibleAt + (listed.y + at) * 4u, number);
                at++;
                bits &= bits - 1u;
            }
        }
    }
}

// Of the points that a pixel shows, the smallest number: one is carried, however many lie in one place.
[numthreads(FASTPOINTS_RASTER_THREADS, 1, 1)]
void FastPointsRasterNumber(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    FastPointsPixel drawn = FastPointsProject(group, thread.x);
    if (drawn.IsSeen && all(_FastPointsPixelsOut.Load2(drawn.Pixel * 8u) == uint2(drawn.Depth, drawn.Color)))
        _FastPointsPixelsOut.InterlockedMin(FastPointsNumberAt(drawn.Pixel), drawn.Number);
}

void FastPointsMark(uint number)
{
    if (number != FASTPOINTS_NONE)
        _FastPointsMasksOut.InterlockedOr(number / 128u * 32u + (number & 127u) / 32u * 4u, 1u << (number & 31u));
}

[numthreads(FASTPOINTS_CLEAR_THREADS, 1, 1)]
void FastPointsMarkPixels(uint3 thread : SV_DispatchThreadID)
{
    if (thread.x < uint(_FastPointsScreenPx.x))
        FastPointsMark(_FastPointsPixelsOut.Load(FastPointsNumberAt(thread.y * uint(_FastPointsScreenPx.x) + thread.x)));
}

[numthreads(FASTPOINTS_CLEAR_THREADS, 1, 1)]
void FastPointsMarkTexels(uint3 thread : SV_DispatchThreadID)
{
    int3 texel = int3(thread.xy, 0);
    if (thread.x < uint(_FastPointsScreenPx.x) && _FastPointsLayerColor.Load(texel).w > 0.0)
        FastPointsMark(_FastPointsLayerNumbers.Load(texel));
}

#endif
