using System.Runtime.InteropServices;
using FastPoints.Base;
using FastPoints.Points;

namespace FastPoints.Store
{
    /// <summary>One node of the octree. A table is in breadth-first order: a node's children follow one another.</summary>
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    public struct NodeRecord
    {
        public const int SizeBytes = 96;

        /// <summary>The node takes all points of its cube that are in no node above.</summary>
        public const byte IsLeaf = 1;

        /// <summary>Upper levels: what they left of the top node of a chunk, or of some that were sampled together. It keeps its
        /// distance from what is below it and above, not from what is beside it.</summary>
        public const byte IsTop = 2;

        /// <summary>Corner of the node's cube: positions are stored as offsets from it.</summary>
        [FieldOffset(0)] public Grid3 Corner;

        /// <summary>Bounds of the node's own points: offsets from the corner, in units of 2^<see cref="BoundsShift"/> grid
        /// steps, rounded down.</summary>
        [FieldOffset(24)] public uint MinX;
        [FieldOffset(28)] public uint MinY;
        [FieldOffset(32)] public uint MinZ;
        [FieldOffset(36)] public uint MaxX;
        [FieldOffset(40)] public uint MaxY;
        [FieldOffset(44)] public uint MaxZ;

        /// <summary>The nearest node above in this table, or -1: then it is the chunk's attach node, or there is none.</summary>
        [FieldOffset(48)] public int Parent;
        [FieldOffset(52)] public int FirstChild;
        [FieldOffset(56)] public int ChildCount;

        /// <summary>Chunk records attached to this node: hierarchy.bin only.</summary>
        [FieldOffset(60)] public int FirstChunk;
        [FieldOffset(64)] public int ChunkCount;

        /// <summary>Points of this node alone.</summary>
        [FieldOffset(68)] public int PointCount;

        /// <summary>The node in whose planes the points lie: itself, or, for a tiny leaf, its parent. The corner that positions
        /// count from is the host's.</summary>
        [FieldOffset(72)] public int Host;

        /// <summary>The node's blocks in the host's planes.</summary>
        [FieldOffset(76)] public int FirstBlock;
        [FieldOffset(80)] public int BlockCount;

        /// <summary>Blocks in this node's planes, its guests' with them; 0 for a guest.</summary>
        [FieldOffset(84)] public int HostedBlocks;
        [FieldOffset(88)] public byte SideLog2;

        /// <summary>Edge of the cells of which each gave one point, for nodes that are no leaves: 2^this grid steps.</summary>
        [FieldOffset(89)] public byte CellLog2;
        [FieldOffset(90)] public byte Flags;
        [FieldOffset(91)] public byte Reserved;

        /// <summary>Upper levels: nodes of one number were sampled together, and keep their distance from each other.</summary>
        [FieldOffset(92)] public int SampledWith;

        public GridCube Cube => new GridCube(Corner, SideLog2);

        /// <summary>Leaves have all that is left, and a chain has points at one place: there is no distance to keep.</summary>
        public bool HasSpacing => (Flags & IsLeaf) == 0 && SideLog2 > 0;

        /// <summary>Offsets in a cube of a side beyond 2^32 are stored as 64-bit columns.</summary>
        public bool IsWide => SideLog2 > 32;

        /// <summary>See <see cref="MinX"/>: 0 but for wide nodes.</summary>
        public int BoundsShift => IsWide ? SideLog2 - 32 : 0;
    }

    /// <summary>Where one plane of one node lies in its file.</summary>
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    public struct PlaneRange
    {
        public const int SizeBytes = 24;

        [FieldOffset(0)] public long OffsetBytes;
        [FieldOffset(8)] public long LengthBytes;
        [FieldOffset(16)] public ulong Hash;
    }
}
