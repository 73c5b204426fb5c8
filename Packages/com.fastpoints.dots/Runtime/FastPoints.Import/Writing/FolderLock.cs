using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Store;

namespace FastPoints.Writing
{
    /// <summary>
    /// Keeps others from writing into the same folder: a file that names its owner. What a crash left is taken over: on the same
    /// machine when the process is gone, on another when the owner has not renewed it for a while.
    /// </summary>
    /// <remarks>Not the system's own locks on files: these do not hold between processes on every system and runtime that Unity
    /// runs on (mono/mono#19763). Where a runtime cannot tell processes apart, as IL2CPP, it keeps others out in its own process
    /// alone.</remarks>
    internal sealed class FolderLock : IDisposable
    {
        /// <summary>The owner renews it about so often.</summary>
        public static readonly TimeSpan RenewAfter = TimeSpan.FromSeconds(20);

        /// <summary>An owner on another machine that has not renewed it for so long is taken to be gone.</summary>
        public static readonly TimeSpan GoneAfter = TimeSpan.FromMinutes(3);

        const string Somebody = "another process";
        const string NoNumber = "0";
        const string GuardSuffix = ".taking";

        /// <summary>A process that has another one's number began farther away than runtimes differ in what they
        /// say.</summary>
        const long SameBeginTicks = 10 * TimeSpan.TicksPerSecond;

        /// <summary>Of the scripts as they are loaded: one process loads them many times.</summary>
        static readonly string s_load = Guid.NewGuid().ToString("N");

        readonly string m_path;
        readonly string m_owner;
        DateTime m_renewed;

        FolderLock(string path, string owner)
        {
            m_path = path;
            m_owner = owner;
            m_renewed = DateTime.UtcNow;
        }

        /// <summary>Whether the lock is still this owner's, by a look into the file.</summary>
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
                    // A disk that cannot be reached for a while takes it from nobody.
                    return e.Code != FailureCode.NotFound;
                }
            }
        }

        /// <summary>Takes the lock, where nobody has it.</summary>
        /// <param name="path">Of the file.</param>
        /// <param name="taken">The lock, or null.</param>
        /// <returns>Who has it, for people; null where it was taken.</returns>
        /// <exception cref="PointCloudException">The folder cannot be written.</exception>
        public static string TryTake(string path, out FolderLock taken) =>
            TryTake(path, Environment.MachineName, Self(), out taken);

        /// <summary>As for another process or machine.</summary>
        /// <param name="process">Its number, and when it began: ticks of UTC.</param>
        public static string TryTake(string path, string machine, (int Id, long Began) process, out FolderLock taken)
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
                if (!IsGone(path, other, machine))
                    return ForPeople(other);
                if (!TryTakeOver(path, machine, owner))
                    return ForPeople(StoreFile.ReadText(path));
                taken = new FolderLock(path, owner);
                return null;
            }
            catch (PointCloudException e) when (e.Code == FailureCode.NotFound || e.Code == FailureCode.ReadFailed)
            {
                // Given back between two looks, or being written: the next try tells.
                return Somebody;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(path, e);
            }
        }

        /// <summary>Tells others that the owner is there; at most every <see cref="RenewAfter"/>.</summary>
        /// <returns>Whether the lock is still this owner's: false where another one took it, after a long sleep for
        /// example.</returns>
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
                // As where it cannot be read.
            }
            return true;
        }

        /// <summary>Gives it back, where it is still this owner's.</summary>
        public void Dispose()
        {
            try
            {
                if (StoreFile.ReadText(m_path) == m_owner)
                    File.Delete(m_path);
            }
            catch (Exception e) when (e is PointCloudException || FileFailures.IsFileFailure(e))
            {
                // The process is named in it: who comes next finds it gone.
            }
        }

        /// <summary>This process; zeros where the runtime does not say.</summary>
        public static (int Id, long Began) Self()
        {
            try
            {
                using (var process = Process.GetCurrentProcess())
                    return (process.Id, process.StartTime.ToUniversalTime().Ticks);
            }
            catch (Exception e) when (IsOfTheRuntime(e))
            {
                return default;
            }
        }

        static bool TryCreate(string path, string owner)
        {
            try
            {
                using (var file = new FileStream(path, FileMode.CreateNew, FileAccess.Write, FileShare.None))
                using (var writer = new StreamWriter(file))
                    writer.Write(owner);
                return true;
            }
            catch (IOException e) when (FileFailures.Writing(path, e).Code == FailureCode.WriteFailed)
            {
                // Somebody has it, or had it a moment ago.
                return false;
            }
        }

        /// <summary>Only one of several who found it stale takes it over: a file beside it keeps the others off
        /// meanwhile.</summary>
        static bool TryTakeOver(string path, string machine, string owner)
        {
            string guard = path + GuardSuffix;
            if (!TryCreate(guard, owner))
            {
                // Left by a crash in the middle of this.
                if (DateTime.UtcNow - File.GetLastWriteTimeUtc(guard) > RenewAfter)
                    File.Delete(guard);
                return false;
            }
            try
            {
                if (!IsGone(path, StoreFile.ReadText(path), machine))
                    return false;
                File.Delete(path);
                return TryCreate(path, owner);
            }
            finally
            {
                File.Delete(guard);
            }
        }

        static bool IsGone(string path, string owner, string machine)
        {
            string[] lines = owner.Split('\n');
            if (lines.Length < 3 || !int.TryParse(lines[1], NumberStyles.None, CultureInfo.InvariantCulture, out int id) ||
                !long.TryParse(lines[2], NumberStyles.None, CultureInfo.InvariantCulture, out long began))
            {
                // Half written: whoever writes it does so at once.
                return DateTime.UtcNow - File.GetLastWriteTimeUtc(path) > RenewAfter;
            }
            bool isSilent = DateTime.UtcNow - File.GetLastWriteTimeUtc(path) > GoneAfter;
            if (lines[0] != machine)
                return isSilent;
            var self = Self();
            if (id == 0 || id == self.Id && Math.Abs(began - self.Began) <= SameBeginTicks)
                return lines.Length < 4 || lines[3] != s_load;
            try
            {
                using (var process = Process.GetProcessById(id))
                    return Math.Abs(process.StartTime.ToUniversalTime().Ticks - began) > SameBeginTicks;
            }
            catch (Exception e) when (e is ArgumentException || e is InvalidOperationException)
            {
                return true;
            }
            catch (System.ComponentModel.Win32Exception)
            {
                // There is such a process, of another user.
                return false;
            }
            catch (Exception e) when (IsOfTheRuntime(e))
            {
                return isSilent;
            }
        }

        static bool IsOfTheRuntime(Exception e) => e is NotSupportedException || e is NotImplementedException;

        static string Describe(string machine, (int Id, long Began) process) => string.Format(CultureInfo.InvariantCulture,
            "{0}\n{1}\n{2}\n{3}\n", machine, process.Id, process.Began, s_load);

        static string ForPeople(string owner)
        {
            string[] lines = owner.Split('\n');
            return lines.Length < 2 || lines[1] == NoNumber ? Somebody : "process " + lines[1] + " on " + lines[0];
        }
    }
}
