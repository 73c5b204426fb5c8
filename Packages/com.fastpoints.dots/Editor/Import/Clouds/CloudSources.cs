using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Reading;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>Recognises files and folders as point clouds by their names, and dropped files by headers where names do not
    /// suffice.</summary>
    internal static class CloudSources
    {
        public static readonly string[] ImportedExtensions = { "las", "laz", "ply" };

        const string CopcExtension = ".copc.laz";

        static readonly string[] s_extensions = { ".las", ".laz", ".ply", ".pcd", ".ptx", ".e57" };

        /// <summary>Decides what to do with files that are dropped into a project's assets.</summary>
        /// <param name="paths">Absolute paths of files and folders.</param>
        /// <param name="maxBytes">Of all files together, if they are to be copied.</param>
        public static DropKind DropKindOf(IReadOnlyList<string> paths, ProjectPaths project, long maxBytes)
        {
            if (paths.Count == 0)
                return DropKind.None;
            var kind = DropKind.Copy;
            long bytes = 0;
            foreach (string path in paths)
            {
                string stored = project.Stored(path);
                if (stored.StartsWith("Assets/", StringComparison.Ordinal) ||
                    stored.StartsWith("Packages/", StringComparison.Ordinal) || !IsCloud(path) ||
                    PointFilePrompt.BelongsToOtherImporter("Assets/" + Path.GetFileName(path), path))
                    return DropKind.None;
                bool isImported = File.Exists(path) && HasImportedExtension(path);
                bytes += isImported ? new FileInfo(path).Length : 0;
                if (!isImported || bytes > maxBytes)
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
            // Other formats name a file metadata.json, too.
            return index != null && (Path.GetFileName(index) != "metadata.json" || File.Exists(Path.Combine(path, "octree.bin")));
        }

        /// <summary>Whether files contain an octree, by their names: COPC, Potree, EPT.</summary>
        public static bool HasOctree(string path) => File.Exists(path)
            ? path.EndsWith(CopcExtension, StringComparison.OrdinalIgnoreCase)
            : SourceFolder.FindIndex(path) != null && IsCloud(path);

        public static bool IsConverted(string path) =>
            path.EndsWith(StoreFormat.FolderExtension, StringComparison.OrdinalIgnoreCase) && CloudFolder.IsCloud(path);

        public static bool HasImportedExtension(string path) =>
            Array.IndexOf(ImportedExtensions, Path.GetExtension(path).ToLowerInvariant().TrimStart('.')) >= 0;
    }

    internal enum DropKind
    {
        None, // Left to others: there is something else among the files.
        Copy, // The point clouds are small enough to be copied into the project and imported there.
        Handle, // The files stay where they are, and each gets a handle.
    }
}
