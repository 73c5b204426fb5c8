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
        public const byte LeafFlag = 1;

        /// <summary>In the upper levels: the remaining points of a chunk's top node, or of some that were sampled together. It
        /// keeps its distance from the points below and above it, not from those beside it.</summary>
        public const byte TopFlag = 2;

        [FieldOffset(0)] public Grid3 Corner; // Corner of the node's cube: positions are stored as offsets from it.

        /// <summary>Bounds of the node's own points: offsets from the corner, in units of 2^<see cref="BoundsShift"/> grid
        /// steps, rounded down.</summary>
        [FieldOffset(24)] public uint MinX;
        [FieldOffset(28)] public uint MinY;
        [FieldOffset(32)] public uint MinZ;
        [FieldOffset(36)] public uint MaxX;
        [FieldOffset(40)] public uint MaxY;
        [FieldOffset(44)] public uint MaxZ;

        /// <summary>The nearest node above in this page, or -1 if that is the node that the page is linked from, or there is
        /// none.</summary>
        [FieldOffset(48)] public int Parent;
        [FieldOffset(52)] public int FirstChild;
        [FieldOffset(56)] public int ChildCount;

        [FieldOffset(60)] public int FirstLink; // Links of the page to pages below this node.
        [FieldOffset(64)] public int LinkCount;

        [FieldOffset(68)] public int PointCount; // Points of this node alone.

        /// <summary>The node whose planes hold the points: itself, or, for a tiny leaf, its parent. Positions count from the
        /// plane node's corner.</summary>
        [FieldOffset(72)] public int PlaneNode;

        [FieldOffset(76)] public int FirstBlock; // The node's blocks in the plane node's planes.
        [FieldOffset(80)] public int BlockCount;

        /// <summary>Blocks in this node's planes, including its inlined leaves'; 0 for an inlined leaf.</summary>
        [FieldOffset(84)] public int PlaneBlocks;
        [FieldOffset(88)] public byte SideLog2;

        /// <summary>Edge of the cells, each of which gave one point, for nodes that are not leaves: 2^this grid steps.</summary>
        [FieldOffset(89)] public byte CellLog2;
        [FieldOffset(90)] public byte Flags;
        [FieldOffset(91)] public byte Reserved;

        /// <summary>Nodes of one container with the same number were sampled together and keep their distance from each other.
        /// More than 0 only in upgraded clouds.</summary>
        [FieldOffset(92)] public int SamplingGroup;

        public GridCube Cube => new GridCube(Corner, SideLog2);

        /// <summary>Leaves have all remaining points, and a chain has points at one position: others keep a distance.</summary>
        public bool HasSpacing => (Flags & LeafFlag) == 0 && SideLog2 > 0;

        /// <summary>Whether offsets are stored as 64-bit columns, as in cubes with a side beyond 2^32.</summary>
        public bool IsWide => SideLog2 > 32;

        /// <summary>See <see cref="MinX"/>: 0 except for wide nodes.</summary>
        public int BoundsShift => IsWide ? SideLog2 - 32 : 0;
    }

    /// <summary>The location of one plane of one node in its container.</summary>
    public struct PlaneRange
    {
        public long OffsetBytes;
        public long LengthBytes;
        public ulong Hash;
    }

    // The same in a page: 16 TiB of a container, 256 MiB of a plane.
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    internal struct PackedRange
    {
        public const int SizeBytes = 16;

        const int LengthBits = 24;

        [FieldOffset(0)] public ulong OffsetAndLength;
        [FieldOffset(8)] public ulong Hash;

        public PackedRange(in PlaneRange range)
        {
            OffsetAndLength = (ulong)(range.OffsetBytes / PlaneShape.AlignmentBytes) << LengthBits |
                (ulong)(range.LengthBytes / PlaneShape.AlignmentBytes);
            Hash = range.Hash;
        }

        public PlaneRange Range => new PlaneRange
        {
            OffsetBytes = (long)(OffsetAndLength >> LengthBits) * PlaneShape.AlignmentBytes,
            LengthBytes = (long)(OffsetAndLength & ((1 << LengthBits) - 1)) * PlaneShape.AlignmentBytes,
            Hash = Hash,
        };
    }

    /// <summary>What a page knows of one below it. Links are in the order of the nodes that they hang on.</summary>
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    internal struct PageLink
    {
        public const int SizeBytes = 72;

        [FieldOffset(0)] public Grid3 Corner; // Holds all nodes of the page and below.
        [FieldOffset(24)] public int SideLog2;

        [FieldOffset(28)] public int AttachNode; // The node of this page that is the parent of that page's parentless nodes.

        [FieldOffset(32)] public long SubtreePointCount;
        [FieldOffset(40)] public long SubtreeNodeCount;

        [FieldOffset(48)] public long OffsetBytes;
        [FieldOffset(56)] public int LengthBytes;

        [FieldOffset(60)] public int Container; // Number of the container among this page's; -1 for that of this page itself.
        [FieldOffset(64)] public ulong Hash;

        public GridCube Cube => new GridCube(Corner, SideLog2);
    }

    /// <summary>A file of a cloud, by what is in it: its name follows.</summary>
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    internal struct ContainerRecord
    {
        public const int SizeBytes = 56;

        [FieldOffset(0)] public Grid3 Corner; // The cube of the chunk, or of the upper nodes that were made together.
        [FieldOffset(24)] public int SideLog2;

        /// <summary>Tells containers of one cube apart: parts of more points than a chunk has at one place, and generations of
        /// upper nodes while a cloud is built.</summary>
        [FieldOffset(28)] public int Part;
        [FieldOffset(32)] public ContainerKind Kind;

        /// <summary>0 for what the cloud was built with; planes that were computed later lie in layers of their own.</summary>
        [FieldOffset(34)] public ushort Layer;
        [FieldOffset(36)] public int Reserved;
        [FieldOffset(40)] public long FileBytes;

        [FieldOffset(48)] public ulong Hash; // Of the hashes of all planes in it, in their order.

        public GridCube Cube
        {
            get => new GridCube(Corner, SideLog2);
            set => (Corner, SideLog2) = (value.Corner, value.SideLog2);
        }
    }

    internal enum ContainerKind : ushort
    {
        SingleFile = 0, // All of the cloud but its texts: planes and pages.
        Chunk = 1, // The nodes of one region, but its top node.
        Upper = 2, // Upper nodes that were made together.
        Hierarchy = 3, // Pages alone.
    }

    // The head of a page. Behind it come the containers, by plane the number of its container (4 bytes each, filled up to 8), the
    // nodes, their planes' ranges, the links.
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    internal struct PageHeader
    {
        public const int SizeBytes = 48;

        [FieldOffset(0)] public ulong Magic;
        [FieldOffset(8)] public uint Version;
        [FieldOffset(12)] public int PlaneCount;
        [FieldOffset(16)] public int NodeCount;
        [FieldOffset(20)] public int LinkCount;
        [FieldOffset(24)] public int ContainerCount;
        [FieldOffset(28)] public int Reserved;

        // Of its own nodes.
        [FieldOffset(32)] public long PointCount;
        [FieldOffset(40)] public ulong CloudId;

        public readonly int ContainersOffset => SizeBytes;
        public readonly long PlanesOffset => ContainersOffset + (long)ContainerCount * ContainerRecord.SizeBytes;
        public readonly long NodesOffset => PlanesOffset + (4L * PlaneCount + 7) / 8 * 8;
        public readonly long RangesOffset => NodesOffset + (long)NodeCount * NodeRecord.SizeBytes;
        public readonly long LinksOffset => RangesOffset + (long)NodeCount * PlaneCount * PackedRange.SizeBytes;
        public readonly long LengthBytes => LinksOffset + (long)LinkCount * PageLink.SizeBytes;
    }
}
