using System;
using System.IO;
using FastPoints.Store;

namespace FastPoints.Reading
{
    internal static class SourceFolder
    {
        // Names that writers give an index; its contents decide.
        static readonly string[] s_indexNames = { "metadata.json", "cloud.js", "ept.json", StoreFormat.ManifestName };

        public static bool IsIndex(string fileName) => Array.IndexOf(s_indexNames, fileName) >= 0;

        // Null for a folder that has none.
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

    /// <summary>Names a source in the names of files made from it.</summary>
    public static class CloudName
    {
        /// <summary>A file's name without its extension; for an octree its folder's name, whether the path names the folder or
        /// the index in it.</summary>
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
