using System.Runtime.InteropServices;
using FastPoints.Points;

namespace FastPoints.Store
{
    /// <summary>
    /// What a converted cloud is on disk: the folder's names, and the records of its binary files, little-endian. No I/O.
    /// The byte tables are in <c>Documentation~/disk-format.md</c>.
    /// </summary>
    public static class StoreFormat
    {
        public const uint Version = 1;
        public const string FolderExtension = ".fastpoints";

        /// <summary>A folder in the making has this after its name.</summary>
        public const string PartSuffix = ".part";

        public const string ManifestName = "cloud.json";
        public const string HierarchyName = "hierarchy.bin";
        public const string UpperName = "upper.bin";
        public const string ChunkFolderName = "chunks";

        /// <summary>"FPHIERAR", "FPUPPER ", "FPCHUNK " as their first eight bytes read.</summary>
        public const ulong HierarchyMagic = 0x5241524549485046UL;
        public const ulong UpperMagic = 0x2052455050555046UL;
        public const ulong ChunkMagic = 0x204B4E5548435046UL;

        /// <summary>A node holds at most so many points of its own; more equal ones make a chain of nodes at one cube.</summary>
        public const int MaxPointsPerNode = 50000;

        /// <summary>Path of a chunk's file in the folder.</summary>
        public static string ChunkPath(int number) =>
            ChunkFolderName + "/" + number.ToString("D6", System.Globalization.CultureInfo.InvariantCulture) + ".bin";
    }

    /// <summary>The first bytes of each binary file.</summary>
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    public struct FileHeader
    {
        public const int SizeBytes = 80;

        [FieldOffset(0)] public ulong Magic;
        [FieldOffset(8)] public uint Version;

        /// <summary>Number of the chunk; 0 in the other files.</summary>
        [FieldOffset(12)] public int Number;
        [FieldOffset(16)] public int PlaneCount;

        /// <summary>Node records in this file's table; in upper.bin, whose table is in hierarchy.bin, 0.</summary>
        [FieldOffset(20)] public int NodeCount;

        /// <summary>Chunk records after them: hierarchy.bin only.</summary>
        [FieldOffset(24)] public int ChunkCount;
        [FieldOffset(28)] public int Reserved;

        /// <summary>Points in this file; in hierarchy.bin, in the whole cloud.</summary>
        [FieldOffset(32)] public long PointCount;

        /// <summary>Where the table begins: the node records, each node's plane ranges, then the chunk records.</summary>
        [FieldOffset(40)] public long TableOffset;
        [FieldOffset(48)] public ulong TableHash;
        [FieldOffset(56)] public long FileBytes;

        /// <summary>The same in all files of a cloud and in cloud.json.</summary>
        [FieldOffset(64)] public ulong CloudId;

        /// <summary>Of the 72 bytes before.</summary>
        [FieldOffset(72)] public ulong HeaderHash;
    }

    /// <summary>One node of the octree. A table is in breadth-first order: a node's children follow one another.</summary>
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    public struct NodeRecord
    {
        public const int SizeBytes = 96;

        /// <summary>The node takes all points of its cube that are in no node above.</summary>
        public const byte IsLeaf = 1;

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
        [FieldOffset(92)] public int Reserved2;

        public GridCube Cube => new GridCube(Corner, SideLog2);

        /// <summary>Offsets in a cube of a side beyond 2^32 are stored as 64-bit columns.</summary>
        public bool IsWide => SideLog2 > 32;

        /// <summary>See <see cref="MinX"/>: 0 but for wide nodes.</summary>
        public int BoundsShift => IsWide ? SideLog2 - 32 : 0;
    }

    /// <summary>Where one plane of one node lies in its file.</summary>
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    public struct PlaneRange
    {
        public const int SizeBytes = 24;

        [FieldOffset(0)] public long OffsetBytes;
        [FieldOffset(8)] public long LengthBytes;
        [FieldOffset(16)] public ulong Hash;
    }

    /// <summary>What hierarchy.bin knows of one chunk. In the order of the nodes they are attached to.</summary>
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
