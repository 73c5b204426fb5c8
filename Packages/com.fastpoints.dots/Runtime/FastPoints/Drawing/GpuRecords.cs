using System.Runtime.InteropServices;
using FastPoints.Streaming;
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
        public uint3 Anchor; // Grid steps from the node's corner: the lower 32 bits.
        public uint PositionWord; // First word of the position plane in its bank.
        public uint3 AnchorHigh; // The upper 32 bits: 0 except for wide nodes.
        public uint ColorWord; // If points are coloured by position: the bits of the anchor's place in palette entries.
        public float3 AnchorView; // From the camera to the anchor, along the world's axes.
        public uint NormalWord;
        public uint FirstInstance; // Of the node's first block; the others follow.
        public uint Cloud;
        public uint Bits; // Bit 0: positions are 64-bit columns; bits 1-13 and 14-31: threshold and seed of PointFade.

        // Multiplies the points' colours: sRGB, with red, green, blue from the lowest byte.
        public uint Tint;
        public float3 AnchorInCube; // From 0 to 1 along each axis.
        public uint SizeNode; // In the SizeTree; if no size is adaptive, the number of its first point in the list.
        public float3 CubesPerStep; // One grid step as a fraction of the cube's edge.
        public uint ClassWord;
    }

    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuCloud
    {
        public float3 StepX; // World vector of one grid step along the cloud's X.
        public uint ColorSource; // Bits 0-7; bits 8-10: PointLighting.LitLevelOf; bit 11: lit by stored normals.
        public float3 StepY;

        // Types of the colour plane's columns: bits 0-7, 8-15, 16-23; bits 24-31: number of the palette.
        public uint ColumnTypes;
        public float3 StepZ;
        public uint Columns; // Bits 0-7: columns of the colour plane; bit 8 + c: column c is of 64 bits.
        public float3 ValuePerStep; // Palette entries for one grid step.
        public float Bias; // Added to the product of a value and its column's scale.

        // For each column of the colour plane: palette entries, or 255ths of a channel, for one stored unit.
        public float3 Scale;
        public uint ClassDivisor; // Multiplies stored units to give classes.
        public uint4 HiddenLow; // The ClassMask of points that are not drawn.
        public uint4 HiddenHigh;
        public float4 NormalX; // World vector of a normal's X, Y, Z, of one length.
        public float4 NormalY;
        public float4 NormalZ;
    }

    // A clip box for one view: the dot product of a row's x, y, z with the vector from the camera, plus its w, is a coordinate
    // in the box, from -0.5 to 0.5.
    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuClipBox
    {
        public float4 RowX;
        public float4 RowY;
        public float4 RowZ;

        public uint3 Reserved;
        public uint Cuts; // 1 if the box removes what lies inside it.

        public GpuClipBox(in ClipBox box, double3 eyeWorld)
        {
            var rows = math.transpose(math.inverse(box.EdgesWorld));
            var eye = eyeWorld - box.CenterWorld;
            RowX = (float4)new double4(rows.c0, math.dot(rows.c0, eye));
            RowY = (float4)new double4(rows.c1, math.dot(rows.c1, eye));
            RowZ = (float4)new double4(rows.c2, math.dot(rows.c2, eye));
            Cuts = box.Cuts ? 1u : 0u;
            Reserved = default;
        }
    }
}
