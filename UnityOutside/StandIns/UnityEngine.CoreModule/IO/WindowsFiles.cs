#if NET
using System.Globalization;
using Microsoft.Win32.SafeHandles;

namespace StandIns.Io;

/// <summary>Windows' rules for names and for files that are open, on Linux: on where FASTPOINTS_FILES is "windows", or where a
/// test asks for it. It asks the system which files this process has open: what reads on them shares everything, but for
/// AsyncReadManager and <see cref="Hold"/>, which share reading alone.</summary>
static class WindowsFiles
{
    const int LongestFile = 259, LongestFolder = 247;
    const int SharingViolation = unchecked((int)0x80070020);
    const int NotEmpty = unchecked((int)0x80070091);
    const int Exists = unchecked((int)0x800700B7);
    const string Deleted = " (deleted)";

    static readonly HashSet<string> s_devices = new HashSet<string>(
        "CON PRN AUX NUL COM1 COM2 COM3 COM4 COM5 COM6 COM7 COM8 COM9 LPT1 LPT2 LPT3 LPT4 LPT5 LPT6 LPT7 LPT8 LPT9".Split(' '),
        StringComparer.OrdinalIgnoreCase);

    static readonly HashSet<int> s_strict = new HashSet<int>(); // Descriptors that share reading alone.

    // Files that were opened to write at any time: asking the system takes a millisecond.
    static readonly HashSet<string> s_written = new HashSet<string>(StringComparer.OrdinalIgnoreCase);

    enum Share
    {
        Reading,
        Everything,
    }

    internal static bool IsOn { get; set; } = Environment.GetEnvironmentVariable("FASTPOINTS_FILES") == "windows";
    internal static long Refused; // Changes that were refused so far.

    internal static void Opened(SafeFileHandle file)
    {
        lock (s_strict)
            s_strict.Add((int)file.DangerousGetHandle());
    }

    internal static void Closing(SafeFileHandle file)
    {
        lock (s_strict)
            s_strict.Remove((int)file.DangerousGetHandle());
    }

    /// <summary>Opens a file as somebody does who lets others read it and no more: a virus scanner.</summary>
    internal static IDisposable Hold(string path)
    {
        var file = File.OpenHandle(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        Opened(file);
        return new Held(file);
    }

    /// <summary>Before a file is opened to read.</summary>
    internal static void CheckRead(string path, bool isStrict)
    {
        if (!IsOn || IsName(path, LongestFile) && !IsPending(path) &&
            !(isStrict && WasWritten(path) && AnyOpen(path, false, out _, true)))
            return;
        throw Refusal(path, SharingViolation);
    }

    /// <summary>Before a file is opened to write, or made.</summary>
    internal static void CheckWrite(string path)
    {
        if (!IsOn)
            return;
        CheckNew(path, LongestFile);
        if (AnyOpen(path, false, out var share) && share == Share.Reading)
            throw Refusal(path, SharingViolation);
        lock (s_written)
            s_written.Add(Path.GetFullPath(path));
    }

    internal static void CheckDelete(string path)
    {
        if (IsOn && AnyOpen(path, false, out var share) && share == Share.Reading)
            throw Refusal(path, SharingViolation);
    }

    internal static void CheckReplace(string from, string to)
    {
        if (!IsOn)
            return;
        CheckDelete(from);
        CheckNew(to, LongestFile);
        CheckDelete(to);
    }

    /// <summary>Before a folder is moved: nothing in it may be open, however it is shared.</summary>
    internal static void CheckMoveFolder(string from, string to)
    {
        if (!IsOn)
            return;
        CheckNew(to, LongestFolder);
        if (Directory.Exists(to))
            throw Refusal(to, Exists);
        if (AnyOpen(from, true, out _))
            throw Denied(from);
    }

    /// <summary>Before a folder is deleted: what is open and shared keeps its name until it is closed.</summary>
    internal static void CheckDeleteFolder(string path)
    {
        if (IsOn && AnyOpen(path, true, out var share))
            throw Refusal(path, share == Share.Reading ? SharingViolation : NotEmpty);
    }

    static bool WasWritten(string path)
    {
        lock (s_written)
            return s_written.Contains(Path.GetFullPath(path));
    }

    static void CheckNew(string path, int longest)
    {
        if (!IsName(path, longest))
            throw Refusal(path, unchecked((int)0x8007007B));
        if (IsPending(path))
            throw Denied(path);
        string folder = Path.GetDirectoryName(Path.GetFullPath(path));
        string name = Path.GetFileName(Path.TrimEndingDirectorySeparator(path));
        if (!Path.Exists(path) && Directory.Exists(folder))
            foreach (string entry in Directory.EnumerateFileSystemEntries(folder))
                if (Path.GetFileName(entry).Equals(name, StringComparison.OrdinalIgnoreCase) && Path.GetFileName(entry) != name)
                    throw Refusal(path, Exists);
    }

    /// <summary>Whether Windows has such a path.</summary>
    internal static bool IsName(string path, int longest)
    {
        string full = Path.GetFullPath(path);
        if (full.Length > longest)
            return false;
        foreach (string name in full.Split('/', StringSplitOptions.RemoveEmptyEntries))
            if (name.AsSpan().IndexOfAny("<>:\"|?*\\") >= 0 || name.Any(c => c < ' ') || name[^1] is '.' or ' ' ||
                s_devices.Contains(name.Split('.')[0].TrimEnd()))
                return false;
        return true;
    }

    static bool IsPending(string path)
    {
        string full = Path.GetFullPath(path);
        if (Path.Exists(full))
            return false;
        foreach (var (_, open) in OpenFiles())
            if (open.Equals(full + Deleted, StringComparison.OrdinalIgnoreCase))
                return true;
        return false;
    }

    static bool AnyOpen(string path, bool isFolder, out Share share, bool writersOnly = false)
    {
        string full = Path.TrimEndingDirectorySeparator(Path.GetFullPath(path));
        bool isOpen = false;
        share = Share.Everything;
        foreach (var (descriptor, open) in OpenFiles())
        {
            // What was replaced lies under another name by now.
            if (!(isFolder ? open.StartsWith(full + "/", StringComparison.OrdinalIgnoreCase) &&
                    !(open.EndsWith(Deleted, StringComparison.Ordinal) && Path.Exists(open[..^Deleted.Length]))
                : open.Equals(full, StringComparison.OrdinalIgnoreCase)))
                continue;
            bool writes = Writes(descriptor);
            if (writersOnly && !writes)
                continue;
            isOpen = true;
            lock (s_strict)
                if (writes || s_strict.Contains(descriptor))
                    share = Share.Reading;
        }
        return isOpen;
    }

    static IEnumerable<(int Descriptor, string Path)> OpenFiles()
    {
        foreach (string entry in Directory.GetFileSystemEntries("/proc/self/fd"))
        {
            string target = null;
            try
            {
                target = File.ResolveLinkTarget(entry, false)?.FullName;
            }
            catch (IOException)
            {
                // It was closed meanwhile.
            }
            if (target != null && target.StartsWith('/'))
                yield return (int.Parse(Path.GetFileName(entry), CultureInfo.InvariantCulture), target);
        }
    }

    static bool Writes(int descriptor)
    {
        try
        {
            foreach (string line in File.ReadLines("/proc/self/fdinfo/" + descriptor.ToString(CultureInfo.InvariantCulture)))
                if (line.StartsWith("flags:", StringComparison.Ordinal))
                    return (Convert.ToInt32(line[6..].Trim(), 8) & 3) != 0;
        }
        catch (IOException)
        {
            // It was closed meanwhile.
        }
        return false;
    }

    static IOException Refusal(string path, int code)
    {
        Interlocked.Increment(ref Refused);
        string reason = code == SharingViolation ? "because it is being used by another process"
            : code == NotEmpty ? "because the directory is not empty" : code == Exists ? "because the name exists already"
            : "because the filename, directory name, or volume label syntax is incorrect";
        return new IOException("The process cannot access the file '" + path + "' " + reason + ".", code);
    }

    static UnauthorizedAccessException Denied(string path)
    {
        Interlocked.Increment(ref Refused);
        return new UnauthorizedAccessException("Access to the path '" + path + "' is denied.");
    }

    sealed class Held(SafeFileHandle file) : IDisposable
    {
        public void Dispose()
        {
            Closing(file);
            file.Dispose();
        }
    }
}
#endif
