using System.Runtime.InteropServices;

namespace FastPoints.Store
{
    /// <summary>One node of the octree. A table is in breadth-first order: a node's children follow one another.</summary>
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    public struct NodeRecord
    {
        public const int SizeBytes = 96;

        /// <summary>The node takes all points of its cube that no node above has.</summary>
        public const byte IsLeaf = 1;

        /// <summary>In the upper levels: the remaining points of a chunk's top node, or of some that were sampled together. It
        /// keeps its distance from the points below and above it, not from those beside it.</summary>
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

        /// <summary>The nearest node above in this table, or -1 if that is the chunk's attach node, or there is none.</summary>
        [FieldOffset(48)] public int Parent;
        [FieldOffset(52)] public int FirstChild;
        [FieldOffset(56)] public int ChildCount;

        /// <summary>Chunk records attached to this node, in hierarchy.bin only.</summary>
        [FieldOffset(60)] public int FirstChunk;
        [FieldOffset(64)] public int ChunkCount;

        /// <summary>Points of this node alone.</summary>
        [FieldOffset(68)] public int PointCount;

        /// <summary>The node whose planes hold the points: itself, or, for a tiny leaf, its parent. Positions count from the
        /// plane node's corner.</summary>
        [FieldOffset(72)] public int PlaneNode;

        /// <summary>The node's blocks in the plane node's planes.</summary>
        [FieldOffset(76)] public int FirstBlock;
        [FieldOffset(80)] public int BlockCount;

        /// <summary>Blocks in this node's planes, including its inlined leaves'; 0 for an inlined leaf.</summary>
        [FieldOffset(84)] public int PlaneBlocks;
        [FieldOffset(88)] public byte SideLog2;

        /// <summary>Edge of the cells, each of which gave one point, for nodes that are not leaves: 2^this grid steps.</summary>
        [FieldOffset(89)] public byte CellLog2;
        [FieldOffset(90)] public byte Flags;
        [FieldOffset(91)] public byte Reserved;

        /// <summary>In the upper levels: nodes with the same number were sampled together and keep their distance from each
        /// other.</summary>
        [FieldOffset(92)] public int SampledWith;

        public GridCube Cube => new GridCube(Corner, SideLog2);

        /// <summary>Leaves have all remaining points, and a chain has points at one position: others keep a distance.</summary>
        public bool HasSpacing => (Flags & IsLeaf) == 0 && SideLog2 > 0;

        /// <summary>Whether offsets are stored as 64-bit columns, as in cubes with a side beyond 2^32.</summary>
        public bool IsWide => SideLog2 > 32;

        /// <summary>See <see cref="MinX"/>: 0 except for wide nodes.</summary>
        public int BoundsShift => IsWide ? SideLog2 - 32 : 0;
    }

    /// <summary>The location of one plane of one node in its file.</summary>
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    public struct PlaneRange
    {
        public const int SizeBytes = 24;

        [FieldOffset(0)] public long OffsetBytes;
        [FieldOffset(8)] public long LengthBytes;
        [FieldOffset(16)] public ulong Hash;
    }

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
