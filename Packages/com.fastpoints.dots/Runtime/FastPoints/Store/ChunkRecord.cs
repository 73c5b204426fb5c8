using System.Runtime.InteropServices;
using FastPoints.Core;

namespace FastPoints.Store
{
    /// <summary>What hierarchy.bin knows of one chunk. Records are in the order of the nodes that they are attached to.</summary>
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    public struct ChunkRecord
    {
        public const int SizeBytes = 72;

        /// <summary>The chunk's cube: all its nodes lie inside.</summary>
        [FieldOffset(0)] public Grid3 Corner;
        [FieldOffset(24)] public int SideLog2;

        /// <summary>Number of the file.</summary>
        [FieldOffset(28)] public int Number;

        /// <summary>The upper node that is the parent of the chunk's parentless nodes.</summary>
        [FieldOffset(32)] public int AttachNode;
        [FieldOffset(36)] public int NodeCount;
        [FieldOffset(40)] public long PointCount;
        [FieldOffset(48)] public long FileBytes;
        [FieldOffset(56)] public long TableOffset;
        [FieldOffset(64)] public ulong TableHash;

        public GridCube Cube => new GridCube(Corner, SideLog2);
    }
}
