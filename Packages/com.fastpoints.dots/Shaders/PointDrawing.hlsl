// A point of a block: where it is and what colour it has. An instance is a block; see FastPoints.Drawing.DrawList. Functions
// return at their end only: Direct3D's compiler takes what they return for uninitialized otherwise, and Unity shows its warnings.
#ifndef FASTPOINTS_POINT_DRAWING_INCLUDED
#define FASTPOINTS_POINT_DRAWING_INCLUDED

#include "PointLoading.hlsl"
#include "PointFilters.hlsl"
#if defined(FASTPOINTS_PROGRESSIVE)
#include "ProgressivePoints.hlsl"
#endif
#include "PointLighting.hlsl"
#include "PointSizes.hlsl"

// From places as seen from the eye, along the world's axes, to the clip space of the API: no translation in it.
float4x4 _FastPointsViewProjection;

// Where the eye looks, a unit vector of the world.
float3 _FastPointsForward;

// The eye's place from the one that nodes are seen from, along the world's axes.
float3 _FastPointsEyeOffset;

#if defined(FASTPOINTS_STEREO)
// The same of the right eye: of two instances one is the left eye's, and one this one's.
float4x4 _FastPointsRightViewProjection;
float3 _FastPointsRightForward;
float3 _FastPointsRightEyeOffset;
#endif

// 1: colours are written as light, not as sRGB.
uint _FastPointsIsLinear;

// 1: the view has no perspective.
uint _FastPointsIsOrthographic;

struct FastPointsPoint
{
    // Whether there is a point of that number.
    bool IsThere;
    float4 PositionClip;
    float3 Color;

    // Edge of its square, diameter of its disc, in pixels.
    float SizePx;

    // Along the view's direction, in world units.
    float Depth;

    // Share that is lit, in sevenths.
    uint LitLevel;
#if defined(FASTPOINTS_PROGRESSIVE)
    uint Number;
    bool WasVisible;
#endif
};

// DrawListCloud.StoredNormalsBit.
#define FASTPOINTS_STORED_NORMALS 0x800u

// What a stored normal shows of the world, turned to the viewer, since points have no back; 0 for none. The twin of
// FastPoints.Drawing.OctahedralNormal.
// seen: the point, from the eye or along the view of an orthographic one.
float3 FastPointsNormal(GpuNode node, GpuCloud cloud, uint blockIndex, uint index, float3 seen)
{
    // A plane of two columns: two words and their minima.
    FastPointsBlock block = FastPointsOpenBlock(node.NormalWord, 4u, blockIndex);
    uint2 code = _FastPointsBank.Load2((block.Descriptor + 2u) * 4u);
    code.x += FastPointsOffset(block.Packed, FastPointsWidthOf(block, 0u), index);
    code.y += FastPointsOffset(block.Packed + FastPointsWordsOf(block, 0u), FastPointsWidthOf(block, 1u), index);
    float2 p = (float2(code) - 128.0) / 127.0;
    float z = 1.0 - abs(p.x) - abs(p.y);
    float2 folded = (1.0 - abs(p.yx)) * float2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    p = z < 0.0 ? folded : p;
    float3 normal = cloud.NormalX.xyz * p.x + cloud.NormalY.xyz * p.y + cloud.NormalZ.xyz * z;
    normal *= rsqrt(max(dot(normal, normal), 1e-30));
    normal = dot(normal, seen) > 0.0 ? -normal : normal;
    return code.x + code.y == 0u ? float3(0.0, 0.0, 0.0) : normal;
}

// Which eye an instance is for: 1 for the right one.
uint FastPointsEyeOf(uint instance)
{
#if defined(FASTPOINTS_STEREO)
    return instance & 1u;
#else
    return 0u;
#endif
}

// Where a place is in an eye's clip space, and its depth along the eye's direction.
// seen: from the place that nodes are seen from, along the world's axes.
void FastPointsSeeFrom(uint eye, float3 seen, out float4 clip, out float depth)
{
    float4x4 viewProjection = _FastPointsViewProjection;
    float3 forward = _FastPointsForward, offset = _FastPointsEyeOffset;
#if defined(FASTPOINTS_STEREO)
    if (eye != 0u)
    {
        viewProjection = _FastPointsRightViewProjection;
        forward = _FastPointsRightForward;
        offset = _FastPointsRightEyeOffset;
    }
#endif
    seen -= offset;
    clip = mul(viewProjection, float4(seen, 1.0));
    depth = dot(forward, seen);
}

// The point of a number below 128 of the draw's block of a number.
FastPointsPoint FastPointsLoadPoint(uint instance, uint index)
{
    uint eye = FastPointsEyeOf(instance);
#if defined(FASTPOINTS_STEREO)
    instance >>= 1;
#endif
#if defined(FASTPOINTS_PROGRESSIVE)
    bool wasVisible = FastPointsChoose(instance, index);
#else
    instance += _FastPointsFirstInstance;
#endif
    uint number = _FastPointsLists.Load(_FastPointsNodeOfInstanceAt + instance * 4u);
    GpuNode node = FastPointsGpuNodeAt(_FastPointsNodesAt + number * 96u);
    GpuCloud cloud = FastPointsGpuCloudAt(_FastPointsCloudsAt + node.Cloud * 160u);
    uint blockIndex = instance - node.FirstInstance;
    FastPointsBlock block = FastPointsOpenBlock(node.PositionWord, (node.Bits & 1u) != 0u ? 8u : 5u, blockIndex);
    FastPointsPoint loaded;
    loaded.IsThere = index < FastPointsCountOf(block);
#if defined(FASTPOINTS_FILTERED)
    loaded.IsThere = loaded.IsThere && !FastPointsIsFaded(node, blockIndex * FASTPOINTS_POINTS_PER_BLOCK + index);
#endif
    loaded.PositionClip = float4(0.0, 0.0, 0.0, -1.0);
    loaded.Color = float3(0.0, 0.0, 0.0);
    loaded.SizePx = 0.0;
    loaded.Depth = 0.0;
    loaded.LitLevel = (cloud.ColorSource & FASTPOINTS_STORED_NORMALS) != 0u ? 0u : cloud.ColorSource >> 8;
#if defined(FASTPOINTS_PROGRESSIVE)
    loaded.Number = instance * FASTPOINTS_POINTS_PER_BLOCK + index;
    loaded.WasVisible = wasVisible;
#endif
    if (loaded.IsThere)
    {
        float3 steps = FastPointsStepsFromAnchor(node, block, index);
        float3 seen = node.AnchorView + cloud.StepX * steps.x + cloud.StepY * steps.y + cloud.StepZ * steps.z;
        bool isDrawn = true;
#if defined(FASTPOINTS_CLIPPED)
        isDrawn = FastPointsPassesClips(seen);
#endif
#if defined(FASTPOINTS_FILTERED)
        if (isDrawn)
            isDrawn = !FastPointsIsHidden(cloud, node.ClassWord, blockIndex, index);
#endif
        if (isDrawn)
        {
            FastPointsSeeFrom(eye, seen, loaded.PositionClip, loaded.Depth);
            float gap = 1.0;
#if defined(FASTPOINTS_ADAPTIVE)
            gap = FastPointsGapAt(node.SizeNode, node.AnchorInCube + node.CubesPerStep * steps);
#endif
            loaded.SizePx = FastPointsSizePx(gap, loaded.Depth);
            float3 color = FastPointsColor(node, cloud, blockIndex, index, steps) * FastPointsUnpackColor(node.Tint);
            if ((cloud.ColorSource & FASTPOINTS_STORED_NORMALS) != 0u)
            {
                float3 view = _FastPointsIsOrthographic != 0u ? _FastPointsForward : seen;
                float3 normal = FastPointsNormal(node, cloud, blockIndex, index, view);
                color = FastPointsLit(color, float(cloud.ColorSource >> 8 & 7u) / 7.0, normal, seen - _FastPointsEyeOffset);
            }
            loaded.Color = _FastPointsIsLinear != 0u ? FastPointsLinearFromSrgb(color) : color;
        }
    }
    return loaded;
}

#endif
