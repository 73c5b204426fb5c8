namespace FastPoints.Cli.Upgrade;

/// <summary>What files of version 2 began with. A private copy, as are all layouts in this folder: nothing else reads them.
/// Records of nodes and the places of planes were those of today's tables.</summary>
[StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
struct OldHeader
{
    public const int SizeBytes = 80;
    public const uint Version = StoreFormat.UpgradableVersion;
    public const ulong HierarchyMagic = 0x5241524549485046UL; // "FPHIERAR", "FPUPPER ", "FPCHUNK ".
    public const ulong UpperMagic = 0x2052455050555046UL;
    public const ulong ChunkMagic = 0x204B4E5548435046UL;

    [FieldOffset(0)] public ulong Magic;
    [FieldOffset(8)] public uint VersionNumber;
    [FieldOffset(12)] public int Number;
    [FieldOffset(16)] public int PlaneCount;
    [FieldOffset(20)] public int NodeCount;
    [FieldOffset(24)] public int ChunkCount;
    [FieldOffset(32)] public long PointCount;
    [FieldOffset(40)] public long TableOffset;
    [FieldOffset(48)] public ulong TableHash;
    [FieldOffset(56)] public long FileBytes;
    [FieldOffset(64)] public ulong CloudId;
    [FieldOffset(72)] public ulong HeaderHash;

    public readonly long NodeBytes => NodeCount * (NodeRecord.SizeBytes + (long)PlaneCount * OldTable.RangeBytes);
}

[StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
struct OldChunk
{
    public const int SizeBytes = 72;

    [FieldOffset(0)] public Grid3 Corner;
    [FieldOffset(24)] public int SideLog2;
    [FieldOffset(28)] public int Number;
    [FieldOffset(32)] public int AttachNode;
    [FieldOffset(36)] public int NodeCount;
    [FieldOffset(40)] public long PointCount;
    [FieldOffset(48)] public long FileBytes;
    [FieldOffset(56)] public long TableOffset;
    [FieldOffset(64)] public ulong TableHash;

    public readonly GridCube Cube => new(Corner, SideLog2);
}
