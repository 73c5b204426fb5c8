using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Threading;
using System.Threading.Tasks;

namespace FastPoints
{
    // All that replaces, moves or deletes files and folders, and opens files that others may replace meanwhile. Windows changes
    // no open file, not even one that a virus scanner has open for a moment: refused changes are retried.
    internal static class FileChanges
    {
        const int RetryDelayMs = 20;
        const string DeletedSuffix = ".deleted";
        const int DiskFull = unchecked((int)0x80070070);
        const int HandleDiskFull = unchecked((int)0x80070027);
        const int NoSpaceErrno = 28; // ENOSPC, of runtimes that pass on the errno.

        static readonly List<Task> s_deletes = new List<Task>();
        internal static int RetryTimeoutMs = 10000; // Less for tests of what is refused until the end.

        // Called before each change, which it may refuse: for tests on systems that refuse less than Windows.
        internal static Action<FileChange, string, string> Intercept;

        public static FileStream OpenToRead(string path, int bufferBytes)
        {
            Intercept?.Invoke(FileChange.Open, path, null);
            return new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferBytes);
        }

        // Others may read it meanwhile unless it is new.
        public static FileStream OpenToWrite(string path, FileMode mode)
        {
            Intercept?.Invoke(FileChange.Write, path, null);
            return new FileStream(path, mode, FileAccess.Write, mode == FileMode.CreateNew ? FileShare.None : FileShare.Read, 1);
        }

        // A new file that others may read, and delete, while it grows.
        public static FileStream CreateShared(string path)
        {
            Intercept?.Invoke(FileChange.Write, path, null);
            return new FileStream(path, FileMode.CreateNew, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete);
        }

        public static void Replace(string from, string to)
        {
            Intercept?.Invoke(FileChange.Replace, from, to);
            if (File.Exists(to))
                File.Replace(from, to, null);
            else
                File.Move(from, to);
        }

        public static void MoveFolder(string from, string to)
        {
            Intercept?.Invoke(FileChange.MoveFolder, from, to);
            Directory.Move(from, to);
        }

        public static void Delete(string path)
        {
            Intercept?.Invoke(FileChange.Delete, path, null);
            File.Delete(path);
        }

        public static void DeleteFolder(string path)
        {
            if (!Directory.Exists(path))
                return;
            Intercept?.Invoke(FileChange.DeleteFolder, path, null);
            Directory.Delete(path, true);
        }

        // What remains is harmless. It waits like Retry.
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
                // The next deletion or creation of that name retries.
            }
        }

        // Renames a folder, at once unless it is open, and deletes it on a pool thread, since thousands of files take
        // long. Calls moved on any thread when the name is free, or with the reason why not.
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

        // Finishes deletions of processes that ended too early. The names have wildcards.
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
                // It has gone, or the next clean-up deletes it.
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

        static void BeginDeleting(Action delete)
        {
            lock (s_deletes)
            {
                s_deletes.RemoveAll(d => d.IsCompleted);
                s_deletes.Add(Task.Run(delete));
            }
        }

        public static void AwaitDeletes()
        {
            Task[] deletes;
            lock (s_deletes)
                deletes = s_deletes.ToArray();
            Task.WaitAll(deletes);
        }

        // Tries again for RetryTimeoutMs where a change is refused, as long as it is wanted; any step of it may be repeated. It
        // waits in between: not for an editor's main thread.
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
                    // The process that has it open may close it soon.
                }
            }
        }

        // Something was refused, and nothing is missing or full.
        public static bool IsTransient(Exception e) => e is UnauthorizedAccessException || e is IOException &&
            !(e is FileNotFoundException || e is DirectoryNotFoundException || e is PathTooLongException || IsDiskFull(e));

        public static bool IsDiskFull(Exception e) =>
            e.HResult == NoSpaceErrno || e.HResult == DiskFull || e.HResult == HandleDiskFull;
    }

    internal enum FileChange
    {
        Open,
        Write,
        Replace,
        Delete,
        MoveFolder,
        DeleteFolder,
        Measure, // None: queries the free bytes of a folder's disk.
    }
}
