using System;
using System.Collections.Generic;
using System.IO;
using Unity.Jobs;

namespace FastPoints
{
    /// <summary>What keeps files open between reads. Main thread.</summary>
    internal interface IOpenFiles
    {
        JobHandle OtherReads { get; }

        JobHandle CloseBelow(string folder);
    }

    /// <summary>Folders that are about to be renamed or deleted: streams close their files, and read none until
    /// they are reacquired. Main thread, unless stated otherwise.</summary>
    internal static class FolderReleases
    {
        static readonly List<IOpenFiles> s_openFiles = new List<IOpenFiles>();
        static string[] s_released = Array.Empty<string>(); // Replaced at each change, on any thread.

        static JobHandle s_closing;

        public static void Add(IOpenFiles files) => s_openFiles.Add(files);

        public static void Remove(IOpenFiles files) => s_openFiles.Remove(files);

        public static void Release(string folder)
        {
            string below = Below(folder);
            lock (s_openFiles)
                s_released = new List<string>(s_released) { below }.ToArray();
            // The folder of a read by name is not known: wait for all such reads that are in flight now.
            foreach (var files in s_openFiles)
                s_closing = Combine(Combine(s_closing, files.OtherReads), files.CloseBelow(below));
        }

        /// <summary>Whether reads that were in flight in released folders have ended, and their files are closed.</summary>
        public static bool HasReleased => JobCoroutine.HasEnded(s_closing);

        /// <summary>The folder may be read again. On any thread.</summary>
        public static void Reacquire(string folder)
        {
            lock (s_openFiles)
            {
                var left = new List<string>(s_released);
                left.Remove(Below(folder));
                s_released = left.ToArray();
            }
        }

        public static bool IsReleased(string folder)
        {
            // Called often; it only has a cost while a folder is renamed.
            foreach (string released in s_released)
                if (!SourcePath.IsRemote(folder) && IsBelow(Below(folder), released))
                    return true;
            return false;
        }

        /// <param name="below">A full path with a separator at its end.</param>
        public static bool IsBelow(string path, string below) =>
            Path.GetFullPath(path).StartsWith(below, StringComparison.OrdinalIgnoreCase);

        public static JobHandle Combine(JobHandle a, JobHandle b) => a.IsCompleted ? b : JobHandle.CombineDependencies(a, b);

        static string Below(string folder) =>
            Path.GetFullPath(folder).TrimEnd(Path.DirectorySeparatorChar) + Path.DirectorySeparatorChar;
    }
}
