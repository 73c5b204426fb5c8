using System;
using System.Globalization;
using System.Runtime.InteropServices;

namespace FastPoints.Store
{
    /// <summary>The names of a converted cloud's files; <c>internals/disk-format.md</c> of the manual has their bytes.</summary>
    public static class StoreFormat
    {
        public const uint Version = 3;
        internal const uint UpgradableVersion = 2;
        public const string FolderExtension = ".fastpoints";

        /// <summary>Suffix of an unfinished folder.</summary>
        public const string UnfinishedSuffix = ".part";

        public const string ManifestName = "cloud.json";
        public const string HierarchyName = "hierarchy.bin";
        internal const string SingleFileName = "cloud.bin"; // Planes and pages, where a cloud is one file but for its texts.

        internal const string SourcesName = "sources.json";
        // What LAS sources have around their points, as a LAS file without points.
        internal const string RecordsName = "records.las";

        // Readable facts of the source, if there is only one.
        internal const string FactsName = "facts.json";
        public const string ChunkFolderName = "chunks";
        public const string UpperFolderName = "upper";
        internal const string HierarchyFolderName = "hierarchy";
        internal const string LayerFolderName = "layers";

        /// <summary>"FPHIERAR", "FPPLANES", "FPPAGE  ": the first eight bytes of files, and of pages, as text.</summary>
        public const ulong HierarchyMagic = 0x5241524549485046UL;
        public const ulong PlanesMagic = 0x53454E414C505046UL;
        public const ulong PageMagic = 0x2020454741505046UL;
        internal const int MaxPageBytes = 1 << 16; // Pages are cut so that they take no more, unless one node has more links.
        internal const int MaxPageBytesToRead = 1 << 26; // What is read of a file that claims more.

        /// <summary>The most points of its own that a node holds; more equal ones make a chain of nodes with one cube.</summary>
        public const int MaxPointsPerNode = 50000;

        /// <summary>The name of a file that belongs to one generation of an unfinished cloud: <c>upper-3.bin</c>.</summary>
        public static string GenerationName(string name, long generation) =>
            name.Replace(".bin", "-" + NumberText.Of(generation) + ".bin");

        /// <summary>A folder's path under its final name.</summary>
        public static string FinishedPath(string path) => path.EndsWith(UnfinishedSuffix, StringComparison.Ordinal)
            ? path.Substring(0, path.Length - UnfinishedSuffix.Length)
            : path;

        /// <summary>Path of a container in the folder: <c>chunks/20_-3_17_0.bin</c> for the cube of side 2^20 at
        /// (-3, 17, 0) sides.</summary>
        internal static string PathOf(in ContainerRecord container)
        {
            if (container.Kind == ContainerKind.SingleFile)
                return SingleFileName;
            int side = container.SideLog2;
            string name = string.Format(CultureInfo.InvariantCulture, "{0}/{1}_{2}_{3}_{4}{5}.bin",
                container.Kind == ContainerKind.Chunk ? ChunkFolderName
                : container.Kind == ContainerKind.Upper ? UpperFolderName : HierarchyFolderName, side, container.Corner.X >> side,
                container.Corner.Y >> side, container.Corner.Z >> side, container.Part > 0 ? PartSuffixOf(container.Part) : "");
            return container.Layer == 0 ? name : LayerFolderName + "/" + NumberText.Of((long)container.Layer) + "/" + name;
        }

        internal static string PartSuffixOf(int part) => "." + NumberText.Of((long)part);
    }

    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    internal struct FileHeader
    {
        public const int SizeBytes = 96;

        [FieldOffset(0)] public ulong Magic;
        [FieldOffset(8)] public uint Version;
        [FieldOffset(12)] public int PlaneCount;
        [FieldOffset(16)] public ContainerRecord Container;
        [FieldOffset(72)] public ulong CloudId;
        [FieldOffset(80)] public long PointCount;
        [FieldOffset(88)] public ulong HeaderHash;
    }
}
