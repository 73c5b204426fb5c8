using System;
using System.IO;
using FastPoints.Store;

namespace FastPoints.Files
{
    /// <summary>What kind of point cloud a folder is, by the index file that lies in it.</summary>
    internal static class SourceFolder
    {
        /// <summary>Names under which writers leave an index; what is in it decides.</summary>
        static readonly string[] s_indexNames = { "metadata.json", "cloud.js", "ept.json", StoreFormat.ManifestName };

        /// <summary>Whether a file's name is one of these.</summary>
        public static bool IsIndex(string fileName) => Array.IndexOf(s_indexNames, fileName) >= 0;

        /// <summary>The index of an octree's folder, or null for a folder that has none.</summary>
        public static string FindIndex(string folder)
        {
            foreach (string name in s_indexNames)
            {
                string path = Path.Combine(folder, name);
                if (File.Exists(path))
                    return path;
            }
            return null;
        }
    }

    /// <summary>What a source is called in the names of the files that are made of it.</summary>
    public static class CloudName
    {
        /// <summary>A file's name without its extension; for an octree its folder's name, whether the folder or the index in it
        /// was named.</summary>
        public static string Of(string path)
        {
            string full = Path.GetFullPath(path).TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
            if (SourceFolder.IsIndex(Path.GetFileName(full)))
                full = Path.GetDirectoryName(full) ?? full;
            string name = Directory.Exists(full) ? Path.GetFileName(full) : Path.GetFileNameWithoutExtension(full);
            return name.Length > 0 ? name : "cloud";
        }
    }
}
