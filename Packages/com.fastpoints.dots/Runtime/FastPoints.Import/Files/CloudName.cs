using System.IO;

namespace FastPoints.Files
{
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
