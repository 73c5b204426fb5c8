using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.Store;

namespace FastPoints.Reading
{
    internal static class SourceFolder
    {
        static readonly string[] s_indexNames = { "metadata.json", "cloud.js", "ept.json", StoreFormat.ManifestName };

        public static bool IsIndex(string fileName) => Array.IndexOf(s_indexNames, fileName) >= 0;

        /// <summary>Possible tiles below a folder, by name.</summary>
        /// <param name="paths">Receives files and, of folders in it, octrees.</param>
        /// <param name="skipped">Receives the names of folders that are not entered: all, or converted clouds and links.</param>
        public static void List(string folder, bool isRecursive, List<string> paths, List<string> skipped)
        {
            try
            {
                paths.AddRange(Directory.GetFiles(folder));
                foreach (string inner in Directory.GetDirectories(folder))
                {
                    string index = isRecursive ? FindIndex(inner) : null;
                    bool isLink = (File.GetAttributes(inner) & FileAttributes.ReparsePoint) != 0;
                    if (!isRecursive || isLink || index != null && Path.GetFileName(index) == StoreFormat.ManifestName)
                        skipped.Add(Path.GetFileName(inner));
                    else if (index != null)
                        paths.Add(inner);
                    else
                        List(inner, true, paths, skipped);
                }
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.ReadFailure(folder, e);
            }
            paths.Sort(string.CompareOrdinal);
            skipped.Sort(string.CompareOrdinal);
        }

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
            bool isRemote = SourcePath.IsRemote(path);
            string full = isRemote ? path
                : Path.GetFullPath(path).TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
            bool isIndex = SourceFolder.IsIndex(SourcePath.NameOf(full));
            if (isIndex)
                full = SourcePath.FolderOf(full) ?? full;
            string name = SourcePath.NameOf(full);
            if (isRemote ? !isIndex : !Directory.Exists(full))
                name = Path.GetFileNameWithoutExtension(name);
            return name.Length > 0 ? name : "cloud";
        }
    }

    internal static class SourceJson
    {
        public const int MaxBytes = 4 << 20; // Larger texts are not parsed: the objects would take some 50 times the bytes.

        // With or without a byte order mark.
        public static bool Is(byte[] head)
        {
            int at = head.Length >= 3 && head[0] == 0xEF && head[1] == 0xBB && head[2] == 0xBF ? 3 : 0;
            while (at < head.Length && (head[at] == ' ' || head[at] >= 9 && head[at] <= 13))
                at++;
            if (at == head.Length || head[at] != '{')
                return false;
            for (int i = at; i < head.Length; i++)
                if (head[i] == 0)
                    return false;
            return true;
        }

        // Trailing commas are accepted, since such files are edited by hand.
        public static JsonMembers Read(RandomAccessFile source)
        {
            if (source.Length > MaxBytes)
                throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, 0, "bytes of a JSON index",
                    "at most " + MaxBytes, source.Length);
            string text = Encoding.UTF8.GetString(source.ReadUpTo(0, (int)source.Length).Bytes).TrimStart('\uFEFF');
            return JsonMembers.Parse(text, source.Path, true, source.Length);
        }
    }
}
