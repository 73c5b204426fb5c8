using System.Runtime.InteropServices;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>A node as shaders see it for one view. A point's position relative to the camera is that of the anchor, computed
    /// in double, plus the steps from the anchor to the point, which are whole numbers. The anchor is the position in the node's
    /// box that is nearest to the camera, so the steps never exceed the distance, and the rounding error is at most 2^-22 of the
    /// distance, wherever the cloud lies and however large the node is.</summary>
    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuNode
    {
        /// <summary>Grid steps from the node's corner: the lower 32 bits.</summary>
        public uint3 Anchor;

        /// <summary>First word of the position plane in its bank.</summary>
        public uint PositionWord;

        /// <summary>The upper 32 bits: 0 except for wide nodes.</summary>
        public uint3 AnchorHigh;

        /// <summary>First word in the bank of the plane that points are coloured by.</summary>
        public uint ColorWord;

        /// <summary>Vector from the camera to the anchor, along the world's axes.</summary>
        public float3 AnchorView;

        /// <summary>The anchor's value in palette entries, if points are coloured by place.</summary>
        public float AnchorValue;

        /// <summary>The instance of the node's first block; the others follow.</summary>
        public uint FirstInstance;
        public uint Cloud;

        /// <summary>1 if positions are 64-bit columns.</summary>
        public uint IsWide;

        /// <summary>Multiplies the points' colours: sRGB, with red, green, blue from the lowest byte.</summary>
        public uint Tint;

        /// <summary>Position of the anchor in the node's cube: from 0 to 1 along each axis.</summary>
        public float3 AnchorInCube;

        /// <summary>Index in the <see cref="SizeTree"/>, used if sizes are adaptive.</summary>
        public uint SizeNode;

        /// <summary>One grid step as a fraction of the cube's edge.</summary>
        public float3 CubesPerStep;

        /// <summary>First word in the bank of the plane of classes, used if some are hidden.</summary>
        public uint ClassWord;
    }
}
