using System;
using System.IO;

namespace FastPoints.Editor
{
    /// <summary>Where a project and its converted clouds are. What lies in the project is written down relative to it with '/',
    /// so that it is found after the project has moved; anything else by its whole path.</summary>
    public sealed class ProjectPaths
    {
        public const string DefaultClouds = "PointClouds";

        /// <param name="project">The folder that has <c>Assets</c> in it.</param>
        /// <param name="clouds">Place of converted clouds: relative to the project, or a whole path.</param>
        public ProjectPaths(string project, string clouds = DefaultClouds)
        {
            Project = Path.GetFullPath(project).TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
            Clouds = Absolute(clouds);
        }

        public string Project { get; }

        /// <summary>The folder of converted clouds; it may not be there yet.</summary>
        public string Clouds { get; }

        /// <summary>A path as it is written down.</summary>
        public string Stored(string path)
        {
            string full = Absolute(path);
            string begin = Project + Path.DirectorySeparatorChar;
            string stored = full.StartsWith(begin, StringComparison.Ordinal) ? full.Substring(begin.Length) : full;
            return stored.Replace(Path.DirectorySeparatorChar, '/');
        }

        /// <summary>The whole path of what was written down.</summary>
        public string Absolute(string stored) => Path.GetFullPath(Path.Combine(Project, stored));
    }
}
