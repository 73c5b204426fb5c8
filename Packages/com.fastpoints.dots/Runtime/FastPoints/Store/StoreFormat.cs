using System;
using System.Globalization;
using System.Runtime.InteropServices;

namespace FastPoints.Store
{
    /// <summary>The names of a converted cloud's files; <c>internals/disk-format.md</c> of the manual has their bytes.</summary>
    public static class StoreFormat
    {
        public const uint Version = 2;
        public const string FolderExtension = ".fastpoints";

        /// <summary>Suffix of an unfinished folder.</summary>
        public const string PartSuffix = ".part";

        public const string ManifestName = "cloud.json";
        public const string HierarchyName = "hierarchy.bin";
        public const string UpperName = "upper.bin";
        // What LAS sources have around their points, as a LAS file without points.
        internal const string RecordsName = "records.las";

        // Readable facts of the source, if there is only one.
        internal const string FactsName = "facts.json";
        public const string ChunkFolderName = "chunks";

        /// <summary>"FPHIERAR", "FPUPPER ", "FPCHUNK ": the first eight bytes of the files as text.</summary>
        public const ulong HierarchyMagic = 0x5241524549485046UL;
        public const ulong UpperMagic = 0x2052455050555046UL;
        public const ulong ChunkMagic = 0x204B4E5548435046UL;

        /// <summary>The most points of its own that a node holds; more equal ones make a chain of nodes with one cube.</summary>
        public const int MaxPointsPerNode = 50000;

        /// <summary>The name of a file that belongs to one generation of an unfinished cloud: <c>upper-3.bin</c>.</summary>
        public static string GenerationName(string name, long generation) =>
            name.Replace(".bin", "-" + NumberText.Of(generation) + ".bin");

        /// <summary>A folder's path under its final name.</summary>
        public static string FinishedPath(string path) => path.EndsWith(PartSuffix, StringComparison.Ordinal)
            ? path.Substring(0, path.Length - PartSuffix.Length)
            : path;

        /// <summary>Path of a chunk's file in the folder.</summary>
        public static string ChunkPath(int number) =>
            ChunkFolderName + "/" + number.ToString("D6", CultureInfo.InvariantCulture) + ".bin";
    }

    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    internal struct FileHeader
    {
        public const int SizeBytes = 80;

        [FieldOffset(0)] public ulong Magic;
        [FieldOffset(8)] public uint Version;
        [FieldOffset(12)] public int Number;
        [FieldOffset(16)] public int PlaneCount;
        [FieldOffset(20)] public int NodeCount;
        [FieldOffset(24)] public int ChunkCount;
        [FieldOffset(28)] public int Reserved;
        [FieldOffset(32)] public long PointCount;
        [FieldOffset(40)] public long TableOffset;
        [FieldOffset(48)] public ulong TableHash;
        [FieldOffset(56)] public long FileBytes;
        [FieldOffset(64)] public ulong CloudId;
        [FieldOffset(72)] public ulong HeaderHash;
    }
}
