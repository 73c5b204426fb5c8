using System.Runtime.InteropServices;
using FastPoints.Base;
using Unity.Mathematics;

namespace FastPoints.Gpu
{
    /// <summary>
    /// A node as shaders see it, for one view. A point's place seen from the camera is that of the anchor, taken in double, plus
    /// the steps from the anchor to the point, which are whole numbers: the anchor is the place in the node's box that is nearest
    /// to the camera, so that the steps are never more than the distance, and what is rounded is 2^-22 of the distance at most,
    /// wherever the cloud lies and however large the node is.
    /// </summary>
    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuNode
    {
        /// <summary>Grid steps from the node's corner: the lower 32 bits.</summary>
        public uint3 Anchor;

        /// <summary>First word of the position plane in its bank.</summary>
        public uint PositionWord;

        /// <summary>The upper 32 bits: 0 but for wide nodes.</summary>
        public uint3 AnchorHigh;

        /// <summary>First word, in the bank, of the plane that points are coloured by.</summary>
        public uint ColorWord;

        /// <summary>The anchor, from the camera, along the world's axes.</summary>
        public float3 AnchorView;

        /// <summary>Where points are coloured by place: the anchor's value, in entries of the palette.</summary>
        public float AnchorValue;

        /// <summary>The instance of the node's first block; the others follow.</summary>
        public uint FirstInstance;
        public uint Cloud;

        /// <summary>1: positions are 64-bit columns.</summary>
        public uint IsWide;

        /// <summary>Multiplies its points' colours: sRGB, red, green, blue from the lowest byte.</summary>
        public uint Tint;

        /// <summary>Place of the anchor in the node's cube: from 0 to 1 along each axis.</summary>
        public float3 AnchorInCube;

        /// <summary>In the <see cref="SizeTree"/>: looked at where sizes are adaptive.</summary>
        public uint SizeNode;

        /// <summary>Edges of the cube in one grid step.</summary>
        public float3 CubesPerStep;

        /// <summary>First word, in the bank, of the plane of classes: looked at where some are hidden.</summary>
        public uint ClassWord;
    }
}
