// What a draw reads beside the points: all lists of FastPoints.Drawing.DrawList, in one buffer, since some devices give vertex
// shaders no more than four. Palettes are first.
#ifndef FASTPOINTS_POINT_LISTS_INCLUDED
#define FASTPOINTS_POINT_LISTS_INCLUDED

ByteAddressBuffer _FastPointsLists;

// Where the other lists begin in it, in bytes.
uint _FastPointsNodesAt;
uint _FastPointsCloudsAt;
uint _FastPointsNodeOfInstanceAt;
uint _FastPointsSizeNodesAt;
uint _FastPointsClipBoxesAt;

// Unity's: x is -1 where a texture is drawn into, for APIs whose rows begin at the top, and 1 elsewhere.
float4 _ProjectionParams;

// x: the same of a texture, which matrices are made for; y: 1 where the target may be the screen.
float2 _FastPointsFlip;

// -1 where the target's rows run the other way from those of a texture.
float FastPointsFlip()
{
    return _FastPointsFlip.y != 0.0 ? _ProjectionParams.x * _FastPointsFlip.x : 1.0;
}

#endif
