// Packed blocks as they lie on disk and in a bank of the pool: see internals/disk-format.md, "Planes and blocks". A point
// is unpacked alone. Nothing of Unity's is used here.
#ifndef FASTPOINTS_POINT_BLOCKS_INCLUDED
#define FASTPOINTS_POINT_BLOCKS_INCLUDED

#define FASTPOINTS_POINTS_PER_BLOCK 128u

// A bank of the pool.
ByteAddressBuffer _FastPointsBank;

// One block of one plane: the first of its packed words in the bank, widths of its columns and points - 1, and its minima.
struct FastPointsBlock
{
    uint Descriptor;
    uint Packed;
    uint Widths;
};

FastPointsBlock FastPointsOpenBlock(uint planeWord, uint descriptorWords, uint block)
{
    FastPointsBlock opened;
    opened.Descriptor = planeWord + block * descriptorWords;
    uint2 head = _FastPointsBank.Load2(opened.Descriptor * 4u);
    opened.Packed = planeWord + head.x;
    opened.Widths = head.y;
    return opened;
}

uint FastPointsCountOf(FastPointsBlock block)
{
    return (block.Widths >> 24) + 1u;
}

uint FastPointsWidthOf(FastPointsBlock block, uint column)
{
    return block.Widths >> (column * 8u) & 0xFFu;
}

// Words of a column's packed values.
uint FastPointsWordsOf(FastPointsBlock block, uint column)
{
    return FastPointsCountOf(block) * FastPointsWidthOf(block, column) + 31u >> 5;
}

// The offset, of up to 32 bits, of one value from its column's minimum.
// packed: the column's first word.
uint FastPointsOffset(uint packed, uint width, uint index)
{
    uint bit = index * width;
    uint2 words = _FastPointsBank.Load2((packed + (bit >> 5)) * 4u);
    uint shift = bit & 31u;
    // The second word twice: a shift by 32 is none on a GPU.
    uint value = words.x >> shift | (words.y << 1) << (31u - shift);
    return width == 0u ? 0u : value & 0xFFFFFFFFu >> (32u - width);
}

// The same for up to 64 bits: low, high.
uint2 FastPointsWideOffset(uint packed, uint width, uint index)
{
    uint bit = index * width;
    uint3 words = _FastPointsBank.Load3((packed + (bit >> 5)) * 4u);
    uint shift = bit & 31u;
    uint low = words.x >> shift | (words.y << 1) << (31u - shift);
    uint high = words.y >> shift | (words.z << 1) << (31u - shift);
    uint lowWidth = min(width, 32u);
    uint highWidth = width - lowWidth;
    return uint2(lowWidth == 0u ? 0u : low & 0xFFFFFFFFu >> (32u - lowWidth),
        highWidth == 0u ? 0u : high & 0xFFFFFFFFu >> (32u - highWidth));
}

uint2 FastPointsAddWide(uint2 a, uint2 b)
{
    uint low = a.x + b.x;
    return uint2(low, a.y + b.y + (low < a.x ? 1u : 0u));
}

// a - b as a float, rounded once: both are whole numbers.
float FastPointsDifference(uint a, uint b)
{
    return a >= b ? float(a - b) : -float(b - a);
}

float FastPointsWideDifference(uint2 a, uint2 b)
{
    bool isLess = a.y < b.y || (a.y == b.y && a.x < b.x);
    uint2 more = isLess ? b : a;
    uint2 less = isLess ? a : b;
    float high = float(more.y - less.y - (more.x < less.x ? 1u : 0u));
    float difference = high * 4294967296.0 + float(more.x - less.x);
    return isLess ? -difference : difference;
}

#endif
