using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Files;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>Which files and folders are taken for point clouds, by their names alone: nothing is opened while something is
    /// dragged.</summary>
    internal static class CloudSources
    {
        /// <summary>Of files that an importer takes where they lie in a project's assets.</summary>
        public static readonly string[] ImportedExtensions = { "las", "laz", "ply" };

        const string CopcExtension = ".copc.laz";

        static readonly string[] s_extensions = { ".las", ".laz", ".ply", ".e57" };

        /// <summary>What to do with files that are dropped into a project's assets.</summary>
        /// <param name="paths">Whole paths of files and folders.</param>
        /// <param name="mostBytes">Of a file that is copied.</param>
        public static DropKind Of(IReadOnlyList<string> paths, ProjectPaths project, long mostBytes)
        {
            if (paths.Count == 0)
                return DropKind.NotOurs;
            var kind = DropKind.Copy;
            foreach (string path in paths)
            {
                string stored = project.Stored(path);
                if (stored.StartsWith("Assets/", StringComparison.Ordinal) ||
                    stored.StartsWith("Packages/", StringComparison.Ordinal) || !IsCloud(path))
                    return DropKind.NotOurs;
                if (!IsImported(path) || new FileInfo(path).Length > mostBytes)
                    kind = DropKind.Handle;
            }
            return kind;
        }

        /// <summary>A file with a point cloud's extension, a converted cloud, or a folder with an octree's index in it.</summary>
        public static bool IsCloud(string path)
        {
            if (File.Exists(path))
                return Array.IndexOf(s_extensions, Path.GetExtension(path).ToLowerInvariant()) >= 0;
            string index = SourceFolder.FindIndex(path);
            // Others call a file metadata.json too.
            return index != null && (Path.GetFileName(index) != "metadata.json" || File.Exists(Path.Combine(path, "octree.bin")));
        }

        /// <summary>Whether files bring an octree along, by their names: COPC, Potree, EPT.</summary>
        public static bool BringsOctree(string path) => File.Exists(path)
            ? path.EndsWith(CopcExtension, StringComparison.OrdinalIgnoreCase)
            : SourceFolder.FindIndex(path) != null && IsCloud(path);

        /// <summary>A folder that needs no conversion.</summary>
        public static bool IsConverted(string path) =>
            path.EndsWith(StoreFormat.FolderExtension, StringComparison.OrdinalIgnoreCase) && CloudFolder.IsCloud(path);

        static bool IsImported(string path) =>
            File.Exists(path) && HasImportedExtension(path);

        /// <summary>Whether a name ends in one of <see cref="ImportedExtensions"/>.</summary>
        public static bool HasImportedExtension(string path) =>
            Array.IndexOf(ImportedExtensions, Path.GetExtension(path).ToLowerInvariant().TrimStart('.')) >= 0;
    }

    /// <summary>What becomes of files that are dropped.</summary>
    internal enum DropKind
    {
        /// <summary>Others decide: there is something else among them.</summary>
        NotOurs,
        /// <summary>Point clouds that are small enough to be copied into the project and imported there.</summary>
        Copy,
        /// <summary>They stay where they are, and each gets a handle.</summary>
        Handle,
    }
}
