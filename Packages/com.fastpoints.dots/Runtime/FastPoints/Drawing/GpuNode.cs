using System.Runtime.InteropServices;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // A node as shaders see it for one view. A point's position relative to the camera is that of the anchor, computed in
    // double, plus the steps from the anchor to the point, which are whole numbers. The anchor is the position in the node's
    // box that is nearest to the camera, so the steps never exceed the distance, and the rounding error is at most 2^-22 of the
    // distance, wherever the cloud lies and however large the node is.
    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuNode
    {
        // Grid steps from the node's corner: the lower 32 bits.
        public uint3 Anchor;

        // First word of the position plane in its bank.
        public uint PositionWord;

        // The upper 32 bits: 0 except for wide nodes.
        public uint3 AnchorHigh;
        public uint ColorWord;

        // From the camera to the anchor, along the world's axes.
        public float3 AnchorView;

        // In palette entries, if points are coloured by place.
        public float AnchorValue;

        // Of the node's first block; the others follow.
        public uint FirstInstance;
        public uint Cloud;

        // 1 if positions are 64-bit columns.
        public uint IsWide;

        // Multiplies the points' colours: sRGB, with red, green, blue from the lowest byte.
        public uint Tint;

        // From 0 to 1 along each axis.
        public float3 AnchorInCube;

        // In the SizeTree, if sizes are adaptive.
        public uint SizeNode;

        // One grid step as a fraction of the cube's edge.
        public float3 CubesPerStep;
        public uint ClassWord;
    }
}
