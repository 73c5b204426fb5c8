using System.Runtime.InteropServices;
using FastPoints.Base;

namespace FastPoints.Gpu
{
    /// <summary>A node of a <see cref="SizeTree"/> as shaders see it.</summary>
    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    public struct GpuSizeNode
    {
        /// <summary>Bits 0-7: octants with a node of their own, X lowest; bits 8-31: index of the first of these nodes, in the
        /// order of the octants.</summary>
        public uint Children;

        /// <summary>Between points where no deeper node is drawn, in world units.</summary>
        public float Gap;
    }
}
