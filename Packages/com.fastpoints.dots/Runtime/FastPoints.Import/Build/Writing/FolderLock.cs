using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading;
using FastPoints.Reading;
using FastPoints.Store;

namespace FastPoints.Build
{
    /// <summary>Keeps others from writing into the same folder, with a file that names its owner. A lock that a crash left is
    /// taken over: on the same machine if the process is gone, on another if the owner has not renewed it for a while.</summary>
    /// <remarks>It does not use the system's file locks, which do not hold between processes on every system and runtime that
    /// Unity runs on (mono/mono#19763). If a runtime cannot tell processes apart, as with IL2CPP, it only keeps others out within
    /// its own process.</remarks>
    internal sealed class FolderLock : IDisposable
    {
        public static readonly TimeSpan RenewAfter = TimeSpan.FromSeconds(20);

        /// <summary>An owner on another machine that has not renewed it for this long counts as gone.</summary>
        public static readonly TimeSpan StaleAfter = TimeSpan.FromMinutes(3);

        /// <summary>An owner that has not completed the file for this long after it made it was killed meanwhile.</summary>
        static readonly TimeSpan s_completeWithin = TimeSpan.FromSeconds(1);

        const string UnknownOwner = "another process";
        const string UnknownId = "0";
        const string GuardSuffix = ".taking";

        /// <summary>If the start times of two processes with the same number differ by more than this, they are not the same:
        /// runtimes report times less far apart.</summary>
        const long BeginToleranceTicks = 10 * TimeSpan.TicksPerSecond;

        /// <summary>Identifies the loaded scripts: one process loads them many times.</summary>
        static readonly string s_load = Guid.NewGuid().ToString("N");

        /// <summary>Containers may share the name of their machine, but neither its processes nor its root.</summary>
        static readonly string s_root = RootDevice();

        readonly string m_path;
        readonly string m_owner;
        DateTime m_renewed;

        FolderLock(string path, string owner) => (m_path, m_owner, m_renewed) = (path, owner, DateTime.UtcNow);

        /// <summary>Whether the lock still belongs to this owner, according to the file.</summary>
        public bool IsHeld
        {
            get
            {
                try
                {
                    return StoreFile.ReadText(m_path) == m_owner;
                }
                catch (PointCloudException e)
                {
                    // A disk that is unreachable for a while does not end the lock.
                    return e.Code != FailureCode.NotFound;
                }
            }
        }

        /// <summary>Takes the lock if it is free.</summary>
        /// <param name="path">Path of the file.</param>
        /// <param name="taken">The lock, or null.</param>
        /// <returns>Who holds it, for people; null if it was taken.</returns>
        /// <exception cref="PointCloudException">The folder cannot be written.</exception>
        public static string TakeOrGetOwner(string path, out FolderLock taken) =>
            TakeOrGetOwner(path, Environment.MachineName, Self(), out taken);

        /// <summary>The same on behalf of another process or machine.</summary>
        /// <param name="process">Its number, and when it began in ticks of UTC.</param>
        public static string TakeOrGetOwner(string path, string machine, (int Id, long Began) process, out FolderLock taken)
        {
            taken = null;
            string owner = Describe(machine, process);
            try
            {
                Directory.CreateDirectory(Path.GetDirectoryName(path));
                if (TryCreate(path, owner))
                {
                    taken = new FolderLock(path, owner);
                    return null;
                }
                string other = StoreFile.ReadText(path);
                for (var watch = Stopwatch.StartNew(); !IsWhole(other, out _, out _, out _) && !IsStale(path, other, machine)
                    && watch.Elapsed < 2 * s_completeWithin; other = StoreFile.ReadText(path))
                    Thread.Sleep(1);
                if (!IsStale(path, other, machine))
                    return Describe(other);
                // The first try may only clear away what a crash left.
                if (!TryReplaceStale(path, machine, owner) && !TryReplaceStale(path, machine, owner))
                    return Describe(StoreFile.ReadText(path));
                taken = new FolderLock(path, owner);
                return null;
            }
            catch (PointCloudException e) when (e.Code == FailureCode.NotFound || e.Code == FailureCode.ReadFailed)
            {
                // It was released in between, or is being written: the next try decides.
                return UnknownOwner;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.WriteFailure(path, e);
            }
        }

        /// <summary>Renews the lock so that others know the owner is alive; at most every <see cref="RenewAfter"/>.</summary>
        /// <returns>Whether the lock still belongs to this owner: false if another one took it, for example after a long
        /// sleep.</returns>
        public bool Renew(DateTime nowUtc)
        {
            if (nowUtc - m_renewed < RenewAfter)
                return true;
            m_renewed = nowUtc;
            if (!IsHeld)
                return false;
            try
            {
                File.SetLastWriteTimeUtc(m_path, nowUtc);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                // IsHeld treats an unreachable file as held, too.
            }
            return true;
        }

        public void Dispose()
        {
            try
            {
                if (StoreFile.ReadText(m_path) == m_owner)
                    FileChanges.Delete(m_path);
            }
            catch (Exception e) when (e is PointCloudException || FileFailures.IsFileFailure(e))
            {
                // The file names this process, which the next owner will find gone.
            }
        }

        /// <summary>This process; zeros if the runtime does not say.</summary>
        public static (int Id, long Began) Self()
        {
            try
            {
                using var process = Process.GetCurrentProcess();
                return (process.Id, process.StartTime.ToUniversalTime().Ticks);
            }
            catch (Exception e) when (IsMissingInRuntime(e))
            {
                return default;
            }
        }

        static bool TryCreate(string path, string owner)
        {
            try
            {
                // Shared: .NET creates a file before it locks it, so that a reader could keep it from its creator.
                using (var writer = new StreamWriter(FileChanges.CreateShared(path)))
                    writer.Write(owner);
                // Who was held up for long enough meanwhile has lost it.
                return StoreFile.ReadText(path) == owner;
            }
            catch (IOException e) when (FileFailures.WriteFailure(path, e).Code == FailureCode.WriteFailed)
            {
                // Another owner has it, or had it a moment ago.
                return false;
            }
        }

        /// <summary>Only one of several that found it stale takes it over: a file beside it locks out the others
        /// meanwhile.</summary>
        static bool TryReplaceStale(string path, string machine, string owner)
        {
            string guard = path + GuardSuffix;
            if (!TryCreate(guard, owner))
            {
                // Left by a crash in this method.
                if (IsStale(guard, StoreFile.ReadText(guard), machine))
                    FileChanges.Delete(guard);
                return false;
            }
            try
            {
                if (!IsStale(path, StoreFile.ReadText(path), machine))
                    return false;
                FileChanges.Delete(path);
                return TryCreate(path, owner);
            }
            finally
            {
                FileChanges.Delete(guard);
            }
        }

        static bool IsWhole(string owner, out string[] lines, out int id, out long began)
        {
            lines = owner.Split('\n');
            id = 0;
            began = 0;
            return lines.Length > 2 && lines[^1].Length == 0
                && int.TryParse(lines[1], NumberStyles.None, CultureInfo.InvariantCulture, out id)
                && long.TryParse(lines[2], NumberStyles.None, CultureInfo.InvariantCulture, out began);
        }

        static bool IsStale(string path, string owner, string machine)
        {
            if (!IsWhole(owner, out string[] lines, out int id, out long began))
                return DateTime.UtcNow - File.GetLastWriteTimeUtc(path) > s_completeWithin;
            bool isSilent = DateTime.UtcNow - File.GetLastWriteTimeUtc(path) > StaleAfter;
            if (lines[0] != machine || lines.Length > 5 && lines[4] != s_root)
                return isSilent;
            var self = Self();
            if (id == 0 || id == self.Id && Math.Abs(began - self.Began) <= BeginToleranceTicks)
                return lines.Length < 4 || lines[3] != s_load;
            try
            {
                using var process = Process.GetProcessById(id);
                return Math.Abs(process.StartTime.ToUniversalTime().Ticks - began) > BeginToleranceTicks;
            }
            catch (Exception e) when (e is ArgumentException || e is InvalidOperationException)
            {
                return true;
            }
            catch (System.ComponentModel.Win32Exception)
            {
                // There is such a process, owned by another user.
                return false;
            }
            catch (Exception e) when (IsMissingInRuntime(e))
            {
                return isSilent;
            }
        }

        static bool IsMissingInRuntime(Exception e) => e is NotSupportedException || e is NotImplementedException;

        static string Describe(string machine, (int Id, long Began) process) => string.Format(CultureInfo.InvariantCulture,
            "{0}\n{1}\n{2}\n{3}\n{4}\n", machine, process.Id, process.Began, s_load, s_root);

        /// <summary>The device that is mounted as root, which Linux tells.</summary>
        static string RootDevice()
        {
            try
            {
                foreach (string line in File.ReadLines("/proc/self/mountinfo"))
                {
                    string[] fields = line.Split(' ');
                    if (fields.Length > 4 && fields[4] == "/")
                        return fields[2];
                }
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                // Another system.
            }
            return "";
        }

        static string Describe(string owner)
        {
            string[] lines = owner.Split('\n');
            return lines.Length < 2 || lines[1] == UnknownId ? UnknownOwner : "process " + lines[1] + " on " + lines[0];
        }
    }
}
