using System;
using System.IO;
using FastPoints.Entities;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>Where a project and its converted clouds are. Paths in the project are stored relative to it with '/', so that
    /// they stay valid when the project moves, and those beside it as well; those below the user's root of sources relative to
    /// that; other paths are stored as absolute.</summary>
    internal sealed class ProjectPaths
    {
        public const string DefaultClouds = "PointClouds";

        readonly string m_sourceRoot;

        /// <summary>Unity scans these folders at every refresh, or deletes what is in them.</summary>
        static readonly string[] s_ownedByUnity =
        {
            "Assets", "Packages", "Library", "Temp", "Logs", "ProjectSettings", "UserSettings",
        };

        /// <param name="clouds">Place of converted clouds: relative to the project, or absolute.</param>
        public ProjectPaths(string project, string clouds = DefaultClouds, string sourceRoot = "")
        {
            m_sourceRoot = sourceRoot;
            Project = Path.GetFullPath(project).TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
            Clouds = Absolute(clouds);
        }

        /// <summary>Why a folder cannot hold converted clouds, in one line; null if it can.</summary>
        /// <param name="folder">A path relative to the project, or absolute.</param>
        public static string FindProblem(string project, string folder)
        {
            if (string.IsNullOrWhiteSpace(folder))
                return "wanted a folder, got nothing";
            string full;
            try
            {
                full = WithSeparator(Path.Combine(project, folder));
            }
            catch (Exception e) when (e is ArgumentException || e is NotSupportedException || e is IOException)
            {
                return "not a path: " + folder;
            }
            if (WithSeparator(project).StartsWith(full, StringComparison.OrdinalIgnoreCase))
                return "wanted a folder of its own, got one with the project in it: " + folder;
            foreach (string taken in s_ownedByUnity)
                if (full.StartsWith(WithSeparator(Path.Combine(project, taken)), StringComparison.OrdinalIgnoreCase))
                    return taken + " is Unity's own: " + folder;
            return null;
        }

        public string Project { get; }

        public string Clouds { get; }

        public string Stored(string path)
        {
            string full = Absolute(path);
            string root = m_sourceRoot.Length == 0 ? null : Below(m_sourceRoot, full);
            return (Below(Project, full) ?? (root == null ? StoredShared(full) : PointCloudPaths.SourcesPrefix + root)).Replace(
                Path.DirectorySeparatorChar, '/');
        }

        /// <summary>The same for shared settings, without the user's own source root.</summary>
        public string StoredShared(string path)
        {
            string full = Absolute(path), parent = Path.GetDirectoryName(Project);
            string sibling = parent == null || Path.GetDirectoryName(parent) == null ? null : Below(parent, full);
            return (Below(Project, full) ?? (sibling == null ? full : "../" + sibling)).Replace(Path.DirectorySeparatorChar, '/');
        }

        /// <returns>Null for a path that is not below the folder. Windows ignores case.</returns>
        static string Below(string folder, string path) =>
            path.StartsWith(WithSeparator(folder), Path.DirectorySeparatorChar == '\\' ? StringComparison.OrdinalIgnoreCase
                : StringComparison.Ordinal) ? path.Substring(WithSeparator(folder).Length) : null;

        /// <summary>As the asset of a file in <c>Assets</c> refers to it: by its number, which outlives a new name.</summary>
        public static string StoredFolderOf(string guid) =>
            PointCloudPaths.ConvertedRootPrefix + guid + StoreFormat.FolderExtension;

        static string WithSeparator(string folder) => Path.GetFullPath(folder).TrimEnd(Path.DirectorySeparatorChar,
            Path.AltDirectorySeparatorChar) + Path.DirectorySeparatorChar;

        public string Absolute(string stored) =>
            Path.GetFullPath(stored.StartsWith(PointCloudPaths.ConvertedRootPrefix, StringComparison.Ordinal)
            ? Path.Combine(Clouds, stored.Substring(PointCloudPaths.ConvertedRootPrefix.Length))
            : m_sourceRoot.Length > 0 && stored.StartsWith(PointCloudPaths.SourcesPrefix, StringComparison.Ordinal)
            ? Path.Combine(m_sourceRoot, stored.Substring(PointCloudPaths.SourcesPrefix.Length))
            : Path.Combine(Project, stored));
    }
}
