// Stored numbers as values: order-preserving bits (OrderedBits.cs) back to floats, and from values to colours.
#ifndef FASTPOINTS_POINT_VALUES_INCLUDED
#define FASTPOINTS_POINT_VALUES_INCLUDED

#include "PointColors.hlsl"
#include "PointLists.hlsl"

// FastPoints.AttributeType.
#define FASTPOINTS_UINT8 0u
#define FASTPOINTS_INT8 1u
#define FASTPOINTS_UINT16 2u
#define FASTPOINTS_INT16 3u
#define FASTPOINTS_UINT32 4u
#define FASTPOINTS_INT32 5u
#define FASTPOINTS_UINT64 6u
#define FASTPOINTS_INT64 7u
#define FASTPOINTS_FLOAT32 8u
#define FASTPOINTS_FLOAT64 9u

// A value of up to 32 bits.
float FastPointsValue(uint bits, uint type)
{
    float value = float(bits);
    if (type == FASTPOINTS_INT8)
        value = float(int(bits) - 0x80);
    else if (type == FASTPOINTS_INT16)
        value = float(int(bits) - 0x8000);
    else if (type == FASTPOINTS_INT32)
        value = float(asint(bits ^ 0x80000000u));
    else if (type == FASTPOINTS_FLOAT32)
        value = asfloat(bits & 0x80000000u ? bits ^ 0x80000000u : ~bits);
    return value;
}

// A value of 64 bits: doubles beyond the range of floats become infinities, those too small for it 0.
float FastPointsWideValue(uint2 bits, uint type)
{
    float value;
    if (type == FASTPOINTS_UINT64)
        value = float(bits.y) * 4294967296.0 + float(bits.x);
    else if (type == FASTPOINTS_INT64)
        value = float(asint(bits.y ^ 0x80000000u)) * 4294967296.0 + float(bits.x);
    else
    {
        uint2 word = bits.y & 0x80000000u ? uint2(bits.x, bits.y ^ 0x80000000u) : ~bits;
        int exponent = int(word.y >> 20 & 0x7FFu) - 1023 + 127;
        uint fraction = (word.y & 0xFFFFFu) << 3 | word.x >> 29;
        uint magnitude = exponent <= 0 ? 0u : exponent >= 255 ? 0x7F800000u : uint(exponent) << 23 | fraction;
        value = asfloat(magnitude | (word.y & 0x80000000u));
    }
    return value;
}

// Entry of a palette, or byte of a channel; what is no number is 0.
uint FastPointsEntry(float value)
{
    return value > 0.0 ? uint(min(value, 255.0)) : 0u;
}

// Palettes are tables of 256 sRGB colours, one behind the other: red, green, blue, alpha from the lowest byte.
float3 FastPointsLookUp(uint palette, uint entry)
{
    return FastPointsUnpackColor(_FastPointsLists.Load((palette * 256u + entry) * 4u));
}

#endif
