using System.Runtime.InteropServices;
using FastPoints.Core;

namespace FastPoints.Store
{
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    internal struct FileHeader
    {
        public const int SizeBytes = 80;

        [FieldOffset(0)] public ulong Magic;
        [FieldOffset(8)] public uint Version;

        /// <summary>Number of the chunk; 0 in the other files.</summary>
        [FieldOffset(12)] public int Number;
        [FieldOffset(16)] public int PlaneCount;

        /// <summary>Number of node records in this file's table; 0 in upper.bin, whose table is in hierarchy.bin.</summary>
        [FieldOffset(20)] public int NodeCount;

        /// <summary>Number of chunk records behind them, in hierarchy.bin only.</summary>
        [FieldOffset(24)] public int ChunkCount;
        [FieldOffset(28)] public int Reserved;

        /// <summary>Points in this file; in hierarchy.bin, points of the whole cloud.</summary>
        [FieldOffset(32)] public long PointCount;

        /// <summary>Where the table begins: the node records, each node's plane ranges, then the chunk records.</summary>
        [FieldOffset(40)] public long TableOffset;
        [FieldOffset(48)] public ulong TableHash;
        [FieldOffset(56)] public long FileBytes;

        /// <summary>The same in all files of a cloud and in cloud.json.</summary>
        [FieldOffset(64)] public ulong CloudId;

        /// <summary>Hash of the 72 bytes before it.</summary>
        [FieldOffset(72)] public ulong HeaderHash;
    }
}
