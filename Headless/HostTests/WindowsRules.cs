using System;
using System.Runtime.CompilerServices;
using StandIns.Io;

namespace FastPoints.HostTests;

/// <summary>Has what the package does with files held to Windows' rules, where these are on (FASTPOINTS_FILES=windows).</summary>
static class WindowsRules
{
#pragma warning disable CA2255
    [ModuleInitializer]
#pragma warning restore CA2255
    internal static void Follow() => FileChanges.Intercept = Check;

    internal static IDisposable On()
    {
        var before = new Restored(WindowsFiles.IsOn);
        WindowsFiles.IsOn = true;
        return before;
    }

    /// <summary>Somebody begins to read a file when the first change comes that is meant, and does so until the result is
    /// disposed.</summary>
    internal static IDisposable ReadAt(Func<FileChange, string, string, bool> matches, Func<string, string, string> file)
    {
        var reader = new Reader();
        FileChanges.Intercept = (change, path, to) =>
        {
            if (reader.Held == null && matches(change, path, to))
                reader.Held = WindowsFiles.Hold(file(path, to));
            Check(change, path, to);
        };
        return reader;
    }

    /// <summary>Somebody hears of each change first, and may throw, until the result is disposed.</summary>
    internal static IDisposable Hear(Action<FileChange, string, string> heard)
    {
        FileChanges.Intercept = (change, path, to) =>
        {
            heard(change, path, to);
            Check(change, path, to);
        };
        return new Reader();
    }

    internal static void Check(FileChange change, string path, string to)
    {
        switch (change)
        {
            case FileChange.Open:
                WindowsFiles.CheckRead(path, false);
                break;
            case FileChange.Write:
                WindowsFiles.CheckWrite(path);
                break;
            case FileChange.Replace:
                WindowsFiles.CheckReplace(path, to);
                break;
            case FileChange.Delete:
                WindowsFiles.CheckDelete(path);
                break;
            case FileChange.MoveFolder:
                WindowsFiles.CheckMoveFolder(path, to);
                break;
            case FileChange.DeleteFolder:
                WindowsFiles.CheckDeleteFolder(path);
                break;
            case FileChange.Measure:
                break;
            default:
                throw new ArgumentOutOfRangeException(nameof(change), change, null);
        }
    }

    sealed class Restored(bool isOn) : IDisposable
    {
        public void Dispose()
        {
            WindowsFiles.IsOn = isOn;
            FileChanges.Intercept = Check;
        }
    }

    sealed class Reader : IDisposable
    {
        public IDisposable Held;

        public void Dispose()
        {
            FileChanges.Intercept = Check;
            Held?.Dispose();
        }
    }
}
