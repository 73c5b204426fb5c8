using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Threading;
using System.Threading.Tasks;

namespace FastPoints.Core
{
    /// <summary>All that replaces, moves or deletes files and folders, and opens files that others may replace meanwhile. Windows
    /// changes nothing that somebody has open, be it a virus scanner for a moment: what is refused is tried again.</summary>
    internal static class FileChanges
    {
        /// <summary>How long what is refused is tried again.</summary>
        public const int RetryTimeoutMs = 10000;

        const int RetryDelayMs = 20;
        const string DeletedSuffix = ".deleted";
        const int DiskFull = unchecked((int)0x80070070);
        const int HandleDiskFull = unchecked((int)0x80070027);

        /// <summary>ENOSPC, of runtimes that pass on the errno.</summary>
        const int NoSpaceErrno = 28;

        static readonly List<Task> s_deletes = new List<Task>();

        /// <summary>Hears of each change before it is made, and may refuse it as the system would: for hosts whose own system
        /// refuses less.</summary>
        internal static Action<FileChange, string, string> Intercept;

        /// <summary>Opens a file to read. Others may write, replace and delete it meanwhile, as far as the system lets
        /// them.</summary>
        public static FileStream OpenToRead(string path, int bufferBytes)
        {
            Intercept?.Invoke(FileChange.Open, path, null);
            return new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferBytes);
        }

        /// <summary>Opens a file to write, which others may read meanwhile unless it is new.</summary>
        public static FileStream OpenToWrite(string path, FileMode mode)
        {
            Intercept?.Invoke(FileChange.Write, path, null);
            return new FileStream(path, mode, FileAccess.Write, mode == FileMode.CreateNew ? FileShare.None : FileShare.Read, 1);
        }

        /// <summary>Gives a file another's name; the other goes, if there is one.</summary>
        public static void Replace(string from, string to)
        {
            Intercept?.Invoke(FileChange.Replace, from, to);
            if (File.Exists(to))
                File.Replace(from, to, null);
            else
                File.Move(from, to);
        }

        /// <summary>Moves a folder to a name that is free.</summary>
        public static void MoveFolder(string from, string to)
        {
            Intercept?.Invoke(FileChange.MoveFolder, from, to);
            Directory.Move(from, to);
        }

        /// <summary>Deletes a file, if it exists.</summary>
        public static void Delete(string path)
        {
            Intercept?.Invoke(FileChange.Delete, path, null);
            File.Delete(path);
        }

        /// <summary>Deletes a folder and what is in it, if it exists.</summary>
        public static void DeleteFolder(string path)
        {
            if (!Directory.Exists(path))
                return;
            Intercept?.Invoke(FileChange.DeleteFolder, path, null);
            Directory.Delete(path, true);
        }

        /// <summary>Deletes a file or a folder whose remains do no harm. It waits like <see cref="Retry"/>.</summary>
        public static void TryDelete(string path, Func<bool> isWanted = null)
        {
            try
            {
                Retry(() =>
                {
                    if (Directory.Exists(path))
                        DeleteFolder(path);
                    else
                        Delete(path);
                }, isWanted);
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                // The next to delete or make something of that name tries again.
            }
        }

        /// <summary>Takes a folder's name from it, at once unless somebody has it open, and deletes it on a thread of the pool,
        /// where thousands of files take their time.</summary>
        /// <param name="moved">Hears, on any thread, that the name is free, or why the folder keeps it.</param>
        public static void BeginDelete(string folder, Action<Exception> moved)
        {
            string renamed = folder + DeletedSuffix;
            for (int number = 2; Directory.Exists(renamed); number++)
                renamed = folder + DeletedSuffix + NumberText.Of(number);
            if (TryMove(folder, renamed, () => false, out _))
            {
                moved(null);
                BeginDeleting(() => DeleteLeftovers(Path.GetDirectoryName(Path.GetFullPath(folder)), Path.GetFileName(folder)));
                return;
            }
            BeginDeleting(() =>
            {
                bool isMoved = TryMove(folder, renamed, null, out var failure);
                moved(failure);
                if (isMoved)
                    DeleteLeftovers(Path.GetDirectoryName(Path.GetFullPath(folder)), Path.GetFileName(folder));
            });
        }

        /// <summary>Deletes, on a thread of the pool, what processes left that ended before they were through.</summary>
        /// <param name="names">Of the folders as they were, with wildcards.</param>
        public static void BeginDeleteLeftovers(string parent, string names) =>
            BeginDeleting(() => DeleteLeftovers(parent, names));

        static void DeleteLeftovers(string parent, string names)
        {
            try
            {
                foreach (string folder in Directory.GetDirectories(parent, names + DeletedSuffix + "*"))
                    TryDelete(folder);
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                // All that was there has gone, or the next to look deletes it.
            }
        }

        static bool TryMove(string from, string to, Func<bool> isWanted, out Exception failure)
        {
            failure = null;
            try
            {
                Retry(() => MoveFolder(from, to), isWanted);
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                failure = e;
            }
            return failure == null;
        }

        /// <summary>Deletes a folder whose remains do no harm, on a thread of the pool.</summary>
        public static void BeginTryDelete(string folder) => BeginDeleting(() => TryDelete(folder));

        static void BeginDeleting(Action delete)
        {
            lock (s_deletes)
            {
                s_deletes.RemoveAll(d => d.IsCompleted);
                s_deletes.Add(Task.Run(delete));
            }
        }

        /// <summary>Waits until all that was begun to be deleted is gone: before a process ends.</summary>
        public static void AwaitDeletes()
        {
            Task[] deletes;
            lock (s_deletes)
                deletes = s_deletes.ToArray();
            Task.WaitAll(deletes);
        }

        /// <summary>Makes a change, and tries again for <see cref="RetryTimeoutMs"/> where it is refused. It waits in between, so
        /// it is not for the main thread of an editor.</summary>
        /// <param name="change">It may be begun again after any of its steps.</param>
        /// <param name="isWanted">Whether to go on trying; null for as long as there is patience.</param>
        public static void Retry(Action change, Func<bool> isWanted = null)
        {
            for (var watch = Stopwatch.StartNew(); ; Thread.Sleep(RetryDelayMs))
            {
                try
                {
                    change();
                    return;
                }
                catch (Exception e) when (IsTransient(e) && watch.ElapsedMilliseconds < RetryTimeoutMs &&
                    (isWanted == null || isWanted()))
                {
                    // Whoever has it open may be done with it soon.
                }
            }
        }

        /// <summary>Whether a change may be possible later: something was refused, and nothing is missing or full.</summary>
        public static bool IsTransient(Exception e) => e is UnauthorizedAccessException || e is IOException &&
            !(e is FileNotFoundException || e is DirectoryNotFoundException || e is PathTooLongException || IsDiskFull(e));

        /// <summary>Whether it says that the disk is full.</summary>
        public static bool IsDiskFull(Exception e) =>
            e.HResult == NoSpaceErrno || e.HResult == DiskFull || e.HResult == HandleDiskFull;
    }

    /// <summary>What is to be done with a file or a folder.</summary>
    internal enum FileChange
    {
        Open,
        Write,
        Replace,
        Delete,
        MoveFolder,
        DeleteFolder,
        /// <summary>None: a folder's disk is asked for its free bytes.</summary>
        Measure,
    }
}
